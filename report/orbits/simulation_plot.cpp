#include <fmt/format.h>

#include <algorithm>

#include "report/orbits/orbit_words.hpp"
#include "report/orbits/simulation.hpp"
#include "report/tools/json.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric::motion;
using namespace numeric::simulation;
using namespace tools;

namespace {

std::string line(const Sample& s) {
  return fmt::format("{:.8g} {:.8g} {:.8g} {:.8g} {:.8g} {:.8g}\n", s.time, s.X(0), s.X(1), s.X(2), s.X(3),
                     s.energy);
}

template <class Samples>
std::string lines(const Samples& samples) {
  std::string text;
  for (const Sample& s : samples) {
    text += line(s);
  }
  return text;
}

// The samples from the time on that are in one kind of phase; a blank line ends each stretch, which goes on
// to the first sample after it, so that the curve has no gaps.
std::string stretches(const std::deque<Sample>& samples, double from, PhaseKind kind) {
  std::string text;
  bool inside = false;
  for (const Sample& s : samples) {
    if (s.time < from) {
      continue;
    }
    const bool here = s.phase == kind;
    if (here || inside) {
      text += line(s);
    }
    if (inside && !here) {
      text += "\n";
    }
    inside = here;
  }
  return text;
}

}  // namespace

void PictureSamples::add(const Sample& sample) {
  last_.push_back(sample);
  const double from = sample.time - periods_at_end * period_;
  while (last_.size() > most_points && last_.front().time < from) {
    last_.pop_front();
  }
  if (count_++ % stride_ == 0) {
    all_times_.push_back(sample);
  }
  if (all_times_.size() > most_points) {  // every second one from now on
    std::size_t kept = 0;
    for (std::size_t k = 0; k < all_times_.size(); k += 2) {
      all_times_[kept++] = all_times_[k];
    }
    all_times_.resize(kept);
    stride_ *= 2;
  }
}

Json phase_tables(const std::deque<Sample>& samples, double from) {
  Json phases = Json::array();
  for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
    const std::string table = stretches(samples, from, kind);
    if (!table.empty()) {
      phases.push_back({{"block", "$" + to_string(kind)},
                        {"kind", to_string(kind)},
                        {"colour", colour_of(kind)},
                        {"table", table},
                        {"first", phases.empty()}});
    }
  }
  return phases;
}

std::string plot_script(const Record& record, const PictureSamples& samples, PlotFormat format,
                        const Units& units) {
  const double from = std::max(0.0, record.done - PictureSamples::periods_at_end * record.period);
  const model::Parameters<double>& a = record.start.data;
  const Json data = {
      {"terminal", terminal(format, 1000, 760)},
      {"portrait", lines(samples.last())},
      {"history", lines(samples.all_times())},
      {"phases", phase_tables(samples.last(), from)},
      {"from", fmt::format("{:.8g}", from)},
      {"to", fmt::format("{:.8g}", record.done)},
      {"V", fmt::format("{:.8g}", units.velocity(a.V))},
      {"metres", units.unit(" in m")},
      {"speed", units.unit(" in m/s")},
      {"seconds", units.unit(" in s")},
      {"joules", units.unit(" in J")},
      {"periods", fmt::format("{:.6g}", record.done / record.period)},
      {"parameters",
       units.machine_or(fmt::format(
           "χ = {:.6g}, η = {:.6g}, u_s = {:.6g}, u_r = {:.6g}, V = {:.6g}, ω = {:.6g}, p = {:.6g}", a.chi,
           a.eta, a.us, record.start.ur, a.V, a.omega, a.p))}};
  return render_file("simulation.gp", data, plain_format);
}

}  // namespace stickslip::report::orbits
