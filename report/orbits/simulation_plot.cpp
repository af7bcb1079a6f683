#include <fmt/format.h>

#include <algorithm>

#include "report/orbits/orbit_words.hpp"
#include "report/orbits/simulation.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric::motion;
using namespace numeric::simulation;
using namespace tools;

namespace {

constexpr std::size_t most_points = 20000;  // of a curve
constexpr double periods_at_end = 3;

std::string line(const Sample& s) {
  return fmt::format("{:.8g} {:.8g} {:.8g} {:.8g} {:.8g} {:.8g}\n", s.time, s.X(0), s.X(1), s.X(2), s.X(3),
                     s.energy);
}

// The last samples, as many as a picture bears.
std::string portrait(const Record& record) {
  const std::size_t count = record.samples.size();
  std::string text;
  for (std::size_t k = count > most_points ? count - most_points : 0; k < count; ++k) {
    text += line(record.samples[k]);
  }
  return text;
}

// From the beginning to the end, if need be with gaps between the samples.
std::string history(const Record& record) {
  const std::size_t stride = record.samples.size() / most_points + 1;
  std::string text;
  for (std::size_t k = 0; k < record.samples.size(); k += stride) {
    text += line(record.samples[k]);
  }
  return text;
}

// The samples from the time on that are in one kind of phase; a blank line ends each stretch, which goes on
// to the first sample after it, so that the curve has no gaps.
std::string stretches(const Record& record, double from, PhaseKind kind) {
  std::string text;
  bool inside = false;
  for (const Sample& s : record.samples) {
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

std::string plot_script(const Record& record, PlotFormat format) {
  const double from = std::max(0.0, record.done - periods_at_end * record.period);
  Json phases = Json::array();
  for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
    const std::string table = stretches(record, from, kind);
    if (!table.empty()) {
      phases.push_back({{"block", "$" + to_string(kind)},
                        {"kind", to_string(kind)},
                        {"colour", colour_of(kind)},
                        {"table", table},
                        {"first", phases.empty()}});
    }
  }
  const model::Parameters<double>& a = record.start.data;
  const Json data = {
      {"svg", format == PlotFormat::svg},
      {"pdf", format == PlotFormat::pdf},
      {"portrait", portrait(record)},
      {"history", history(record)},
      {"phases", phases},
      {"from", fmt::format("{:.8g}", from)},
      {"to", fmt::format("{:.8g}", record.done)},
      {"V", fmt::format("{:.8g}", a.V)},
      {"periods", fmt::format("{:.6g}", record.done / record.period)},
      {"parameters",
       fmt::format(
           "chi = {:.6g}, eta = {:.6g}, us = {:.6g}, ur = {:.6g}, V = {:.6g}, omega = {:.6g}, p = {:.6g}",
           a.chi, a.eta, a.us, record.start.ur, a.V, a.omega, a.p)}};
  const std::string name = "simulation.gp.mustache";
  return render(name, read_file(template_directory() / name), data, plain_format);
}

}  // namespace stickslip::report::orbits
