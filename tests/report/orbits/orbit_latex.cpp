// An orbit printed for a paper is read back as a reader would, and evaluated.
#include "numeric/families/family.hpp"
#include "report/orbits/object_values.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "proofs/methods/motions.hpp"
#include "proofs/pascal2012/examples/examples.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::proofs::pascal2012;

namespace {

// x_1 or x_2 of a phase and its derivative at s.
struct Printed {
  std::string terms;

  [[nodiscard]] std::array<double, 2> at(double s, const std::map<std::string, double>& known) const {
    static const std::regex term(
        R"(([+-]?)\s*([0-9.]+)(?:\\cdot 10\^\{(-?[0-9]+)\})?(s|\\cos |\\sin )?(\\omega(?:_[12])?)?)");
    std::array<double, 2> sum{0, 0};
    // A factor 1 is not printed.
    const std::string all = std::regex_replace(terms, std::regex(R"(([+-]) (?=s|\\cos|\\sin))"), "$1 1");
    for (std::sregex_iterator i(all.begin(), all.end(), term), end; i != end; ++i) {
      const std::smatch& m = *i;
      const double a =
          (m[1] == "-" ? -1 : 1) * std::stod(m[2]) * std::pow(10, m[3].matched ? std::stoi(m[3]) : 0);
      const double nu = m[5].matched ? known.at(m[5]) : 1;
      if (m[4] == "\\cos ") {
        sum[0] += a * std::cos(nu * s);
        sum[1] -= a * nu * std::sin(nu * s);
      } else if (m[4] == "\\sin ") {
        sum[0] += a * std::sin(nu * s);
        sum[1] += a * nu * std::cos(nu * s);
      } else if (m[4] == "s") {
        sum[0] += a * s;
        sum[1] += a;
      } else {
        sum[0] += a;
      }
    }
    return sum;
  }
};

std::map<std::string, double> known_values(const std::string& text) {
  static const std::regex value(R"(\$([^$=]+) = (-?[0-9.]+)\$)");
  std::map<std::string, double> known;
  for (std::sregex_iterator i(text.begin(), text.end(), value), end; i != end; ++i) {
    known[(*i)[1]] = std::stod((*i)[2]);
  }
  return known;
}

// x_1 and x_2 of each phase.
std::vector<std::array<Printed, 2>> printed_phases(const std::string& text) {
  static const std::regex both(R"(x_1 =\{\}&([^=]*)\\\\\nx_2 =\{\}&([^=]*)\\end\{align\*\})");
  std::vector<std::array<Printed, 2>> phases;
  for (std::sregex_iterator i(text.begin(), text.end(), both), end; i != end; ++i) {
    const auto bare = [](const std::string& terms) {
      return std::regex_replace(terms, std::regex(R"(\\\\|&\{\}|\n)"), "");
    };
    phases.push_back({Printed{bare((*i)[1])}, Printed{bare((*i)[2])}});
  }
  return phases;
}

}  // namespace

TEST_CASE("the printed closed forms go on from phase to phase, and come back after a period") {
  for (const auto& example : printed_examples()) {
    const OrbitList& list = proofs::methods::orbits_of(example).list;
    for (std::size_t k = 0; k < list.orbits.size(); ++k) {
      const std::string text = report::orbits::orbit_latex(list, k, 12);
      CAPTURE(text);
      const std::map<std::string, double> known = known_values(text);
      const auto phases = printed_phases(text);
      REQUIRE(phases.size() == example.family->phases.size());
      const std::map<std::string, std::string> names{{"tau", "\\tau"}, {"tau1", "\\tau_1"}, {"T", "T"}};
      for (std::size_t phase = 0; phase < phases.size(); ++phase) {
        const double lasts = known.at(names.at(example.family->durations[phase]));
        const auto& next = phases[(phase + 1) % phases.size()];
        for (std::size_t i = 0; i < 2; ++i) {
          const std::array<double, 2> end = phases[phase][i].at(lasts, known), begin = next[i].at(0, known);
          CHECK(end[0] == doctest::Approx(begin[0]).epsilon(1e-9));
          CHECK(end[1] == doctest::Approx(begin[1]).epsilon(1e-9));
        }
        CHECK(phases[phase][1].at(lasts, known)[1] == doctest::Approx(known.at("V")).epsilon(1e-9));
      }
      CHECK(phases[0][0].at(0, known)[0] == doctest::Approx(known.at("x_{10}")).epsilon(1e-9));
    }
  }
}
