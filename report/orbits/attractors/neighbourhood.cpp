#include "report/orbits/attractors/neighbourhood.hpp"

#include <fmt/format.h>

#include "core/decimal.hpp"
#include "numeric/zeros/linear_solve.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/orbits/record_json.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using numeric::machines::Neighbourhood;
using namespace tools;

std::string named(const Coordinate& coordinate) {
  return coordinate.unit.empty() ? coordinate.name : coordinate.name + " in " + coordinate.unit;
}

std::string state_in_words(const Eigen::VectorXd& X, const std::vector<Coordinate>& coordinates) {
  const double * x = X.data();
  return enumerated(coordinates,
                    [&](const Coordinate& one) { return fmt::format("{} = {:.9g}", one.name, *x++); }) +
         (coordinates.front().unit.empty() ? "" : " in m and m/s");
}

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
    rows.push_back({{"  " + named(coordinates[k])},
                    {fmt::format("{:.8g}", n.centre(i).approximate() * coordinates[k].factor)},
                    {shown(n.alone(i))},
                    {shown(n.half_widths(i))}});
  }
  return rows;
}

std::string neighbourhood_text(const numeric::Orbit& orbit, const Style& style, const Units& units,
                               const std::optional<Rational>& ur) {
  if (!orbit.neighbourhood) {
    return "";
  }
  const std::vector<Row> rows = neighbourhood_rows(*orbit.neighbourhood, coordinates_in(units));
  return columns_of(rows, style.width) + (ur ? columns_of({{{"  " + ur_in_words(*ur)}}}, style.width) : "") +
         "\n";
}

std::optional<Rational> ur_of_neighbourhood(const numeric::OrbitQuestion& question,
                                            const numeric::Orbit& orbit) {
  return orbit.neighbourhood && !question.ur ? std::optional(numeric::machine_of(question, orbit).ur)
                                             : std::nullopt;
}

std::string ur_in_words(const Rational& ur) {
  return fmt::format("of the machine with ur = {}, the orbit's to 17 digits", to_string(ur));
}

std::string meaning_of_neighbourhood() {
  return "proved: a motion that starts there on the orbit, but for one number that is off by at most so "
         "much, converges to the orbit; and so do all from an ellipsoid of these half widths";
}

namespace {

Neighbourhood in_units(Neighbourhood n, const Units& units) {
  if (n.verdict.truth != Truth::proved || !units.are_SI()) {
    return n;
  }
  const std::vector<Coordinate> coordinates = coordinates_in(units);
  for (Eigen::Index i = 0; i < n.centre.size(); ++i) {
    const double factor = coordinates[static_cast<std::size_t>(i)].factor;
    n.centre(i) *= Ball(factor);
    n.alone(i) *= factor;
    n.half_widths(i) *= factor;
    for (Eigen::Index k = 0; k < n.S.cols(); ++k) {
      n.S(i, k) *= Ball(factor);
      n.inverse(k, i) /= Ball(factor);
    }
  }
  n.time = units.time(n.time);
  n.period = units.time(n.period);
  return n;
}

}  // namespace

void write_neighbourhood(Object& json, const std::shared_ptr<const Neighbourhood>& neighbourhood,
                         const Units& units) {
  json.object_if(
      "neighbourhood", neighbourhood ? std::optional(in_units(*neighbourhood, units)) : std::nullopt,
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

void write_neighbourhood(Object& json, const numeric::OrbitQuestion& question, const numeric::Orbit& orbit,
                         const Units& units) {
  write_neighbourhood(json, orbit.neighbourhood, units);
  json.has("ur_of_neighbourhood", ur_of_neighbourhood(question, orbit),
           "Where ur is a result: of the machine that the neighbourhood is proved for, ur to 17 digits.");
}

}  // namespace stickslip::report::orbits
