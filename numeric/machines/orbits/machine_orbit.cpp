#include "numeric/machines/orbits/machine_orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/domain.hpp"
#include "numeric/machines/orbits/judge.hpp"
#include "numeric/words/word.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using namespace motion;

namespace {

// How often an undecided condition or stability is looked at with four times the bits.
constexpr int more_attempts = 2;

// Without a load the durations are results: a node is mapped to the next without its own, which adds nothing
// but a multiplier 0 to those of the chain. Of all machines between two the chain's map is the narrower.
std::optional<SquareMatrix> return_map(const Chain& chain, const ChainProof& proof) {
  if (!chain.phases().oscillator().is_autonomous() || chain.phases().is_over_data()) {
    return proof.return_map;
  }
  std::vector<Link> links;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    links.push_back(chain.link(proof.nodes, i));
    const Eigen::Index n = links.back().M.c[0].rows() - 1;
    links.back().M.c[0] = Matrix(links.back().M.c[0].bottomRightCorner(n, n));
  }
  const auto found = LinearChain::of(links);
  return found ? std::optional<SquareMatrix>(found->return_map()) : std::nullopt;
}

bool is_open(const MachineOrbit& orbit) {
  return orbit.admissible.truth == Truth::undecided ||
         (orbit.stability && orbit.stability->kind == StabilityKind::undecided);
}

// With so many bits.
void judge_all(MachineOrbit& orbit, const MachineQuestion& question, const ChainProof& proof, long bits) {
  const WorkingPrecision scope(bits);
  const Chain chain(question);
  const std::vector<Piece>& pieces = question.pieces;
  const std::size_t count = pieces.size();
  const auto w_at = [&](std::size_t i) {
    return proof.in_data.empty() ? InData<Matrix>(Matrix(chain.beginning(proof.nodes, i)))
                                 : chain.beginning(proof.in_data, i);
  };
  orbit.conditions.clear();
  for (std::size_t i = 0; i < count; ++i) {
    judge_phase(orbit.conditions, chain.phases(), question.machine.oscillator,
                {pieces[(i + count - 1) % count], pieces[i], pieces[(i + 1) % count], orbit.phases[i].start,
                 orbit.phases[i].duration, w_at(i), w_at((i + 1) % count)});
  }
  orbit.admissible = admissible(orbit.conditions);
}

}  // namespace

std::vector<Piece> MachineGuess::pieces() const {
  std::vector<Piece> all;
  std::ranges::transform(events, std::back_inserter(all), &Event::begins);
  return all;
}

double MachineGuess::lasts(std::size_t i) const {
  return (i + 1 < events.size() ? events[i + 1].t : events[0].t + duration) - events[i].t;
}

MachineGuess MachineGuess::begun_at(std::size_t i) const {
  MachineGuess result = *this;
  for (std::size_t k = 0; k < i; ++k) {
    result.events[k].t += duration;
  }
  std::rotate(result.events.begin(), result.events.begin() + static_cast<std::ptrdiff_t>(i),
              result.events.end());
  return result;
}

MachineGuess MachineGuess::once_of(long times, bool has_load) const {
  MachineGuess once{events, has_load ? periods / times : 1, duration / static_cast<double>(times)};
  once.events.resize(events.size() / static_cast<std::size_t>(times));
  return once;
}

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

MachineOrbit decided(const MachineQuestion& question, const ChainProof& proof) {
  const WorkingPrecision scope(proof.bits);
  const Chain chain(question);
  MachineOrbit orbit;
  orbit.pieces = question.pieces;
  orbit.periods = question.periods;
  orbit.existence = proof.verdict;
  orbit.bits = proof.bits;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Ball duration = chain.duration(proof.nodes, i);
    orbit.phases.push_back({question.pieces[i], orbit.period, duration, chain.state(proof.nodes, i)});
    orbit.period += duration;
  }
  const model::FrictionOscillator<Ball>& o = chain.phases().oscillator();
  if (!o.is_autonomous()) {
    orbit.period = Ball(2 * question.periods) * Ball::pi() / o.omega;
    orbit.load = o.omega * proof.nodes.front()(0);
  }
  const auto is_smooth = [&](const Piece& piece) { return chain.phases().is_smooth(piece); };
  const auto is_undecided = [](const Condition& c) { return c.verdict.truth == Truth::undecided; };
  const auto is_stick = [](const Piece& piece) { return piece.kind == PhaseKind::stick; };
  const bool costly = std::ranges::any_of(question.pieces, is_smooth);
  judge_all(orbit, question, proof, costly ? proof.bits : few_bits);
  if (!costly && proof.bits > few_bits && std::ranges::any_of(orbit.conditions, is_undecided)) {
    judge_all(orbit, question, proof, proof.bits);
  }
  if (orbit.admissible.truth == Truth::proved) {
    if (const auto map = return_map(chain, proof)) {
      orbit.stability = stability_of(*map, std::ranges::any_of(question.pieces, is_stick));
    }
  }
  return orbit;
}

std::vector<std::size_t> begins_of_phases(const std::vector<Piece>& pieces) {
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].kind != pieces[(i + pieces.size() - 1) % pieces.size()].kind) {
      begins.push_back(i);
    }
  }
  return begins;
}

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
  for (const std::size_t i : begins_of_phases(pieces)) {
    letters += words::letter(pieces[i].kind);
  }
  if (letters.empty() && !pieces.empty()) {  // it never leaves this phase
    letters = words::letter(pieces[0].kind);
  }
  return words::in_first_rotation(letters);
}

std::pair<Verdict, long> prove_while_open(const MachineQuestion& question, const MachineGuess& guess,
                                          int digits, long most_bits, int more_attempts,
                                          const std::function<bool(const ChainProof&)>& decide) {
  Nodes nodes = nodes_of(guess, question.machine);
  Verdict existence;
  long bits = scalars::bits_for(digits) + 32;
  for (int attempt = 0; attempt <= more_attempts && bits <= most_bits; ++attempt) {
    const ChainProof proof = prove_chain(question, nodes, bits, most_bits);
    if (proof.verdict.truth != Truth::proved) {
      existence = attempt == 0 ? proof.verdict : existence;
      break;
    }
    const auto [times, verdict] = repetition(question, proof);
    existence = verdict;
    if (verdict.truth != Truth::proved || times > 1) {
      return {verdict, verdict.truth == Truth::proved ? times : 1};
    }
    if (!decide(proof)) {
      break;
    }
    nodes = midpoints(proof.nodes);
    bits = 4 * proof.bits;
  }
  return {existence, 1};
}

MachineOrbit prove_machine_orbit(const Machine& machine, const MachineGuess& guess, int digits,
                                 long most_bits) {
  require_machine(machine);
  require(guess.events.size() >= 2, "a guess of a periodic motion",
          fmt::format("{} events", guess.events.size()), "at least two");
  const MachineQuestion question{machine, guess.pieces(), guess.periods};
  MachineOrbit orbit;
  orbit.pieces = question.pieces;
  orbit.periods = guess.periods;
  for (std::size_t k = 0; k < orbit.pieces.size(); ++k) {
    if (!may_follow(orbit.pieces[k], orbit.pieces[(k + 1) % orbit.pieces.size()])) {
      orbit.existence = Verdict::undecided("two of its phases cannot follow each other");
      return orbit;
    }
  }
  const auto [existence, times] =
      prove_while_open(question, guess, digits, most_bits, more_attempts, [&](const ChainProof& proof) {
        orbit = decided(question, proof);
        return is_open(orbit);
      });
  if (times > 1) {
    return prove_machine_orbit(machine, guess.once_of(times, !machine.oscillator.is_autonomous()), digits,
                               most_bits);
  }
  orbit.existence = existence;
  return orbit;
}

MachineGuess guess_of(const MachineOrbit& orbit, const Machine& machine) {
  MachineGuess guess{{}, orbit.periods, orbit.period.approximate()};
  const bool autonomous = machine.oscillator.is_autonomous();
  const double begin = autonomous ? 0 : orbit.load.approximate() / oscillator_as<double>(machine).omega;
  for (const MachinePhase& phase : orbit.phases) {
    guess.events.push_back({begin + phase.start.approximate(), zeros::in_double(phase.state), phase.piece});
  }
  return guess;
}

MachineGuess guess_of(const Motion& motion, long periods) {
  const model::Oscillator<Ball>& o = motion.oscillator;
  MachineGuess guess{{}, periods, Ball(Ball(2 * periods) * Ball::pi() / o.data.omega).approximate()};
  const double begin = Ball(motion.phases.front().load / o.data.omega).approximate();
  for (const Phase& phase : motion.phases) {
    model::Vector4<Ball> X = phase.Z;
    X.head<2>() += o.d0;
    guess.events.push_back({begin + phase.start.approximate(), zeros::in_double(X), {phase.kind}});
  }
  return guess;
}

double distance(const MachineGuess& a, const MachineGuess& b) {
  double farthest = std::abs(a.duration - b.duration) / b.duration;
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    farthest = std::max({farthest, std::abs(a.lasts(i) - b.lasts(i)) / b.duration,
                         (a.events[i].X - b.events[i].X).lpNorm<Eigen::Infinity>() /
                             std::max(b.events[i].X.lpNorm<Eigen::Infinity>(), 1e-300)});
  }
  return farthest;
}

}  // namespace stickslip::numeric::machines
