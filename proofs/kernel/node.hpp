// The inside of a Term: for term.cpp, substitution.cpp and nobody else.
#pragma once

#include <cstdint>
#include <optional>

#include "proofs/kernel/term.hpp"

namespace stickslip::proofs::kernel {

struct Node {
  Kind kind = Kind::number;
  std::vector<Term> parts;
  std::string name = {};               // of a variable; of a binder a hint
  std::optional<Rational> value = {};  // of a number; exponent of a power; index of what is bound
  int row = 0;                         // of an entry; rows of a matrix
  int column = 0;
  Type binds = {};  // of a binder; the type of a variable and of what is bound
  std::optional<Definition> definition = {};

  // Computed by make():
  Type type = {};
  std::uint64_t hash = 0;
  long loose = 0;                    // no index in it reaches further than this many binders outside
  bool applies_definitions = false;  // it or a part of it
  std::shared_ptr<const Variables> variables = {};

  // The only way to a Term: checks sorts and shapes and throws KernelError; applies a lambda that is applied,
  // and takes λt. f(t) for f, so that equal functions look alike.
  [[nodiscard]] static Term make(Node node);
  [[nodiscard]] static const Node& of(const Term& term) { return *term.node_; }
  [[nodiscard]] static bool is_same(const Term& a, const Term& b) { return a.node_ == b.node_; }
};

[[nodiscard]] inline bool is_binder(Kind kind) {
  return kind == Kind::lambda || kind == Kind::for_all || kind == Kind::exists || kind == Kind::finite;
}

// The same node with other parts.
[[nodiscard]] Term rebuilt(const Term& term, std::vector<Term> parts);
// The body with `argument` for the index 0, and the other loose indices one lower.
[[nodiscard]] Term instantiated(const Term& body, const Term& argument);
// All loose indices moved by that many.
[[nodiscard]] Term shifted(const Term& term, long by, long above = 0);
// The variable as the index 0 of a binder to be put around.
[[nodiscard]] Term abstracted(const Term& body, const Variable& variable);

}  // namespace stickslip::proofs::kernel
