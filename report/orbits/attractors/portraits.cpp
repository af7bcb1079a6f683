#include "report/orbits/attractors/portraits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/interruption.hpp"
#include "numeric/attractors/many_starts.hpp"
#include "numeric/simulation/simulation.hpp"
#include "report/orbits/simulation.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace numeric::simulation;
using namespace tools;
using model::Vector4;

namespace {

// Of a component over what is drawn, and with a margin.
Extremes extent(const Portrait& p, int component) {
  return extremes(p.samples, [&](const Sample& s) { return s.X(component); });
}
Extremes extent_once(const Portrait& p, int component) {
  return extremes(p.once, [&](const Vector4<double>& X) { return X(component); });
}
Extremes widened(const Extremes& e) {
  const double width = e.greatest - e.least;
  const double size = std::max({std::abs(e.least), std::abs(e.greatest), 1e-300});
  const double margin = width > 1e-12 * size ? 0.06 * width : 0.1 * size;
  return {e.least - margin, e.greatest + margin};
}

// The ranges of the axes of one panel.
Json ranges(const Extremes& x, const Extremes& y) {
  return {{"left", fmt::format("{:.8g}", x.least)},
          {"right", fmt::format("{:.8g}", x.greatest)},
          {"bottom", fmt::format("{:.8g}", y.least)},
          {"top", fmt::format("{:.8g}", y.greatest)}};
}

// The place in a state of mass k of the labels.
int place(const PortraitLabels& labels, std::size_t k) {
  return static_cast<int>(k + 2 - labels.masses.size());
}

std::string axis(const PortraitLabels& labels, const char * x, std::size_t mass, const char * unit) {
  return fmt::format("{}_{}{}", x, mass + 1, labels.in_SI ? fmt::format(" in {}", unit) : "");
}

}  // namespace

Portrait portrait(const model::FrictionOscillator<double>& o, const Eigen::VectorXd& X, double theta,
                  double period, long periods, long states, const std::array<std::size_t, 2>& masses) {
  const auto n = static_cast<Eigen::Index>(o.size());
  const std::array at{static_cast<Eigen::Index>(masses[0]), static_cast<Eigen::Index>(masses[1])};
  const auto of_two = [&](const AnyState& Y) {
    return Vector4<double>(Y(at[0]), Y(at[1]), Y(n + at[0]), Y(n + at[1]));
  };
  const auto go_on = [](double) { return !interrupted(); };
  Portrait result;
  result.drawn = std::min(periods, Portrait::most_drawn);
  (void)record_motion(o, theta, X,
                      {static_cast<double>(result.drawn) * period, period / Portrait::samples_in_period},
                      go_on, [&](const simulation::SampleOf<AnyState>& s) {
                        result.samples.push_back({s.time, s.phase, of_two(s.X), s.r, s.u, s.energy});
                      });
  if (!o.is_autonomous()) {
    SimulationOf<Eigen::Dynamic, Eigen::Dynamic> simulation(o, theta, X);
    for (const AnyState& Y :
         states_once_a_period<AnyState>(simulation, std::min(states, Portrait::most_states))) {
      result.once.push_back(of_two(Y));
    }
  }
  return result;
}

Portrait portrait(const words::WordQuestion& machine, const Attractor& a, const Units& units) {
  const auto data = motion::parameters_as<double>(machine.data);
  const long periods = a.kind == Kind::periodic ? a.periods : Portrait::most_drawn;
  Portrait result =
      portrait(model::friction_oscillator<double>(data, scalars::scalar<double>(machine.ur)), a.state, 0,
               2 * std::acos(-1.0) / data.omega, periods, count_once(a, Portrait::most_states), {0, 1});
  for (Sample& sample : result.samples) {
    sample = units.sample(sample);
  }
  for (Vector4<double>& X : result.once) {
    X = units.state(X);
  }
  return result;
}

std::string plot_script(const Portrait& p, PlotFormat format, PlotShape shape, const PortraitLabels& labels) {
  const bool narrow = shape == PlotShape::narrow;
  std::string once;
  for (const Vector4<double>& X : p.once) {
    once += fmt::format("{:.8g} {:.8g}\n", X(1), X(3));
  }
  Json portraits = Json::array();
  for (std::size_t k = 0; k < labels.masses.size(); ++k) {
    const int at = place(labels, k);
    Json panel = ranges(widened(extent(p, at)), widened(extent(p, at + 2)));
    panel["title"] = fmt::format("Mass {}", labels.masses[k] + 1);
    panel["x"] = axis(labels, "x", labels.masses[k], "m");
    panel["y"] = axis(labels, "x'", labels.masses[k], "m/s");
    panel["columns"] = at == 0 ? "2:4" : "3:5";
    portraits.push_back(panel);
  }
  Json section = nullptr;
  if (!p.once.empty()) {
    section = ranges(widened(extent_once(p, 1)), widened(extent_once(p, 3)));
    section["x"] = axis(labels, "x", labels.masses.back(), "m");
    section["y"] = axis(labels, "x'", labels.masses.back(), "m/s");
    section["once"] = once;
    section["size"] = p.once.size() > 100 ? "0.25" : "0.7";
  }
  const auto panels = static_cast<int>(labels.masses.size()) + (p.once.empty() ? 0 : 1);
  const Json data = {
      {"terminal", narrow ? terminal(format, 480, 400 * panels) : terminal(format, 400 * panels, 420)},
      {"layout", narrow ? fmt::format("{},1", panels) : fmt::format("1,{}", panels)},
      {"phases", phase_tables(p.samples)},
      {"portraits", portraits},
      {"section", section}};
  return render_file("portrait.gp", data, plain_format);
}

std::string picture_in_words(const Portrait& p, const PortraitLabels& labels) {
  std::string text = p.once.empty() ? "The motion:"
                                    : fmt::format("The motion over {} {} of the load:", p.drawn,
                                                  p.drawn == 1 ? "period" : "periods");
  for (std::size_t k = 0; k < labels.masses.size(); ++k) {
    const Extremes x = extent(p, place(labels, k));
    const Extremes velocity = extent(p, place(labels, k) + 2);
    text += fmt::format(" x{} goes from {:.3g} to {:.3g}, its velocity from {:.3g} to {:.3g};",
                        labels.masses[k] + 1, x.least, x.greatest, velocity.least, velocity.greatest);
  }
  if (p.once.empty()) {
    text.back() = '.';
    return text;
  }
  return text + fmt::format(" {} {} once a period.", p.once.size(), p.once.size() == 1 ? "state" : "states");
}

}  // namespace stickslip::report::orbits
