#include "report/orbits/branches.hpp"

#include <fmt/format.h>

#include <array>

#include "core/decimal.hpp"
#include "numeric/families/family.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::branches;
using namespace tools;

namespace {

constexpr int digits = 12;

// The data but for the one that varies.
std::string others(const BranchQuestion& q) {
  std::string text;
  for (const NamedRange& parameter : named_parameters(q.orbits)) {
    if (parameter.name != q.parameter) {
      text += fmt::format("{}{}={}", text.empty() ? "" : ", ", parameter.name, notation(parameter.range));
    }
  }
  return text;
}

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string result_of(const BranchList& list) {
  std::size_t changes = 0;
  for (const Branch& branch : list.branches) {
    changes += branch.changes.size();
  }
  return fmt::format("{}, {}, {}{}", counted(list.branches.size(), "branch", "branches"),
                     counted(changes, "change", "changes"),
                     counted(list.unresolved.size(), "unresolved part", "unresolved parts"),
                     list.interrupted ? "; interrupted" : "");
}

std::string searched_in(const BranchList& list) {
  const BranchQuestion& q = list.question;
  if (q.word) {
    return fmt::format("near {} at {} = {}; other branches are not looked for",
                       counted(q.word->motions.size(), "known orbit", "known orbits"), q.parameter,
                       stickslip::to_string(*q.at));
  }
  return q.at ? fmt::format("{} at {} = {}; branches that do not reach this value are not looked for",
                            searched(q.orbits), q.parameter, stickslip::to_string(*q.at))
              : fmt::format("{} at every value of the interval", searched(q.orbits));
}

std::string complete_in_words(const BranchList& list) {
  return list.complete      ? "yes: every orbit at any value is on one of the branches"
         : list.question.at ? "no: only the branches of the orbits at one value were asked for"
                            : "but for what is unresolved";
}

std::string state_in_words(const Piece& piece) {
  return piece.condition.empty() ? to_string(piece.state)
                                 : fmt::format("{}: {}", to_string(piece.state), piece.condition);
}

std::string change_in_words(const Change& change) {
  std::string text = to_string(change.kind) + (change.what.empty() ? "" : " " + change.what);
  if (change.kind != ChangeKind::resonance) {
    text += ": " + change.words;
  }
  if (change.when && change.when->is_finite()) {
    text += fmt::format("; at t = {}", rounded(*change.when, 6));
  }
  return text + (change.verdict.truth == Truth::proved ? "; proved" : "; " + change.verdict.reason);
}

std::string branch_text(const Branch& branch, std::size_t number, const Style& style) {
  const Row heading{{fmt::format("Branch {}:", number), bold(style)},
                    {fmt::format("from {}, {}, to {}, {}", rounded(branch.first.at, digits),
                                 branch.first.words, rounded(branch.last.at, digits), branch.last.words)}};
  std::vector<Row> rows;
  for (const Piece& piece : branch.pieces) {
    rows.push_back({{"  " + rounded(piece.first, digits)},
                    {rounded(piece.last, digits)},
                    {state_in_words(piece),
                     colour_of(is_admissible(piece.state) ? Truth::proved : Truth::refuted, style)}});
  }
  std::string text = "\n" + columns_of({heading}, style.width) + columns_of(rows, style.width);
  rows.clear();
  for (const Change& change : branch.changes) {
    rows.push_back({{"  " + readable(change.at, digits)}, {change_in_words(change)}});
  }
  return text + columns_of(rows, style.width);
}

// The start of a motion, as the paper names it.
struct Start {
  double phi, x10, x20, xdot10;
};
Start start_of(const motion::MotionOf<double>& m) {
  const auto& first = m.phases.front();
  return {first.load, first.Z(0) + m.oscillator.d0(0), first.Z(1) + m.oscillator.d0(1), first.Z(2)};
}

Json change_data(const Change& change) {
  static constexpr std::array names{"", "condition", "multiplier", "duration", "frequency"};
  Json json = {{"kind", to_string(change.kind)}};
  if (!change.what.empty()) {
    json[names.at(static_cast<std::size_t>(change.kind))] = change.what;
  }
  json["words"] = change.words;
  json["at"] = to_json(change.at, 20);
  if (change.when && change.when->is_finite()) {
    json["time"] = to_json(*change.when, 20);
  }
  json["verdict"] = to_string(change.verdict.truth);
  if (!change.verdict.reason.empty()) {
    json["reason"] = change.verdict.reason;
  }
  return json;
}

Json branch_data(const Branch& branch, const BranchQuestion& q) {
  Json json = {{"from", to_json(branch.first.at, 20)},
               {"to", to_json(branch.last.at, 20)},
               {"closed", branch.closed},
               {"ends", Json::array()},
               {"pieces", Json::array()},
               {"changes", list_of(branch.changes, [](const Change& c) { return change_data(c); })},
               {"samples", Json::array()}};
  for (const BranchEnd * end : {&branch.first, &branch.last}) {
    json["ends"].push_back(
        {{"at", to_json(end->at, 20)}, {"reason", end->words}, {"resolved", end->resolved}});
  }
  for (const Piece& piece : branch.pieces) {
    Json one = {{"from", to_json(piece.first, 20)},
                {"to", to_json(piece.last, 20)},
                {"state", to_string(piece.state)}};
    if (!piece.condition.empty()) {
      one["violates"] = piece.condition;
    }
    json["pieces"].push_back(one);
    for (const Sample& sample : piece.samples) {
      Json here = {{"value", sample.value}, {"state", to_string(piece.state)}};
      for (std::size_t k = 0; k < sample.motion.phases.size(); ++k) {
        here[q.orbits.family->durations[k]] = sample.motion.phases[k].duration;
      }
      const Start start = start_of(sample.motion);
      here["phi"] = start.phi;
      here["x10"] = start.x10;
      here["x20"] = start.x20;
      here["xdot10"] = start.xdot10;
      json["samples"].push_back(here);
    }
  }
  return json;
}

}  // namespace

std::string terminal_report(const BranchList& list, const Style& style) {
  const BranchQuestion& q = list.question;
  std::vector<Row> rows{{{"parameters"}, {others(q)}},
                        {{"along"},
                         {fmt::format("{} from {} to {}", q.parameter, stickslip::to_string(q.from),
                                      stickslip::to_string(q.to))}},
                        {{"searched"}, {searched_in(list)}},
                        {{"complete"}, {complete_in_words(list)}},
                        {{"result"}, {result_of(list)}}};
  for (const UnresolvedPart& part : list.unresolved) {
    std::string where;
    for (const NamedBall& value : part.where) {
      where += fmt::format("{} = {}, ", value.name, to_string(value.value, 8));
    }
    rows.push_back(
        {{"unresolved"},
         {fmt::format("{} = {}: {}{}", q.parameter, readable(part.value, digits), where, part.reason)}});
  }
  std::string text =
      columns_of({{{fmt::format("Branches along {}. {}", q.parameter, q.orbits.family->title), bold(style)}}},
                 style.width) +
      columns_of(rows, style.width);
  for (std::size_t k = 0; k < list.branches.size(); ++k) {
    text += branch_text(list.branches[k], k + 1, style);
  }
  // At most so many when what is open is decided.
  const auto number = [](const Count& count, int least, int open) {
    return count.more  ? fmt::format("{} or more", least)
           : open == 0 ? std::to_string(least)
                       : fmt::format("{} to {}", least, least + open);
  };
  rows = {{{q.parameter}, {""}, {"orbits"}, {"admissible"}, {"stable"}}};
  for (const Count& count : list.counts) {
    rows.push_back({{rounded(count.from, digits)},
                    {rounded(count.to, digits)},
                    {number(count, count.orbits, count.undecided)},
                    {number(count, count.admissible, count.undecided)},
                    {number(count, count.stable, count.unsettled + count.undecided)}});
  }
  return text + "\n" + columns_of(rows, style.width);
}

std::string to_csv(const BranchList& list) {
  const BranchQuestion& q = list.question;
  std::string text = q.parameter + ",branch,piece,state";
  for (const std::string& name : q.orbits.family->durations) {
    text += "," + name;
  }
  text += ",phi,x10,x20,xdot10\n";
  for (std::size_t b = 0; b < list.branches.size(); ++b) {
    const std::vector<Piece>& pieces = list.branches[b].pieces;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      for (const Sample& sample : pieces[k].samples) {
        text += fmt::format("{:.17g},{},{},{}", sample.value, b + 1, k + 1, to_string(pieces[k].state));
        for (const auto& phase : sample.motion.phases) {
          text += fmt::format(",{:.17g}", phase.duration);
        }
        const Start s = start_of(sample.motion);
        text += fmt::format(",{:.17g},{:.17g},{:.17g},{:.17g}\n", s.phi, s.x10, s.x20, s.xdot10);
      }
    }
  }
  return text;
}

Json to_json(const BranchList& list) {
  const BranchQuestion& q = list.question;
  Json json = provenance(command_of(q));
  json["family"] = q.orbits.family->name;
  json["parameter"] = q.parameter;
  json["interval"] = {stickslip::to_string(q.from), stickslip::to_string(q.to)};
  json["parameters"] = Json::object();
  for (const NamedRange& parameter : named_parameters(q.orbits)) {
    if (parameter.name != q.parameter) {
      json["parameters"][parameter.name] = notation(parameter.range);
    }
  }
  json["complete"] = list.complete;
  if (q.at) {
    json["at"] = stickslip::to_string(*q.at);
  }
  json["branches"] = list_of(list.branches, [&](const Branch& branch) { return branch_data(branch, q); });
  json["counts"] = list_of(list.counts, [](const Count& count) {
    return Json{{"from", to_json(count.from, 20)}, {"to", to_json(count.to, 20)},
                {"orbits", count.orbits},          {"admissible", count.admissible},
                {"stable", count.stable},          {"unsettled", count.unsettled},
                {"undecided", count.undecided},    {"more", count.more}};
  });
  json["unresolved"] = list_of(list.unresolved, [](const UnresolvedPart& part) {
    Json one = {{"value", to_json(part.value, 20)}};
    add_values(one, part.where, 20);
    one["reason"] = plain(part.reason);
    one["resonance"] = part.resonance;
    return one;
  });
  json["interrupted"] = list.interrupted;
  return json;
}

std::string plot_script(const BranchList& list, PlotFormat format) {
  const BranchQuestion& q = list.question;
  Json data = {{"svg", format == PlotFormat::svg}, {"pdf", format == PlotFormat::pdf}};
  struct Stroke {
    const char *name, *style;
    std::string table;
  };
  std::array<Stroke, 4> strokes{
      {{"stable", "lw 3 lc rgb \"#1f4e9c\"", {}},
       {"unstable", "lw 1.6 dt (10,5) lc rgb \"#b2182b\"", {}},
       {"not admissible", "lw 1.2 dt (2,5) lc rgb \"#777777\"", {}},
       {"admissible, stability open", "lw 2 dt (12,4,2,4) lc rgb \"#7b3294\"", {}}}};
  struct Mark {
    const char * name;
    int type;
    std::string table;
  };
  std::array<Mark, 5> marks{
      {{"fold", 5, {}}, {"condition", 9, {}}, {"stability", 7, {}}, {"birth", 10, {}}, {"resonance", 2, {}}}};
  const auto nearest = [](const Branch& branch, double value) {
    const Sample * best = nullptr;
    for (const Piece& piece : branch.pieces) {
      for (const Sample& s : piece.samples) {
        best = best == nullptr || std::abs(s.value - value) < std::abs(best->value - value) ? &s : best;
      }
    }
    return best;
  };
  for (const Branch& branch : list.branches) {
    for (const Piece& piece : branch.pieces) {
      if (piece.samples.empty()) {
        continue;
      }
      std::string& table = strokes[piece.state == State::stable         ? 0
                                   : piece.state == State::unstable     ? 1
                                   : piece.state == State::inadmissible ? 2
                                                                        : 3]
                               .table;
      for (const Sample& s : piece.samples) {
        table += fmt::format("{:.10g} {:.8g}\n", s.value, start_of(s.motion).x20);
      }
      table += "\n";
    }
    for (const Change& change : branch.changes) {
      if (const Sample * s = nearest(branch, change.at.approximate())) {
        marks[static_cast<std::size_t>(change.kind)].table +=
            fmt::format("{:.10g} {:.8g}\n", change.at.approximate(), start_of(s->motion).x20);
      }
    }
  }
  data["curves"] = Json::array();
  const auto add = [&](const char * name, const std::string& table, const std::string& with) {
    if (!table.empty()) {
      data["curves"].push_back({{"block", fmt::format("$curve{}", data["curves"].size())},
                                {"name", name},
                                {"table", table},
                                {"with", with},
                                {"first", data["curves"].empty()}});
    }
  };
  for (const Stroke& stroke : strokes) {
    add(stroke.name, stroke.table, std::string("lines ") + stroke.style);
  }
  for (const Mark& mark : marks) {
    add(mark.name, mark.table, fmt::format("points pt {} ps 1 lc rgb \"#000000\"", mark.type));
  }
  if (data["curves"].empty()) {
    return "";
  }
  data["family"] = q.orbits.family->name;
  data["parameter"] = q.parameter;
  data["parameters"] = others(q);
  data["from"] = fmt::format("{:.8g}", q.from.get_d());
  data["to"] = fmt::format("{:.8g}", q.to.get_d());
  return render_file("branches.gp", data, plain_format);
}

std::string command_of(const BranchQuestion& q) {
  std::string command = "stickslip branch " + q.orbits.family->name;
  if (q.word && q.word->periods > 1) {
    command += fmt::format(" --period={}", q.word->periods);
  }
  for (const NamedRange& parameter : named_parameters(q.orbits)) {
    if (parameter.name != q.parameter) {
      command += fmt::format(" --{}={}", parameter.name, notation(parameter.range));
    }
  }
  command +=
      fmt::format(" --{}={}..{}", q.parameter, stickslip::to_string(q.from), stickslip::to_string(q.to));
  return q.at ? command + " --at=" + stickslip::to_string(*q.at) : command;
}

}  // namespace stickslip::report::orbits
