#include "report/orbits/simulation.hpp"

#include <fmt/format.h>

#include "report/orbits/attractors.hpp"

namespace stickslip::report::orbits {

using namespace numeric::motion;
using namespace numeric::simulation;
using namespace tools;

namespace {

std::string data_of(const Start& s) {
  return fmt::format("chi={}, eta={}, us={}, ur={}, V={}, omega={}, p={}, phi={}", s.data.chi, s.data.eta,
                     s.data.us, s.ur, s.data.V, s.data.omega, s.data.p, s.phi);
}

std::string state_of(const model::Vector4<double>& X, const Units& units) {
  return fmt::format("x1 = {:.9g}, x2 = {:.9g}, x1' = {:.9g}, x2' = {:.9g}{}", X(0), X(1), X(2), X(3),
                     units.are_SI() ? " in m and m/s" : "");
}

std::string shares(const Record& record) {
  std::string text;
  for (const PhaseKind kind : {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick}) {
    const double share = record.time_in[static_cast<std::size_t>(kind)] / record.done;
    text += fmt::format("{}{} {:.3f} %", text.empty() ? "" : ", ", to_string(kind), 100 * share);
  }
  return text;
}

void add_events(std::vector<Row>& rows, const std::vector<Transition>& events, const Units& units) {
  // In SI units lengths of a machine are small.
  const auto number = [&](double x) {
    return units.are_SI() ? fmt::format("{:.6g}", x) : fmt::format("{:.6f}", x);
  };
  for (const Transition& e : events) {
    rows.push_back({{fmt::format("  {:.9g}", e.time)},
                    {to_string(e.before)},
                    {to_string(e.after)},
                    {number(e.r)},
                    {number(e.X(0))},
                    {number(e.X(1))},
                    {number(e.X(2))}});
  }
}

std::string events(const Record& record, const Style& style, const Units& units) {
  if (record.events == 0) {
    return "";
  }
  std::vector<Row> rows{{{units.labelled("  event at t", "s")},
                         {"from"},
                         {"to"},
                         {units.labelled("r", "N")},
                         {units.labelled("x1", "m")},
                         {units.labelled("x2", "m")},
                         {units.labelled("x1'", "m/s")}}};
  add_events(rows, record.first_events, units);
  const long left_out = record.events - static_cast<long>(record.first_events.size()) -
                        static_cast<long>(record.last_events.size());
  if (left_out > 0) {
    rows.push_back({{"  ..."}, {fmt::format("{} more", left_out)}, {""}, {""}, {""}, {""}, {""}});
  }
  add_events(rows, record.last_events, units);
  return "\n" + columns_of(rows, style.width);
}

}  // namespace

std::string terminal_report(const Simulated& simulated, const Style& style, const Units& units) {
  const Record record = units.record(simulated.record);
  const double periods = record.done / record.period;
  std::vector<Row> rows{
      {{"data"}, {data_of(record.start)}},
      {{"start"}, {state_of(record.start.X, units)}},
      {{"simulated"},
       {fmt::format("{:.9g} periods of the load, t = {:.9g}{}{}", periods, record.done, units.unit(" s"),
                    record.interrupted ? "; interrupted" : "")}},
      {{"end"}, {fmt::format("{}: {}", to_string(record.end.phase), state_of(record.end.X, units))}},
      {{"shares"}, {shares(record)}},
      {{"energy"},
       {fmt::format("{:.6g}{} at the end", record.end.energy, units.unit(" J")) +
        (record.energy ? fmt::format("; between {:.6g} and {:.6g}{}", record.energy->least,
                                     record.energy->greatest, units.unit(" J"))
                       : "")}},
      {{"events"},
       {fmt::format("{}, {:.4g} in a period", record.events, static_cast<double>(record.events) / periods)}}};
  if (simulated.settles) {
    rows.push_back({{"settles"}, {in_words(*simulated.settles)}});
  }
  return columns_of(rows, style.width) + events(record, style, units);
}

std::string csv_names(const Units& units) {
  return units.are_SI() ? "t in s,phase,x1 in m,x2 in m,x1' in m/s,x2' in m/s,r in N,u in N,E in J\n"
                        : "t,phase,x1,x2,x1',x2',r,u,E\n";
}

std::string csv_line(const Sample& s) {
  return fmt::format("{:.17g},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", s.time,
                     to_string(s.phase), s.X(0), s.X(1), s.X(2), s.X(3), s.r, s.u, s.energy);
}

}  // namespace stickslip::report::orbits
