#include "numeric/branches/branches.hpp"

#include <algorithm>

#include "core/interruption.hpp"
#include "core/names.hpp"
#include "numeric/branches/changes.hpp"
#include "numeric/branches/resonance.hpp"
#include "numeric/branches/search.hpp"
#include "numeric/branches/setting.hpp"

namespace stickslip::numeric::branches {

namespace {

void trace(const BranchQuestion& question, const Law& law, const Sheet& sheet, const Followed& followed,
           BranchList& list) {
  Branch branch;
  branch.cells = followed.cells.size();
  branch.closed = followed.closed;
  branch.first = followed.first;
  branch.last = followed.last;
  const std::vector<Part> parts = parts_of(sheet.curve, law, followed.cells, resolution / 64);
  describe({sheet.curve, law, followed.cells, parts}, branch, list.unresolved);
  // A part that begins or ends with the branch or the interval is enclosed a little beyond it.
  if (branch.first.kind == End::infinite && !branch.pieces.empty()) {
    branch.pieces.front().first = branch.first.at;
  }
  if (branch.last.kind == End::infinite && !branch.pieces.empty()) {
    branch.pieces.back().last = branch.last.at;
  }
  for (Piece& piece : branch.pieces) {
    for (Ball * end : {&piece.first, &piece.last}) {
      if (!(*end - Ball(question.to)).is_negative()) {
        *end = Ball(question.to);
      } else if (!(*end - Ball(question.from)).is_positive()) {
        *end = Ball(question.from);
      }
    }
  }
  for (const BranchEnd * end : {&branch.first, &branch.last}) {
    if (!end->resolved()) {
      list.unresolved.push_back({end->at, {}, end->words, end->resonance});
    }
  }
  if (!branch.pieces.empty()) {
    list.branches.push_back(std::move(branch));
    if (question.found) {
      question.found(list.branches.back());
    }
  }
}

// Of a part of the interval, with all that is in it.
BranchList list_between(const BranchQuestion& question) {
  BranchList list;
  const Law law = law_of(question);
  const AllFollowed all = follow_all(question);
  list.unresolved = all.unresolved;
  for (const Sheet& sheet : all.sheets) {
    for (const Followed& branch : sheet.branches) {
      trace(question, law, sheet, branch, list);
    }
  }
  if (!question.at || !list.branches.empty()) {
    list.counts =
        counts_of(question, list.branches, question.at ? std::vector<UnresolvedPart>{} : all.unresolved);
  }
  list.complete = all.complete;
  return list;
}

// The branches that end at that value, where the part ends, are followed no further.
void stop_at(const Multiple& multiple, const Rational& value, BranchList& part) {
  for (Branch& branch : part.branches) {
    for (BranchEnd * end : {&branch.first, &branch.last}) {
      if (end->kind == End::interval && end->at.contains(Ball(value))) {
        *end = {end->at, "followed no further: next to the resonance " + multiple.name, End::stopped, true};
      }
    }
  }
}

}  // namespace

std::string to_string(State state) {
  return name_of<State::undecided>(state, "outside", "absent", "not admissible", "stable", "unstable",
                                   "marginal", "admissible", "undecided");
}

bool is_admissible(State state) {
  return state == State::stable || state == State::unstable || state == State::marginal ||
         state == State::admissible;
}

std::string to_string(End end) {
  return name_of<End::stopped>(end, "interval", "birth", "closed", "infinity", "stopped");
}

std::string to_string(ChangeKind kind) {
  return name_of<ChangeKind::resonance>(kind, "fold", "condition", "stability", "birth", "resonance");
}

BranchList list_branches(const BranchQuestion& question) {
  require_question(question);
  BranchList list;
  list.question = question;
  list.complete = true;
  const std::vector<Multiple> multiples = multiples_in(question);
  // Between the one and the next.
  for (std::size_t k = 0; k <= multiples.size(); ++k) {
    const Multiple * before = k > 0 ? &multiples[k - 1] : nullptr;
    const Multiple * after = k < multiples.size() ? &multiples[k] : nullptr;
    BranchQuestion between = question;
    between.from = before != nullptr ? before->to : question.from;
    between.to = after != nullptr ? after->from : question.to;
    const auto is_asked = [&](const Rational& from, const Rational& to) {
      return !question.at || (from <= *question.at && *question.at <= to);
    };
    if (between.from < between.to && is_asked(between.from, between.to)) {
      BranchList part = list_between(between);
      for (const auto& [multiple, value] : {std::pair(before, between.from), std::pair(after, between.to)}) {
        if (multiple != nullptr) {
          stop_at(*multiple, value, part);
        }
      }
      std::ranges::move(part.branches, std::back_inserter(list.branches));
      std::ranges::move(part.unresolved, std::back_inserter(list.unresolved));
      std::ranges::move(part.counts, std::back_inserter(list.counts));
      list.complete = list.complete && part.complete;
    }
    if (after != nullptr &&
        is_asked(between.from, k + 1 < multiples.size() ? multiples[k + 1].from : question.to)) {
      list.unresolved.push_back(left_out(*after, question.parameter));
    }
  }
  list.interrupted = interrupted();
  list.complete = list.complete && multiples.empty() && !list.interrupted;
  return list;
}

}  // namespace stickslip::numeric::branches
