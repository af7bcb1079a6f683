#include <algorithm>
#include <array>
#include <iterator>

#include "core/decimal.hpp"
#include "model/machine_values.hpp"
#include "numeric/families/family.hpp"
#include "report/orbits/branches/branches.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::branches;
using namespace tools;

namespace {

constexpr int ball_digits = 20;

void write_change(Object& json, const Change& change, const BranchQuestion& q) {
  json.has("kind", change.kind, names_through(ChangeKind::resonance));
  const auto what = [&](const char * key, ChangeKind kind, const Json& more) {
    json.has(key, change.kind == kind && !change.what.empty() ? std::optional(change.what) : std::nullopt,
             more);
  };
  what("condition", ChangeKind::condition, {});
  what("multiplier", ChangeKind::stability, one_of({"real +1", "real -1", "complex pair"}));
  what("duration", ChangeKind::birth, {});
  what("frequency", ChangeKind::resonance, one_of({"omega1", "omega2"}));
  json.has("words", change.words);
  json.has("at", ball_text(change.at, ball_digits));
  const auto time = time_of(q, change);
  json.has("time", ball_text(time, ball_digits));
  json.has("verdict", change.verdict.truth, one_of({"proved", "undecided"}));
  json.has("reason", change.verdict.reason.empty() ? std::nullopt : std::optional(change.verdict.reason));
}

void write_end(Object& json, const BranchEnd& end) {
  json.has("at", ball_text(end.at, ball_digits));
  json.has(
      "kind", end.kind,
      with(names_through(End::stopped),
           "The parameter leaves its interval; a phase lasts no time; the branch is a closed curve; the "
           "motion grows beyond all bounds, as the parameter tends to a value in the ball; the branch is "
           "followed no further."));
  json.has("reason", end.words);
  json.has("resolved", end.resolved(), "Else the branch may go on.");
}

Json states() {
  return names_through(State::undecided, State::inadmissible);
}

void write_piece(Object& json, const Piece& piece) {
  json.has("from", ball_text(piece.first, ball_digits));
  json.has("to", ball_text(piece.last, ball_digits));
  json.has("state", piece.state, states());
  json.has("violates", piece.condition.empty() ? std::nullopt : std::optional(piece.condition));
}

void write_sample(Object& json, const OrbitOfBranch& sample) {
  json.has("value", sample.value);
  json.has("state", sample.state, states());
  json.each(sample.durations);
  json.has("phi", sample.phi);
  json.has("x10", sample.x10);
  json.has("x20", sample.x20);
  json.has("xdot10", sample.xdot10);
}

void write_branch(Object& json, const Branch& branch, const BranchQuestion& q) {
  json.has("from", ball_text(branch.first.at, ball_digits));
  json.has("to", ball_text(branch.last.at, ball_digits));
  json.has("closed", branch.closed);
  json.list("ends", std::array{branch.first, branch.last}, write_end, {{"minItems", 2}, {"maxItems", 2}});
  json.list("pieces", branch.pieces, write_piece);
  json.list("changes", branch.changes, [&](Object& to, const Change& c) { write_change(to, c, q); });
  json.list("samples", orbits_of(branch, q), write_sample, "In double: an orbit of each part of the proof.");
}

void write_count(Object& json, const Count& count) {
  const Json number = {{"minimum", 0}};
  json.has("from", ball_text(count.from, ball_digits));
  json.has("to", ball_text(count.to, ball_digits));
  json.has("orbits", count.orbits, number);
  json.has("admissible", count.admissible, number);
  json.has("stable", count.stable, number);
  json.has("unsettled", count.unsettled,
           with(number, "Of the admissible ones, those whose stability is undecided."));
  json.has(
      "undecided", count.undecided,
      with(number,
           "Further motions that close, of which it is undecided whether they are orbits or admissible."));
  json.has(
      "more", count.more,
      "An unresolved part may hold more orbits, which are on no branch; or a branch was followed no further: "
      "where it goes on it may have some here.");
}

// The dimensionless data, and the values of a machine in SI units, in its file or in JSON; but for the load's
// phase, on which no orbit depends.
Json parameter_names(const auto& in_SI, const auto& name) {
  std::vector<std::string> names{"chi", "eta", "us", "V", "omega", "p", "phi", "ur"};
  std::ranges::transform(in_SI, std::back_inserter(names), name);
  std::erase(names, "load_phase");
  return one_of(names);
}

void write_branches(Object& json, const BranchList& list) {
  const BranchQuestion& q = list.question;
  write_origin(json, command_of(q));
  json.has("family", q.orbits.family->name, {{"anyOf", {family_names(), like_word()}}});
  json.has("parameter", q.parameter,
           with(parameter_names(model::machine_values, &model::MachineValue::name),
                "From m1 on: of a machine in SI units, as its file names it."));
  json.has("interval", std::array{q.from, q.to});
  json.object(
      "parameters",
      [&](Object& to) {
        to.each(parameters_of(q), {}, {},
                {{"anyOf",
                  {like_number_or_range(),
                   with({{"pattern", "^[^.]+(\\.[0-9]+)?\\.\\.[^.]+(\\.[0-9]+)?$"}},
                        "Of a machine: from the one to the other as the parameter varies.")}}});
        to.rules({{"propertyNames", parameter_names(values_in_SI(SampleOf<DataTaken>::made().machine),
                                                    [](const auto& value) { return value.first; })}});
      },
      "All but the one that varies.");
  json.has("units", q.machine ? std::optional("si") : std::nullopt,
           with(one_of({"si"}),
                "Along a value of a machine: parameters, times, lengths and velocities are in SI units."));
  json.has("complete", list.complete,
           "Every orbit at any value of the interval is on a branch; else what is unresolved says where more "
           "may be.");
  json.has("at", q.at, "Only the branches of the orbits at this value were asked for.");
  json.list("branches", list.branches,
            [&](Object& to, const Branch& branch) { write_branch(to, branch, q); });
  json.list("counts", list.counts, write_count,
            "Orbits on these branches between values at which that changes.");
  json.list("unresolved", list.unresolved, [&](Object& to, const UnresolvedPart& part) {
    to.has("value", ball_text(part.value, ball_digits));
    to.each(ball_texts(where(q, part), ball_digits));
    to.has("reason", plain(part.reason));
    to.has(
        "resonance", part.resonance,
        "It is next to a resonance, where the interval is split; the parameter's own name has the value of "
        "the resonance, if it is known to lie inside.");
  });
  json.has("interrupted", list.interrupted);
}

}  // namespace

Json to_json(const BranchList& list) {
  return written(list, write_branches);
}

File branches_schema() {
  BranchList sample;
  sample.question.orbits.family = all_families().front();
  return schema_file("branches",
                     "stickslip branch: orbits over an interval of one parameter, every change proved",
                     schema_by(sample, write_branches));
}

}  // namespace stickslip::report::orbits
