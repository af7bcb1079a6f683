#include "report/orbits/neighbourhood.hpp"

#include <fmt/format.h>

#include "numeric/zeros/linear_solve.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/orbits/record_json.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using numeric::machines::Neighbourhood;
using namespace tools;

std::vector<Coordinate> coordinates_in(const Units& units) {
  static constexpr std::array names{"x1", "x2", "x1'", "x2'"};
  const model::Vector4<double> factors = units.state(model::Vector4<double>::Ones());
  std::vector<Coordinate> coordinates;
  for (int k = 0; k < 4; ++k) {
    coordinates.push_back({names[static_cast<std::size_t>(k)], units.unit(k < 2 ? "m" : "m/s"), factors(k)});
  }
  return coordinates;
}

std::string neighbourhood_in_words(const Neighbourhood& n, const std::vector<Coordinate>& coordinates) {
  if (n.verdict.truth != Truth::proved) {
    return "undecided: " + n.verdict.reason;
  }
  std::string text;
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const double off = n.alone(static_cast<Eigen::Index>(k)) * coordinates[k].factor;
    if (off > 0) {
      text += fmt::format("{}{} by {}{}", text.empty() ? "" : ", or ", coordinates[k].name, below(off, 3),
                          coordinates[k].unit.empty() ? "" : " " + coordinates[k].unit);
    }
  }
  return fmt::format(
      "proved: {}, from where the orbit is, if off by at most so much: {}",
      n.before ? fmt::format("where a {} ends in a {}", to_string(n.before->kind), to_string(n.piece.kind))
               : fmt::format("at load phase {:.6g}", n.theta),
      text);
}

std::vector<Row> neighbourhood_rows(const Neighbourhood& n, const std::vector<Coordinate>& coordinates) {
  if (n.verdict.truth != Truth::proved) {
    return {{{"  neighbourhood"}, {"undecided: " + n.verdict.reason}}};
  }
  const std::string where =
      n.before ? fmt::format("  where a {} ends in a {}", to_string(n.before->kind), to_string(n.piece.kind))
               : fmt::format("  at load phase {:.6g}", n.theta);
  std::vector<Row> rows{{{where}, {"the orbit"}, {"recovers if off by"}, {"half width of all"}}};
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const auto shown = [&](double x) {
      return x == 0 ? std::string("-") : below(x * coordinates[k].factor, 3);
    };
    rows.push_back(
        {{"  " + coordinates[k].name + (coordinates[k].unit.empty() ? "" : " in " + coordinates[k].unit)},
         {fmt::format("{:.8g}", n.centre(i).approximate() * coordinates[k].factor)},
         {shown(n.alone(i))},
         {shown(n.half_widths(i))}});
  }
  return rows;
}

std::string meaning_of_neighbourhood() {
  return "proved: a motion that starts there on the orbit, but for one number that is off by at most so "
         "much, "
         "converges to the orbit; and so do all from an ellipsoid of these half widths";
}

void write_neighbourhood(Object& json, const std::shared_ptr<const Neighbourhood>& neighbourhood) {
  json.object_if(
      "neighbourhood", neighbourhood ? std::optional(*neighbourhood) : std::nullopt,
      [](Object& to, const Neighbourhood& n) {
        to.has("verdict", n.verdict.truth);
        to.has("reason", if_any(n.verdict.reason));
        to.keys_if(
            n.verdict.truth == Truth::proved ? std::optional(n) : std::nullopt,
            [](Object& one, const Neighbourhood& known) {
              one.has("phase", known.piece.kind, phase_names());
              one.has("after", known.before ? std::optional(known.before->kind) : std::nullopt,
                      phase_names());
              one.has("theta", known.before ? std::nullopt : std::optional(known.theta),
                      "The load's phase of the starts; without a load they lie where the phase begins.");
              one.has("centre", Eigen::VectorXd(numeric::zeros::in_double(known.centre)),
                      "c: the orbit's point there.");
              one.has("alone", known.alone,
                      "How far each number may be from c while the others are as there; 0 for one that "
                      "the event gives.");
              one.has("half_widths", known.half_widths, "Of the whole set.");
              std::vector<Eigen::VectorXd> rows;
              for (Eigen::Index i = 0; i < known.S.rows(); ++i) {
                rows.emplace_back(numeric::zeros::in_double(known.S).row(i).transpose());
              }
              one.has("S", rows, "The set is {c + S z: |z| <= radius}; rows of S.");
              one.has("radius", known.radius);
              one.has("boxes", known.boxes, "That the return map was looked at over.");
            });
      },
      "Starts whose motions are all proved to converge to the orbit.");
}

}  // namespace stickslip::report::orbits
