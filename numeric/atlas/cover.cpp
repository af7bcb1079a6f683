#include "numeric/atlas/cover.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace stickslip::numeric::atlas {

void put_in_order(const Question& q, std::vector<Leaf>& leaves) {
  for (const Leaf& leaf : leaves) {
    if (leaf.tile == 0 || depth(leaf.tile) > q.finest()) {
      throw InputOutputError(fmt::format("box {} is none of this atlas", leaf.tile));
    }
  }
  std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
    const std::uint64_t x = stretch(a.tile).first;
    const std::uint64_t y = stretch(b.tile).first;
    return x != y ? x < y : a.tile < b.tile;
  });
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  for (std::size_t i = 1; i < leaves.size(); ++i) {
    if (stretch(leaves[i].tile).first < stretch(leaves[i - 1].tile).last) {
      throw InputOutputError(fmt::format("boxes {} and {} overlap, or contradict each other",
                                         leaves[i - 1].tile, leaves[i].tile));
    }
  }
}

std::vector<Tile> gaps(const std::vector<Leaf>& leaves) {
  std::vector<Tile> result;
  std::uint64_t covered = 0;
  const auto fill = [&](std::uint64_t until) {
    for (const Tile tile : tiles_of({covered, until})) {
      result.push_back(tile);
    }
  };
  for (const Leaf& leaf : leaves) {
    fill(stretch(leaf.tile).first);
    covered = stretch(leaf.tile).last;
  }
  fill(volume(whole));
  return result;
}

Rational share(std::uint64_t volume) {
  Rational result(static_cast<unsigned long>(volume));
  mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), most_depth);
  return result;
}

Tally tally(const Question& q, const std::vector<Leaf>& leaves) {
  Tally all;
  all.leaves = leaves.size();
  for (const Leaf& leaf : leaves) {
    const std::uint64_t v = volume(leaf.tile);
    const Finding& f = leaf.finding;
    all.orbits_known += f.orbits >= 0 ? v : 0;
    all.admissible_known += f.admissible >= 0 ? v : 0;
    if (f.is_decided()) {
      all.decided += v;
      all.counts[{f.orbits, f.admissible, f.stable}] += v;
      continue;
    }
    (f.reason == static_cast<std::uint8_t>(Reason::outside) ? all.outside : all.open) += v;
    all.coarser += depth(leaf.tile) < q.finest() ? v : 0;
    all.reasons[f.reason] += v;
  }
  return all;
}

}  // namespace stickslip::numeric::atlas
