#include "numeric/machines/machine_orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "numeric/machines/linear_course.hpp"
#include "numeric/words/chain_proof.hpp"
#include "numeric/words/sweep.hpp"
#include "numeric/words/word.hpp"

namespace stickslip::numeric::machines {

using namespace motion;
using words::ChainProof;
using words::Node;
using words::Nodes;

namespace {

// How often an undecided condition or stability is looked at with four times the bits.
constexpr int more_attempts = 2;

Nodes nodes_of(const MachineGuess& guess, const Machine& machine) {
  const auto n = static_cast<Eigen::Index>(machine.oscillator.size());
  const Eigen::Index j = n + static_cast<Eigen::Index>(machine.oscillator.rubbing);
  const bool autonomous = machine.oscillator.is_autonomous();
  const std::size_t count = guess.events.size();
  Nodes nodes;
  for (std::size_t i = 0; i < count; ++i) {
    const MachineGuess::Event& event = guess.events[i];
    const double before = i == 0 ? guess.events[count - 1].t - guess.duration : guess.events[i - 1].t;
    Node u(2 * n);
    u(0) = Ball(autonomous ? event.t - before : event.t);
    for (Eigen::Index k = 0; k < 2 * n - 1; ++k) {
      u(k + 1) = Ball(event.X(k < j ? k : k + 1));
    }
    nodes.push_back(u);
  }
  return nodes;
}

// The orbit's distances from what would end its phases, and where they are zero.
class Judge {
 public:
  Judge(const MachineChain& chain, const Nodes& nodes, const MachineQuestion& question)
      : chain_(chain), nodes_(nodes), machine_(question.machine.oscillator), pieces_(question.pieces) {}

  std::vector<Condition> conditions(const std::vector<MachinePhase>& phases) {
    for (i_ = 0; i_ < pieces_.size(); ++i_) {
      phase_ = &phases[i_];
      add("duration", "each phase lasts");
      judge(list_.back(), phase_->duration, true, "the duration");
      forward_.emplace(linear(), pieces_[i_], chain_.beginning(nodes_, i_), phase_->duration, false);
      backward_.emplace(linear(), pieces_[i_], chain_.end(nodes_, i_), phase_->duration, true);
      bounds_ = forward_->bounds();
      pieces_[i_].kind == PhaseKind::stick ? stick() : slide();
    }
    return list_;
  }

 private:
  [[nodiscard]] const Piece& before() const { return pieces_[(i_ + pieces_.size() - 1) % pieces_.size()]; }
  [[nodiscard]] const Piece& after() const { return pieces_[(i_ + 1) % pieces_.size()]; }
  [[nodiscard]] const LinearPhases& linear() const { return chain_.phases(); }

  void add(const char * id, const std::string& statement) {
    list_.push_back({id, statement, {}, {}, {}, {}});
    list_.back().at = phase_->start;
  }

  void along(const char * id, const std::string& statement, int sign, const Ball& offset, Touches touches,
             const char * premise) {
    along(id, statement, sign, offset, touches, premise, 0);
  }
  // From a time on.
  void along(const char * id, const std::string& statement, int sign, const Ball& offset, Touches touches,
             const char * premise, double from) {
    add(id, statement);
    judge_along(list_.back(),
                {AffineCourse(*forward_, sign, offset, {0, from, 1}), AffineCourse(*backward_, sign, offset),
                 bounds_, phase_->start + Ball(from), phase_->duration - Ball(from), touches, premise, true});
  }

  // Where the friction drops by nothing the mass leaves the belt with x'' = 0: the distance grows as the
  // square of the time. Until the time that is returned its rate is judged in its place.
  double leaves_slowly(int side) {
    constexpr int parts = 64;
    const double T = phase_->duration.approximate();
    double turns = T / parts;
    while (turns < T && -side * forward_->guess_at(turns)[1] > 0) {
      turns += T / parts;
    }
    const double until = turns / 2;
    add("leaves", "the mass falls behind the belt, or gets ahead of it, faster and faster at first");
    const AffineCourse rate(*forward_, -side, Ball(0), {1, 0, 1});
    const AffineCourse reversed(*forward_, -side, Ball(0), {1, until, -1});
    judge_along(list_.back(), {rate,
                               reversed,
                               forward_->bounds(1),
                               phase_->start,
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

  void stick() {
    const model::FrictionOscillator<Ball>& o = linear().oscillator();
    constexpr const char * premise = "$r = ur$ at the end of the stick";
    along("stick.upper", "$r < ur$ while it sticks", -1, o.forward.at_rest,
          {false, after().kind == PhaseKind::slip}, premise);
    along("stick.lower", "$r > -ur$ while it sticks", 1, o.backward.at_rest,
          {false, after().kind == PhaseKind::overshoot}, premise);
  }

  void slide() {
    const Piece& piece = pieces_[i_];
    const bool slips = piece.kind == PhaseKind::slip;
    const model::FrictionOscillator<Ball>& o = linear().oscillator();
    const std::vector<model::SlidingPiece<Ball>>& law = o.law(piece.side()).sliding;
    if (before().kind != piece.kind && before().kind != PhaseKind::stick) {
      add("crossing", "$|r| > ur$ where a slip and an overshoot meet");
      Ball r(0);
      const Vector w = chain_.beginning(nodes_, i_);
      for (Eigen::Index k = 0; k < w.size(); ++k) {
        add_product(r, linear().friction_at_rest()(k), w(k));
      }
      judge(list_.back(), slips ? Ball(r - o.forward.at_rest) : Ball(-r - o.backward.at_rest), true,
            "the distance");
      if (list_.back().verdict.truth == Truth::refuted) {
        list_.back().violation = Violation{phase_->start, *list_.back().margin};
      }
    }
    const auto number = static_cast<std::size_t>(piece.number);
    // Which neighbour is on the other side of the upper end of the piece; a phase of another kind is on that
    // of the lower one.
    const auto is_above = [&](const Piece& other) {
      return other.kind == piece.kind && other.number > piece.number;
    };
    constexpr const char * premise =
        "the velocity of the belt or of the law's next piece at an end of the phase";
    const int side = piece.side();
    const Ball V = Ball(side) * o.V;
    const model::FrictionLaw<Rational>& exact = machine_.law(side);
    const bool slowly =
        number == 0 && before().kind == PhaseKind::stick && exact.sliding.front().force == exact.at_rest;
    const double from = slowly ? leaves_slowly(side) : 0;
    along(slips ? "slip" : "overshoot",
          number == 0 ? (slips ? "$x' < V$ while it slips" : "$x' > V$ while it overshoots")
                      : fmt::format("the relative velocity is above that where piece {} begins", number + 1),
          -side, V - law[number].from, {!slowly && !is_above(before()), !is_above(after())}, premise, from);
    if (number + 1 < o.law(side).pieces()) {
      along(slips ? "slip.piece" : "overshoot.piece",
            fmt::format("the relative velocity is below that where piece {} begins", number + 2), side,
            law[number + 1].from - V, {is_above(before()), is_above(after())}, premise);
    }
  }

  const MachineChain& chain_;
  const Nodes& nodes_;
  const model::FrictionOscillator<Rational>& machine_;
  const std::vector<Piece>& pieces_;
  std::size_t i_ = 0;
  const MachinePhase * phase_ = nullptr;
  std::optional<Watched> forward_, backward_;  // what ends the phase
  DerivativeBounds bounds_;
  std::vector<Condition> list_;
};

std::vector<MachinePhase> phases_of(const MachineChain& chain, const Nodes& nodes,
                                    const std::vector<Piece>& pieces) {
  std::vector<MachinePhase> phases;
  Ball start(0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Ball duration = chain.duration(nodes, i);
    phases.push_back({pieces[i], start, duration, chain.state(nodes, i)});
    start += duration;
  }
  return phases;
}

// Whether the motion may be a shorter one: through pieces that repeat themselves, and no state differs from
// the one as many phases later.
bool may_repeat(const std::vector<MachinePhase>& phases) {
  const std::size_t count = phases.size();
  for (std::size_t step = 1; step < count; ++step) {
    bool same = count % step == 0;
    for (std::size_t i = 0; same && i < count; ++i) {
      const MachinePhase& one = phases[i];
      const MachinePhase& later = phases[(i + step) % count];
      same = one.piece == later.piece && one.duration.overlaps(later.duration);
      for (Eigen::Index k = 0; same && k < one.state.size(); ++k) {
        same = one.state(k).overlaps(later.state(k));
      }
    }
    if (same) {
      return true;
    }
  }
  return false;
}

// Without a load the durations are results: a node is mapped to the next without its own.
std::optional<SquareMatrix> return_map(const MachineChain& chain, const ChainProof& proof) {
  if (!chain.phases().oscillator().is_autonomous()) {
    return proof.return_map;
  }
  std::vector<words::Link> links;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    links.push_back(chain.link(proof.nodes, i));
    const Eigen::Index n = links.back().M.rows() - 1;
    links.back().M = Matrix(links.back().M.bottomRightCorner(n, n));
  }
  const Eigen::Index n = links.front().M.rows();
  const auto found = words::sweep(links, Nodes(links.size(), Node::Constant(n, Ball(0))));
  return found ? std::optional<SquareMatrix>(found->return_map) : std::nullopt;
}

bool is_open(const MachineOrbit& orbit) {
  return orbit.admissible.truth == Truth::undecided ||
         (orbit.stability && orbit.stability->kind == StabilityKind::undecided);
}

void decide(MachineOrbit& orbit, const MachineQuestion& question, const ChainProof& proof) {
  const WorkingPrecision scope(proof.bits);
  const MachineChain chain(question);
  orbit.bits = proof.bits;
  orbit.phases = phases_of(chain, proof.nodes, question.pieces);
  orbit.period = Ball(0);
  for (const MachinePhase& phase : orbit.phases) {
    orbit.period += phase.duration;
  }
  orbit.load = Ball(0);
  const model::FrictionOscillator<Ball>& o = chain.phases().oscillator();
  if (!o.is_autonomous()) {
    orbit.period = Ball(2 * question.periods) * Ball::pi() / o.omega;
    orbit.load = o.omega * proof.nodes.front()(0);
  }
  if (may_repeat(orbit.phases)) {
    orbit.existence = Verdict::undecided("the motion may be a shorter one taken several times");
    return;
  }
  orbit.conditions = Judge(chain, proof.nodes, question).conditions(orbit.phases);
  orbit.admissible = admissible(orbit.conditions);
  if (orbit.admissible.truth == Truth::proved) {
    const bool sticks = std::any_of(question.pieces.begin(), question.pieces.end(),
                                    [](const Piece& piece) { return piece.kind == PhaseKind::stick; });
    const auto map = return_map(chain, proof);
    orbit.stability = map ? std::optional(stability_of(*map, sticks)) : std::nullopt;
  }
}

}  // namespace

std::string word_of(const std::vector<Piece>& pieces, bool with_pieces) {
  if (with_pieces) {
    std::string text;
    for (const Piece& piece : pieces) {
      text += words::letter(piece.kind);
      text += piece.kind == PhaseKind::stick ? "" : fmt::format("{}", piece.number + 1);
    }
    return text;
  }
  std::string letters;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& before = pieces[(i + pieces.size() - 1) % pieces.size()];
    if (before.kind != pieces[i].kind) {
      letters += words::letter(pieces[i].kind);
    }
  }
  std::rotate(letters.begin(), letters.begin() + static_cast<std::ptrdiff_t>(words::first_rotation(letters)),
              letters.end());
  return letters;
}

MachineOrbit prove_machine_orbit(const Machine& machine, const MachineGuess& guess, int digits,
                                 long most_bits) {
  require_machine(machine);
  if (guess.events.size() < 2) {
    throw DomainError("a guess of a periodic motion", fmt::format("{} events", guess.events.size()),
                      "at least two");
  }
  MachineQuestion question{machine, {}, guess.periods};
  for (const MachineGuess::Event& event : guess.events) {
    question.pieces.push_back(event.begins);
  }
  Nodes nodes = nodes_of(guess, machine);
  MachineOrbit orbit;
  orbit.pieces = question.pieces;
  orbit.periods = guess.periods;
  long bits = scalars::bits_for(digits) + 32;
  for (int attempt = 0; attempt <= more_attempts && bits <= most_bits; ++attempt) {
    const ChainProof proof = prove_chain(chain_at(question), nodes, bits, most_bits);
    if (proof.verdict.truth != Truth::proved) {
      orbit.existence = attempt == 0 ? proof.verdict : orbit.existence;
      break;
    }
    orbit.existence = Verdict::proved();
    decide(orbit, question, proof);
    if (!is_open(orbit)) {
      break;
    }
    nodes = words::midpoints(proof.nodes);
    bits = 4 * proof.bits;
  }
  return orbit;
}

MachineGuess guess_of(const MachineOrbit& orbit, const Machine& machine) {
  MachineGuess guess{{}, orbit.periods, orbit.period.approximate()};
  const bool autonomous = machine.oscillator.is_autonomous();
  const double begin = autonomous ? 0 : orbit.load.approximate() / oscillator_as<double>(machine).omega;
  for (const MachinePhase& phase : orbit.phases) {
    guess.events.push_back({begin + phase.start.approximate(),
                            phase.state.unaryExpr([](const Ball& x) { return x.approximate(); }),
                            phase.piece});
  }
  return guess;
}

double distance(const MachineGuess& a, const MachineGuess& b) {
  double farthest = std::abs(a.duration - b.duration) / b.duration;
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    const auto next = [&](const MachineGuess& g) {
      return (i + 1 < g.events.size() ? g.events[i + 1].t : g.events[0].t + g.duration) - g.events[i].t;
    };
    farthest = std::max({farthest, std::abs(next(a) - next(b)) / b.duration,
                         (a.events[i].X - b.events[i].X).lpNorm<Eigen::Infinity>() /
                             std::max(b.events[i].X.lpNorm<Eigen::Infinity>(), 1e-300)});
  }
  return farthest;
}

}  // namespace stickslip::numeric::machines
