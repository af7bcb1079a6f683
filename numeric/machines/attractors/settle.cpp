#include "numeric/machines/attractors/settle.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/domain.hpp"
#include "numeric/words/word.hpp"

namespace stickslip::numeric::machines {

namespace {

using attractors::AnyFollower;
using attractors::FollowerOf;
using attractors::Kind;
using attractors::Return;

constexpr double nearness = 1e-9;
// Two states of a motion that has returned nearer than this are one.
constexpr double same_state = 1e-6;

// Begun at the first rotation of its word.
MachineGuess rotated(const MachineGuess& guess) {
  const std::vector<std::size_t> begins = begins_of_phases(guess.pieces());
  std::string letters;
  for (const std::size_t i : begins) {
    letters += words::letter(guess.events[i].begins.kind);
  }
  return begins.empty() ? guess : guess.begun_at(begins[words::first_rotation(letters)]);
}

template <int N, int L>
Followers begun(const model::FrictionOscillator<double>& o, const std::vector<Eigen::VectorXd>& starts) {
  Followers followers;
  simulation::SimulationOf<N, L> simulation(o, 0, starts.front());
  for (const Eigen::VectorXd& X : starts) {
    simulation.restart(0, X);
    followers.push_back(std::make_unique<FollowerOf<N, L>>(o, simulation, scale_of(o)));
  }
  return followers;
}

}  // namespace

Return tidied(const Machine& machine, const Return& seen) {
  const auto o = oscillator_as<double>(machine);
  Return result = shortest(seen, !o.is_autonomous(), same_state, scale_of(o));
  result.guess = rotated(result.guess);
  return result;
}

Followers followers_of(const Machine& machine, const std::vector<Eigen::VectorXd>& starts) {
  require_machine(machine);
  const auto size = static_cast<Eigen::Index>(2 * machine.oscillator.size());
  for (const Eigen::VectorXd& X : starts) {
    require(X.size() == size, "the state", fmt::format("{} numbers", X.size()),
            fmt::format("{}, positions and velocities", size));
  }
  if (starts.empty()) {
    return {};
  }
  const model::FrictionOscillator<double> o = oscillator_as<double>(machine);
  const auto varying = [](const auto& load) { return load.k != 0; };
  const auto first = std::ranges::find_if(o.loads, varying);
  const bool one_frequency = first != o.loads.end() && std::ranges::all_of(o.loads, [&](const auto& load) {
                               return !varying(load) || load.k == first->k;
                             });
  return o.size() == 2 && one_frequency ? begun<2, 1>(o, starts)
                                        : begun<Eigen::Dynamic, Eigen::Dynamic>(o, starts);
}

Settled settle(const Machine& machine, const Eigen::VectorXd& X, long most_periods) {
  const auto follower = std::move(followers_of(machine, {X}).front());
  follower->follow(most_periods, nearness);
  follower->classify(most_periods / 4);
  const auto seen = follower->returned();
  return {follower->kind(), seen ? tidied(machine, *seen).guess : MachineGuess(),
          seen ? seen->once.front() : follower->state()};
}

MachineGuess over_periods(const Machine& machine, const Eigen::VectorXd& X, long n) {
  const auto follower = std::move(followers_of(machine, {X}).front());
  if (machine.oscillator.is_autonomous()) {
    throw UsageError("periods of the load are counted where there is a load that varies");
  }
  return rotated(follower->over_periods(n).guess);
}

}  // namespace stickslip::numeric::machines
