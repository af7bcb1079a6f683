#include "numeric/machines/judge.hpp"

#include <fmt/format.h>

#include "numeric/machines/linear_course.hpp"

namespace stickslip::numeric::machines {

using motion::Condition;
using motion::PhaseKind;
using motion::Touches;

namespace {

class Judge {
 public:
  Judge(std::vector<Condition>& list, const LinearPhases& phases,
        const model::FrictionOscillator<Rational>& exact, const JudgedPhase& phase)
      : list_(list),
        linear_(phases),
        exact_(exact),
        phase_(phase),
        forward_(phases, phase.piece, phase.begin, phase.duration, false),
        backward_(phases, phase.piece, phase.end, phase.duration, true),
        bounds_(forward_.bounds()) {}

  void stick() {
    const model::FrictionOscillator<Ball>& o = linear_.oscillator();
    constexpr const char * premise = "$r = ur$ at the end of the stick";
    along("stick.upper", "$r < ur$ while it sticks", -1, o.forward.at_rest,
          {false, phase_.after && phase_.after->kind == PhaseKind::slip}, premise);
    along("stick.lower", "$r > -ur$ while it sticks", 1, o.backward.at_rest,
          {false, phase_.after && phase_.after->kind == PhaseKind::overshoot}, premise);
  }

  void slide() {
    const Piece& piece = phase_.piece;
    const bool slips = piece.kind == PhaseKind::slip;
    const model::FrictionOscillator<Ball>& o = linear_.oscillator();
    const std::vector<model::SlidingPiece<Ball>>& law = o.law(piece.side()).sliding;
    const bool from_stick = phase_.before && phase_.before->kind == PhaseKind::stick;
    if (phase_.before && phase_.before->kind != piece.kind && !from_stick) {
      crossing(slips);
    }
    const auto number = static_cast<std::size_t>(piece.number);
    // Which neighbour is on the other side of the upper end of the piece; a phase of another kind is on that
    // of the lower one.
    const auto is_above = [&](const std::optional<Piece>& other) {
      return other && other->kind == piece.kind && other->number > piece.number;
    };
    const auto is_below = [&](const std::optional<Piece>& other) { return other && !is_above(other); };
    constexpr const char * premise =
        "the velocity of the belt or of the law's next piece at an end of the phase";
    const int side = piece.side();
    const Ball V = Ball(side) * o.V;
    const model::FrictionLaw<Rational>& exact = exact_.law(side);
    const bool slowly = number == 0 && from_stick && exact.sliding.front().force == exact.at_rest;
    const double from = slowly ? leaves_slowly(side) : 0;
    along(slips ? "slip" : "overshoot",
          number == 0 ? (slips ? "$x' < V$ while it slips" : "$x' > V$ while it overshoots")
                      : fmt::format("the relative velocity is above that where piece {} begins", number + 1),
          -side, V - law[number].from, {!slowly && is_below(phase_.before), is_below(phase_.after)}, premise,
          from);
    if (number + 1 < o.law(side).pieces()) {
      along(slips ? "slip.piece" : "overshoot.piece",
            fmt::format("the relative velocity is below that where piece {} begins", number + 2), side,
            law[number + 1].from - V, {is_above(phase_.before), is_above(phase_.after)}, premise);
    }
  }

 private:
  void add(const char * id, const std::string& statement) {
    list_.push_back({id, statement, {}, {}, {}, {}});
    list_.back().at = phase_.start;
  }

  void along(const char * id, const std::string& statement, int sign, const Ball& offset, Touches touches,
             const char * premise, double from = 0) {
    add(id, statement);
    judge_along(list_.back(),
                {AffineCourse(forward_, sign, offset, {0, from, 1}), AffineCourse(backward_, sign, offset),
                 bounds_, phase_.start + Ball(from), phase_.duration - Ball(from), touches, premise, true});
  }

  void crossing(bool slips) {
    const model::FrictionOscillator<Ball>& o = linear_.oscillator();
    add("crossing", "$|r| > ur$ where a slip and an overshoot meet");
    Ball r(0);
    for (Eigen::Index k = 0; k < phase_.begin.size(); ++k) {
      add_product(r, linear_.friction_at_rest()(k), phase_.begin(k));
    }
    judge(list_.back(), slips ? Ball(r - o.forward.at_rest) : Ball(-r - o.backward.at_rest), true,
          "the distance");
    if (list_.back().verdict.truth == Truth::refuted) {
      list_.back().violation = motion::Violation{phase_.start, *list_.back().margin};
    }
  }

  // Where the friction drops by nothing the mass leaves the belt with x'' = 0: the distance grows as the
  // square of the time. Until the time that is returned its rate is judged in its place.
  double leaves_slowly(int side) {
    constexpr int parts = 64;
    const double T = phase_.duration.approximate();
    double turns = T / parts;
    while (turns < T && -side * forward_.guess_at(turns)[1] > 0) {
      turns += T / parts;
    }
    const double until = turns / 2;
    add("leaves", "the mass falls behind the belt, or gets ahead of it, faster and faster at first");
    const AffineCourse rate(forward_, -side, Ball(0), {1, 0, 1});
    const AffineCourse reversed(forward_, -side, Ball(0), {1, until, -1});
    judge_along(list_.back(), {rate,
                               reversed,
                               forward_.bounds(1),
                               phase_.start,
                               Ball(until),
                               {true, false},
                               "$r = ur$ at the end of the stick",
                               true});
    if (list_.back().verdict.truth == Truth::refuted) {
      list_.back().verdict = Verdict::undecided("its velocity turns early: " + list_.back().verdict.reason);
      list_.back().violation.reset();
    }
    return until;
  }

  std::vector<Condition>& list_;
  const LinearPhases& linear_;
  const model::FrictionOscillator<Rational>& exact_;
  const JudgedPhase& phase_;
  Watched forward_, backward_;  // what ends the phase
  motion::DerivativeBounds bounds_;
};

}  // namespace

void judge_phase(std::vector<Condition>& list, const LinearPhases& phases,
                 const model::FrictionOscillator<Rational>& exact, const JudgedPhase& phase) {
  list.push_back({"duration", "each phase lasts", {}, {}, {}, {}});
  list.back().at = phase.start;
  judge(list.back(), phase.duration, true, "the duration");
  Judge judge(list, phases, exact, phase);
  phase.piece.kind == PhaseKind::stick ? judge.stick() : judge.slide();
}

}  // namespace stickslip::numeric::machines
