// Truth has more than two values, and every value but "proved" says why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/ball.hpp"
#include "core/rational.hpp"

namespace stickslip {

// A sentence without the dollars around its formulas. Sentences for readers, such as reasons, have them: "the
// distance is 0 where $z2' = V$".
[[nodiscard]] std::string plain(std::string sentence);

enum class Truth {
  proved,
  refuted,    // with a witness
  undecided,  // with the reason
  assumed,    // an equation of the model: there is nothing to decide
  checked,    // a computation in floating point agrees, which proves nothing; the reason says how well
};

[[nodiscard]] std::string to_string(Truth truth);

// One coordinate of a point at which a statement was evaluated.
struct Coordinate {
  std::string name;  // the paper's symbol in plain text: "omega1", "tau"
  Rational value;
};

// A point at which the two sides of a statement are disjoint balls.
struct Witness {
  std::vector<Coordinate> point;
  std::string component;  // which entry of a vector or matrix statement: "(2,1)"; empty for a scalar
  Ball left;
  Ball right;
  // What the two are, where the statement shows no two sides: "$x_1(tau)$".
  std::string left_name = "the left side";
  std::string right_name = "the right side";
  std::vector<std::string> values = {};  // of what else the sides speak of, as it follows there: "$x = 0$"
};

struct Verdict {
  Truth truth = Truth::undecided;
  std::string reason;  // one sentence; empty only for proved
  std::optional<Witness> witness;

  // Proved or refuted.
  [[nodiscard]] bool is_decided() const { return truth == Truth::proved || truth == Truth::refuted; }

  [[nodiscard]] static Verdict proved() { return {Truth::proved, {}, {}}; }
  [[nodiscard]] static Verdict refuted(Witness witness);
  // For statements about numbers, where the balls stand in the reason.
  [[nodiscard]] static Verdict refuted(std::string reason) { return {Truth::refuted, std::move(reason), {}}; }
  [[nodiscard]] static Verdict undecided(std::string reason) {
    return {Truth::undecided, std::move(reason), {}};
  }
  [[nodiscard]] static Verdict assumed(std::string reason) { return {Truth::assumed, std::move(reason), {}}; }
  [[nodiscard]] static Verdict checked(std::string reason) { return {Truth::checked, std::move(reason), {}}; }
};

// The verdict on "all of them hold": the first refuted one, else the first undecided, checked, assumed, else
// proved. The conjunction of nothing is undecided: a proof that looked at nothing proves nothing.
[[nodiscard]] Verdict all_of(const std::vector<Verdict>& verdicts);

}  // namespace stickslip
