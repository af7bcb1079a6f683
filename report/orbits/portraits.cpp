#include "report/orbits/portraits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/interruption.hpp"
#include "numeric/attractors/diagram.hpp"
#include "report/orbits/simulation.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace numeric::simulation;
using namespace tools;
using model::Vector4;

namespace {

// Of a component over what is drawn, with a margin: never empty.
struct Extent {
  double least, greatest;
};
Extent extent(const Portrait& p, int component) {
  Extent e{p.samples.front().X(component), p.samples.front().X(component)};
  for (const Sample& s : p.samples) {
    e = {std::min(e.least, s.X(component)), std::max(e.greatest, s.X(component))};
  }
  return e;
}
Extent widened(const Extent& e, double share) {
  const double width = e.greatest - e.least;
  const double size = std::max({std::abs(e.least), std::abs(e.greatest), 1e-300});
  const double margin = width > 1e-12 * size ? share * width : 0.1 * size;
  return {e.least - margin, e.greatest + margin};
}

// The ranges of the axes of one panel.
Json ranges(const Extent& x, const Extent& y) {
  return {{"left", fmt::format("{:.8g}", x.least)},
          {"right", fmt::format("{:.8g}", x.greatest)},
          {"bottom", fmt::format("{:.8g}", y.least)},
          {"top", fmt::format("{:.8g}", y.greatest)}};
}

Extent extent_once(const Portrait& p, int component) {
  Extent e{p.once.front()(component), p.once.front()(component)};
  for (const Vector4<double>& X : p.once) {
    e = {std::min(e.least, X(component)), std::max(e.greatest, X(component))};
  }
  return e;
}

}  // namespace

Portrait portrait(const words::WordQuestion& machine, const Attractor& a, const Units& units) {
  Portrait result;
  const bool periodic = a.kind == Kind::periodic;
  result.drawn = periodic ? std::min(a.periods, Portrait::most_drawn) : Portrait::most_drawn;
  const Start start{motion::parameters_as<double>(machine.data), scalars::scalar<double>(machine.ur), 0,
                    a.state};
  const double period = 2 * std::acos(-1.0) / start.data.omega;
  (void)record_motion(
      start, {static_cast<double>(result.drawn) * period, period / Portrait::samples_in_period},
      [](double) { return !interrupted(); },
      [&](const Sample& sample) { result.samples.push_back(units.sample(sample)); });
  const long count = periodic ? std::min(a.periods, Portrait::most_states) : Portrait::most_states;
  for (const Vector4<double>& X : once_a_period(machine, a, count)) {
    result.once.push_back(units.state(X));
  }
  return result;
}

std::string plot_script(const Portrait& p, PlotFormat format, PlotShape shape, const Units& units) {
  const bool narrow = shape == PlotShape::narrow;
  std::string once;
  for (const Vector4<double>& X : p.once) {
    once += fmt::format("{:.8g} {:.8g}\n", X(1), X(3));
  }
  constexpr double margin = 0.06;
  const auto axes = [&](int mass) {
    Json panel = ranges(widened(extent(p, mass), margin), widened(extent(p, mass + 2), margin));
    panel["title"] = fmt::format("Mass {}", mass + 1);
    panel["x"] = units.labelled(fmt::format("x_{}", mass + 1), "m");
    panel["y"] = units.labelled(fmt::format("x'_{}", mass + 1), "m/s");
    panel["columns"] = mass == 0 ? "2:4" : "3:5";
    return panel;
  };
  Json section = ranges(widened(extent_once(p, 1), margin), widened(extent_once(p, 3), margin));
  section["x"] = units.labelled("x_2", "m");
  section["y"] = units.labelled("x'_2", "m/s");
  const Json data = {{"terminal", narrow ? terminal(format, 480, 1200) : terminal(format, 1200, 420)},
                     {"layout", narrow ? "3,1" : "1,3"},
                     {"phases", phase_tables(p.samples)},
                     {"portraits", {axes(0), axes(1)}},
                     {"section", section},
                     {"once", once},
                     {"size", p.once.size() > 100 ? "0.25" : "0.7"}};
  return render_file("portrait.gp", data, plain_format);
}

std::string picture_in_words(const Portrait& p) {
  std::string text =
      fmt::format("The motion over {} {} of the load:", p.drawn, p.drawn == 1 ? "period" : "periods");
  for (int mass = 0; mass < 2; ++mass) {
    const Extent place = extent(p, mass);
    const Extent velocity = extent(p, mass + 2);
    text += fmt::format(" x{} goes from {:.3g} to {:.3g}, its velocity from {:.3g} to {:.3g};", mass + 1,
                        place.least, place.greatest, velocity.least, velocity.greatest);
  }
  return text + fmt::format(" {} {} once a period.", p.once.size(), p.once.size() == 1 ? "state" : "states");
}

}  // namespace stickslip::report::orbits
