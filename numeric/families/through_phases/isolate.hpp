// From equations whose zeros are closed motions to these motions: every zero in the domain isolated, refined
// and looked at.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "numeric/families/family.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::families {

inline constexpr long search_bits = 64;
inline constexpr long guess_bits = 128;  // of a refined zero

// Where a share lies as to the open interval (0, 1), for searches that end there.
enum class Place { inside, outside, at_edge };
template <class S>
[[nodiscard]] Place place(const S& share) {
  const S beyond = share - S(1);
  if (share.is_negative() || beyond.is_positive()) {
    return Place::outside;
  }
  return share.is_positive() && beyond.is_negative() ? Place::inside : Place::at_edge;
}

// Why a zero at the edge is left open, or a motion that was proved near a zero.
inline constexpr const char * no_time_at_all = "an orbit one of whose phases may last no time at all";
inline constexpr const char * may_be_another = "the motion that was proved near a zero may be another one";

// What became of one of the things that a list is made of; nothing if it does not belong there.
template <class Result>
using Concluded = std::variant<std::monostate, Result, Unresolved>;

// A refined zero that lies there: what make() makes of it, or left open at the edge.
template <class Result, class Make>
[[nodiscard]] Concluded<Result> concluded(Place place, const std::vector<NamedBall>& where,
                                          const Make& make) {
  switch (place) {
    case Place::outside:
      return {};
    case Place::at_edge:
      return Unresolved{where, no_time_at_all};
    default:
      return make();
  }
}

// Adds what each of them is concluded to be, in their order.
template <class Some, class Conclude, class Result>
void conclude_all(const std::vector<Some>& all, const Conclude& conclude, std::vector<Result>& results,
                  std::vector<Unresolved>& unresolved) {
  for (Concluded<Result>& one :
       parallel_map(all.size(), [&](std::size_t i) -> Concluded<Result> { return conclude(all[i]); })) {
    if (auto * result = std::get_if<Result>(&one)) {
      results.push_back(std::move(*result));
    } else if (auto * open = std::get_if<Unresolved>(&one)) {
      unresolved.push_back(std::move(*open));
    }
  }
}

// equations(): at the working precision of the moment, with
//   contract(X), decide(X)   for the search of zeros/search.hpp
//   left_open(box)           what is said of an unresolved box; nothing where it holds no motion
// conclude(found): Concluded<Zero> of a zero, at guess_bits; they are taken by rising first unknown.
template <class Zero, int N, class Equations, class Conclude,
          class Halved = std::size_t(const zeros::Cell<N>&)>
[[nodiscard]] FoundOf<Zero> isolate(const zeros::Cell<N>& domain, const zeros::SearchLimits& limits,
                                    const Equations& equations, const Conclude& conclude,
                                    const Halved& halved = zeros::detail::longest_side<N>) {
  FoundOf<Zero> list;
  zeros::SearchResult<N> result;
  {
    const WorkingPrecision scope(search_bits);
    const auto f = equations();
    result = zeros::search<N>(
        domain, [&](const zeros::Box<N>& X) { return f.contract(X); },
        [&](const zeros::Box<N>& X) { return f.decide(X); }, limits, halved);
    for (const zeros::UnresolvedBox<N>& open : result.unresolved) {
      if (const std::optional<Unresolved> part = f.left_open(open)) {
        list.unresolved.push_back(*part);
      }
    }
  }
  list.cells = result.cells;
  std::sort(result.zeros.begin(), result.zeros.end(),
            [](const auto& x, const auto& y) { return x.box(0).approximate() < y.box(0).approximate(); });
  const WorkingPrecision scope(guess_bits);
  conclude_all(result.zeros, conclude, list.candidates, list.unresolved);
  return list;
}

}  // namespace stickslip::numeric::families
