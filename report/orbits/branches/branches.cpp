#include "report/orbits/branches/branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "core/decimal.hpp"
#include "numeric/families/family.hpp"
#include "report/orbits/machine.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/prose.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::branches;
using namespace tools;

namespace {

constexpr int digits = 12;

// The data except for the one that varies.
std::string others(const BranchQuestion& q) {
  return parameter_list(parameters_of(q)) + (q.machine ? ", in SI units" : "");
}

// What the units of (2) are where what varies is that; those of (2) themselves without a machine.
Units units_at(const BranchQuestion& q, double value) {
  return q.machine ? Units(q.machine->taken(std::clamp(Rational(value), q.from, q.to))) : Units();
}

std::string result_of(const BranchList& list) {
  long changes = 0;
  for (const Branch& branch : list.branches) {
    changes += std::ssize(branch.changes);
  }
  return fmt::format("{}, {}, {}{}", counted(std::ssize(list.branches), "branch", "branches"),
                     counted(changes, "change"), counted(std::ssize(list.unresolved), "unresolved part"),
                     list.interrupted ? "; interrupted" : "");
}

std::string searched_in(const BranchList& list) {
  const BranchQuestion& q = list.question;
  if (q.word) {
    const std::size_t left = q.word->not_admissible;
    return fmt::format("near {} at {} = {}{}; other branches are not looked for",
                       counted(std::ssize(q.word->motions), "known orbit"), q.parameter,
                       stickslip::to_string(*q.at),
                       left == 0 ? "" : fmt::format(", and not near {} that are not admissible", left));
  }
  return q.at ? fmt::format("{} at {} = {}; branches that do not reach this value are not looked for",
                            searched(q.orbits), q.parameter, stickslip::to_string(*q.at))
              : fmt::format("{} at every value of the interval", searched(q.orbits));
}

std::string complete_in_words(const BranchList& list) {
  return list.complete      ? "yes: every orbit at any value is on one of the branches"
         : list.question.at ? "no: only the branches of the orbits at one value were asked for"
                            : "except for what is unresolved";
}

std::string state_in_words(const Piece& piece) {
  return piece.condition.empty() ? to_string(piece.state)
                                 : fmt::format("{}: {}", to_string(piece.state), piece.condition);
}

std::string change_in_words(const Change& change, const BranchQuestion& q) {
  std::string text = to_string(change.kind) + (change.what.empty() ? "" : " " + change.what);
  if (change.kind != ChangeKind::resonance) {
    text += ": " + change.words;
  }
  const std::optional<Ball> time = time_of(q, change);
  return time ? text + fmt::format("; at t = {}{}", rounded(*time, 6), q.machine ? " s" : "") : text;
}

std::string branch_text(const Branch& branch, const BranchQuestion& q, std::size_t number,
                        const Style& style) {
  const BranchRows told = rows_of(branch, q);
  std::vector<Row> pieces, changes;
  for (std::size_t k = 0; k < told.pieces.size(); ++k) {
    const Row& row = told.pieces[k];
    const Truth truth = is_admissible(branch.pieces[k].state) ? Truth::proved : Truth::refuted;
    pieces.push_back({{"  " + row[0].text}, row[1], {row[2].text, colour_of(truth, style)}});
  }
  for (const Row& row : told.changes) {
    changes.push_back({{"  " + row[0].text}, {row[1].text + "; " + row[2].text}});
  }
  return "\n" +
         columns_of({{{fmt::format("Branch {}:", number), bold(style)}, {told.heading}}}, style.width) +
         columns_of(pieces, style.width) + columns_of(changes, style.width);
}

}  // namespace

std::vector<OrbitOfBranch> orbits_of(const Branch& branch, const BranchQuestion& q) {
  std::vector<OrbitOfBranch> orbits;
  for (std::size_t k = 0; k < branch.pieces.size(); ++k) {
    for (const Sample& sample : branch.pieces[k].samples) {
      const motion::MotionOf<double>& m = sample.motion;
      const Units units = units_at(q, sample.value);
      const auto& first = m.phases.front();
      model::Vector4<double> X = first.Z;
      X.head<2>() += m.oscillator.d0;
      X = units.state(X);
      orbits.push_back({k + 1, branch.pieces[k].state, sample.value, {}, first.load, X(0), X(1), X(2)});
      for (std::size_t i = 0; i < m.phases.size(); ++i) {
        orbits.back().durations.emplace_back(q.orbits.family->durations[i], units.time(m.phases[i].duration));
      }
    }
  }
  return orbits;
}

std::optional<Ball> time_of(const BranchQuestion& q, const Change& change) {
  if (!change.when || !change.when->is_finite()) {
    return std::nullopt;
  }
  return q.machine ? *change.when / q.machine->Omega(change.at) : *change.when;
}

std::vector<NamedBall> where(const BranchQuestion& q, const UnresolvedPart& part) {
  std::vector<NamedBall> values = part.where;
  for (NamedBall& one : values) {
    if (q.machine && is_time(one.name)) {
      one.value = one.value / q.machine->Omega(part.value);
    }
  }
  return values;
}

std::vector<std::pair<std::string, std::string>> parameters_of(const BranchQuestion& q) {
  std::vector<std::pair<std::string, std::string>> parameters;
  if (!q.machine) {
    for (const auto& [name, range] : named_parameters(q.orbits)) {
      if (name != q.parameter) {
        parameters.emplace_back(name, notation(range));
      }
    }
    return parameters;
  }
  const auto first = values_in_SI(q.machine->at_from), last = values_in_SI(q.machine->at_to);
  for (std::size_t k = 0; k < first.size(); ++k) {
    const auto& [name, from] = first[k];
    if (name != q.parameter && name != "load_phase") {
      const Rational& to = last[k].second;
      parameters.emplace_back(name, from == to
                                        ? stickslip::to_string(from)
                                        : stickslip::to_string(from) + ".." + stickslip::to_string(to));
    }
  }
  if (q.machine->phi) {
    parameters.emplace_back("phi", stickslip::to_string(*q.machine->phi));
  }
  return parameters;
}

std::string parameter_of(const BranchQuestion& q) {
  return q.parameter + (q.machine ? in_unit_of(q.parameter) : "");
}

std::vector<Row> rows_of(const BranchList& list) {
  const BranchQuestion& q = list.question;
  return {{{"parameters"}, {others(q)}},
          {{"along"},
           {fmt::format("{} from {} to {}", parameter_of(q), stickslip::to_string(q.from),
                        stickslip::to_string(q.to))}},
          {{"searched"}, {searched_in(list)}},
          {{"complete"}, {complete_in_words(list)}},
          {{"result"}, {result_of(list)}}};
}

BranchRows rows_of(const Branch& branch, const BranchQuestion& q) {
  const std::string from = rounded(branch.first.at, digits);
  BranchRows told{branch.closed ? fmt::format("a closed curve, from {} once round", from)
                                : fmt::format("from {}, {}, to {}, {}", from, branch.first.words,
                                              rounded(branch.last.at, digits), branch.last.words),
                  {},
                  {}};
  for (const Piece& piece : branch.pieces) {
    told.pieces.push_back(
        {{rounded(piece.first, digits)}, {rounded(piece.last, digits)}, {state_in_words(piece)}});
  }
  for (const Change& change : branch.changes) {
    const bool proved = change.verdict.truth == Truth::proved;
    told.changes.push_back({{readable(change.at, digits)},
                            {change_in_words(change, q)},
                            {proved ? to_string(change.verdict.truth) : change.verdict.reason}});
  }
  return told;
}

std::vector<Row> unresolved_rows(const BranchList& list) {
  std::vector<Row> rows;
  for (const UnresolvedPart& part : list.unresolved) {
    rows.push_back({{fmt::format("{} = {}", list.question.parameter, readable(part.value, digits))},
                    {place_text(where(list.question, part)) + part.reason}});
  }
  return rows;
}

std::vector<Row> count_rows(const BranchList& list) {
  // At most so many when what is open is decided.
  const auto number = [](const Count& count, int least, int open) {
    return count.more  ? fmt::format("{} or more", least)
           : open == 0 ? std::to_string(least)
                       : fmt::format("{} to {}", least, least + open);
  };
  std::vector<Row> rows;
  for (const Count& count : list.counts) {
    rows.push_back({{rounded(count.from, digits)},
                    {rounded(count.to, digits)},
                    {number(count, count.orbits, count.undecided)},
                    {number(count, count.admissible, count.undecided)},
                    {number(count, count.stable, count.unsettled + count.undecided)}});
  }
  return rows;
}

std::string terminal_report(const BranchList& list, const Style& style) {
  const BranchQuestion& q = list.question;
  std::vector<Row> rows = rows_of(list);
  for (const Row& part : unresolved_rows(list)) {
    rows.push_back({{"unresolved"}, {part[0].text + ": " + part[1].text}});
  }
  std::string text =
      headed(fmt::format("Branches along {}. {}", q.parameter, q.orbits.family->title), rows, style);
  for (std::size_t k = 0; k < list.branches.size(); ++k) {
    text += branch_text(list.branches[k], q, k + 1, style);
  }
  std::vector<Row> counts = count_rows(list);
  counts.insert(counts.begin(), {{parameter_of(q)}, {""}, {"orbits"}, {"admissible"}, {"stable"}});
  return text + "\n" + columns_of(counts, style.width);
}

std::string to_csv(const BranchList& list) {
  const BranchQuestion& q = list.question;
  std::string text = q.parameter + ",branch,piece,state," +
                     enumerated(q.orbits.family->durations, std::identity(), ",") + ",phi,x10,x20,xdot10\n";
  for (std::size_t b = 0; b < list.branches.size(); ++b) {
    for (const OrbitOfBranch& o : orbits_of(list.branches[b], q)) {
      text += fmt::format("{:.17g},{},{},{},", o.value, b + 1, o.piece, to_string(o.state));
      for (const auto& [name, duration] : o.durations) {
        text += fmt::format("{:.17g},", duration);
      }
      text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}\n", o.phi, o.x10, o.x20, o.xdot10);
    }
  }
  return text;
}

void BranchCurves::begin() {
  points_.clear();
}

void BranchCurves::add(State state, double parameter, double x) {
  const int curve = state == State::stable         ? 0
                    : state == State::unstable     ? 1
                    : state == State::inadmissible ? 2
                                                   : 3;
  if (now_ >= 0 && now_ != curve) {
    curves_.at(static_cast<std::size_t>(now_)) += "\n";
  }
  now_ = curve;
  curves_.at(static_cast<std::size_t>(now_)) += fmt::format("{:.10g} {:.8g}\n", parameter, x);
  points_.emplace_back(parameter, x);
}

void BranchCurves::end() {
  if (now_ >= 0) {
    curves_.at(static_cast<std::size_t>(now_)) += "\n";
  }
  now_ = -1;
}

void BranchCurves::mark(ChangeKind kind, double parameter) {
  const auto nearest = std::ranges::min_element(
      points_, {}, [&](const auto& point) { return std::abs(point.first - parameter); });
  if (nearest != points_.end()) {
    marks_.at(static_cast<std::size_t>(kind)) += fmt::format("{:.10g} {:.8g}\n", parameter, nearest->second);
  }
}

std::string BranchCurves::script(const Labels& labels, PlotFormat format, PlotShape shape) const {
  const bool narrow = shape == PlotShape::narrow;
  constexpr std::array<std::pair<const char *, const char *>, 4> strokes{
      {{"stable", "lw 3 lc rgb \"#1f4e9c\""},
       {"unstable", "lw 1.6 dt (10,5) lc rgb \"#b2182b\""},
       {"not admissible", "lw 1.2 dt (2,5) lc rgb \"#777777\""},
       {"admissible, stability open", "lw 2 dt (12,4,2,4) lc rgb \"#7b3294\""}}};
  constexpr std::array<std::pair<const char *, int>, 5> marks{
      {{"fold", 5}, {"condition", 9}, {"stability", 7}, {"birth", 10}, {"resonance", 2}}};
  Json data = {{"terminal", narrow ? terminal(format, 480, 560) : terminal(format, 1000, 600)},
               {"narrow", narrow},
               {"curves", Json::array()}};
  const auto add = [&](const char * name, const std::string& table, const std::string& with) {
    if (!table.empty()) {
      data["curves"].push_back({{"block", fmt::format("$curve{}", data["curves"].size())},
                                {"name", name},
                                {"table", table},
                                {"with", with},
                                {"first", data["curves"].empty()}});
    }
  };
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    add(strokes.at(k).first, curves_.at(k), std::string("lines ") + strokes.at(k).second);
  }
  for (std::size_t k = 0; k < marks.size(); ++k) {
    add(marks.at(k).first, marks_.at(k),
        fmt::format("points pt {} ps 1 lc rgb \"#000000\"", marks.at(k).second));
  }
  if (data["curves"].empty()) {
    return "";
  }
  data["family"] = labels.orbits;
  data["parameter"] = labels.parameter;
  data["x2"] = labels.x;
  data["parameters"] = labels.parameters;
  data["from"] = fmt::format("{:.8g}", labels.from);
  data["to"] = fmt::format("{:.8g}", labels.to);
  return render_file("branches.gp", data, plain_format);
}

std::string plot_script(const BranchList& list, PlotFormat format, PlotShape shape) {
  const BranchQuestion& q = list.question;
  BranchCurves curves;
  for (const Branch& branch : list.branches) {
    curves.begin();
    std::size_t piece = 1;
    for (const OrbitOfBranch& o : orbits_of(branch, q)) {
      if (o.piece != std::exchange(piece, o.piece)) {
        curves.end();
      }
      curves.add(o.state, o.value, o.x20);
    }
    curves.end();
    for (const Change& change : branch.changes) {
      curves.mark(change.kind, change.at.approximate());
    }
  }
  return curves.script({q.orbits.family->name, parameter_of(q), q.machine ? "x2 in m" : "x2",
                        units_at(q, q.from.get_d()).machine_or(in_greek(others(q)), q.parameter),
                        q.from.get_d(), q.to.get_d()},
                       format, shape);
}

std::string command_of(const BranchQuestion& q) {
  std::string command = "stickslip branch " + q.orbits.family->name;
  if (q.word && q.word->periods > 1) {
    command += fmt::format(" --period={}", q.word->periods);
  }
  if (q.machine) {
    command += fmt::format(" --params {}{} --along {} {}..{}", q.machine_file,
                           q.machine->phi ? " --phi=" + stickslip::to_string(*q.machine->phi) : "",
                           q.parameter, stickslip::to_string(q.from), stickslip::to_string(q.to));
  } else {
    command += fmt::format("{} --{}={}..{}", options_of(parameters_of(q)), q.parameter,
                           stickslip::to_string(q.from), stickslip::to_string(q.to));
  }
  return q.at ? command + " --at=" + stickslip::to_string(*q.at) : command;
}

}  // namespace stickslip::report::orbits
