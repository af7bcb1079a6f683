// The nodes there are: for term.cpp and nobody else.
#pragma once

#include <algorithm>
#include <unordered_map>

#include "proofs/kernel/node.hpp"

namespace stickslip::proofs::kernel {

// The nodes of this thread that are alive, by hash. What is built alike, hints included, is one node: then
// most comparisons are of two pointers.
class Pool {
 public:
  // The node that is built alike, if there is one; else the one that `make` makes of it, which makes no
  // other.
  template <class Make>
  [[nodiscard]] std::shared_ptr<const Node> shared(const Node& node, const Make& make) {
    const auto [first, last] = nodes_.equal_range(node.hash);
    auto dead = last;
    for (auto one = first; one != last; ++one) {
      auto known = one->second.lock();
      if (known && alike(*known, node)) {
        return known;
      }
      dead = known ? dead : one;
    }
    const std::shared_ptr<const Node> made = make();
    if (dead != last) {
      dead->second = made;
      return made;
    }
    if (nodes_.size() > limit_) {
      std::erase_if(nodes_, [](const auto& entry) { return entry.second.expired(); });
      limit_ = 2 * nodes_.size() + fewest;
    }
    nodes_.emplace(made->hash, made);
    return made;
  }

 private:
  static constexpr std::size_t fewest = 100000;

  static bool alike(const Node& a, const Node& b) {
    return a.kind == b.kind && a.row == b.row && a.column == b.column && a.binds == b.binds &&
           a.name == b.name && a.value == b.value && a.definition == b.definition &&
           std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(), Node::is_same);
  }

  std::unordered_multimap<std::uint64_t, std::weak_ptr<const Node>> nodes_;
  std::size_t limit_ = fewest;
};

}  // namespace stickslip::proofs::kernel
