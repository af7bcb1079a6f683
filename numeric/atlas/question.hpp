// What an atlas is asked: a family of orbits over a rectangle of parameters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/rational.hpp"
#include "numeric/atlas/tile.hpp"
#include "numeric/families/family.hpp"

namespace stickslip::numeric::atlas {

// [lower, upper], both included.
struct Interval {
  Rational lower, upper;
  [[nodiscard]] bool is_point() const { return lower == upper; }
  [[nodiscard]] std::string text() const;  // "A..B", or the number
};

// What a rectangle is of: the data of (2), or the values of a machine in SI units, whose friction is two
// coefficients of a normal force, or two forces.
enum class Values { data, coefficients, forces };

// One interval for each of names_of, except the last, which may be missing. Of the data these are chi, eta,
// us, V, omega, p and, if it is given, one datum more: phi for a family that takes it, else ur.
using Box = std::vector<Interval>;
inline constexpr std::size_t place_of_chi = 0, place_of_eta = 1, place_of_us = 2, place_of_V = 3,
                             place_of_omega = 4, place_of_p = 5, place_of_datum = 6;

struct Question {
  const families::Family * family = nullptr;
  Box region;
  std::vector<std::size_t> axes;  // the places in `region` of what varies, one to four
  int resolution = 12;            // each axis is halved so many times at most
  Values values = Values::data;

  [[nodiscard]] bool is_in_SI() const { return values != Values::data; }
  [[nodiscard]] int finest() const { return resolution * static_cast<int>(axes.size()); }
};

[[nodiscard]] bool takes_phi(const families::Family& family);

// In the order of a Box, all of them; those of a machine in SI units as its file has them.
[[nodiscard]] const std::vector<std::string>& names_of(const families::Family& family, Values values);
[[nodiscard]] inline const std::vector<std::string>& names_of(const Question& question) {
  return names_of(*question.family, question.values);
}
[[nodiscard]] std::vector<std::string> axis_names(const Question& question);
// Where in a Box the name, one of these, stands.
[[nodiscard]] std::size_t place_of(const Question& question, std::string_view name);
// The velocity of the belt and the load's amplitude: V and p, or what is a positive multiple of them for a
// machine.
[[nodiscard]] const Interval& belt_of(const Question& question, const Box& box);
[[nodiscard]] const Interval& load_of(const Question& question, const Box& box);

// Throws UsageError unless a family that atlases can be made of is asked about, one to four parameters vary,
// and the finest tiles have at most most_depth halvings; DomainError unless all values of machines in SI
// units are those of one: > 0, of the belt and the load >= 0, and friction at rest exceeds sliding friction;
// and unless ur > us somewhere.
void require_understood(const Question& question);

// The parameters of a tile, or the values of machines, exactly.
[[nodiscard]] Box box_of(const Question& question, Tile tile);

// The question in one line that says all of it, for files; what follows `stickslip atlas` in bash.
[[nodiscard]] std::string text_of(const Question& question);

// Why a box is left open.
enum class Reason : std::uint8_t {
  none = 0,
  outside,       // of the domain, for all members
  reaches_out,   // of the domain, for some
  resonance,     // a natural frequency may be a multiple of the load's, for orbits that never stick
  no_load,       // p = 0 for some members, where both load phases of symmetric orbits are one
  idle_load,     // the load may not act on x2, for orbits that never stick and V = 0
  belt_at_rest,  // V = 0 for some members, where the equations of orbits that never stick change
  merging,       // two orbits may be one
  no_time,       // an orbit one of whose phases may last no time at all
  no_amplitude,  // the closing conditions may have no solution with a finite amplitude
  too_many,      // more orbits than most_orbits
  stability,     // a multiplier may lie on the unit circle
  condition,     // this and what follows: the requirement of that number may hold or not
};

// A byte of the log holds a number of orbits, and that none is known.
inline constexpr std::size_t most_orbits = 127;

// What is proved for every member of a box; a number that is not known is -1. When all are known there is no
// reason left.
struct Finding {
  std::int8_t orbits = -1;      // closed motions of the family with positive durations
  std::int8_t admissible = -1;  // of these, obeying every condition
  std::int8_t stable = -1;      // of the latter: asymptotically, by the multipliers
  std::uint8_t reason = 0;      // a Reason; from Reason::condition on, counted up by the requirement

  [[nodiscard]] bool is_decided() const { return reason == 0; }
  friend bool operator==(const Finding&, const Finding&) = default;
};

// A sentence for the reason, without a full stop.
[[nodiscard]] std::string sentence_of(const families::Family& family, std::uint8_t reason);

// A box of which nothing more is asked, and what was found.
struct Leaf {
  Tile tile = 0;
  Finding finding;
  friend bool operator==(const Leaf&, const Leaf&) = default;
};

}  // namespace stickslip::numeric::atlas
