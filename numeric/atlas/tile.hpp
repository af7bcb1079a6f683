// Dyadic boxes of a rectangle of parameters.
//
// The rectangle is halved again and again, each time across the next of its axes in turn. A tile is the path
// to a box: 1 for the whole, 2 t and 2 t + 1 for the lower and the upper half of t. Laid out one after the
// other, tiles of one depth fill a line of 2^most_depth places; each tile is a stretch of it, so that volumes
// add up, and gaps show, in whole numbers.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace stickslip::numeric::atlas {

using Tile = std::uint64_t;

inline constexpr Tile whole = 1;
inline constexpr int most_depth = 60;

// How often the whole was halved, 0 <= depth <= most_depth for every tile in use.
[[nodiscard]] inline int depth(Tile tile) {
  return static_cast<int>(std::bit_width(tile)) - 1;
}

// The stretch [first, last) of the line that a tile covers.
struct Stretch {
  std::uint64_t first, last;
};
[[nodiscard]] inline Stretch stretch(Tile tile) {
  const int rest = most_depth - depth(tile);
  const std::uint64_t first = (tile ^ (whole << depth(tile))) << rest;
  return {first, first + (std::uint64_t{1} << rest)};
}
[[nodiscard]] inline std::uint64_t volume(Tile tile) {
  return std::uint64_t{1} << (most_depth - depth(tile));
}

// Along one of so many axes: the tile covers [place, place + 1] 2^-halvings of the whole.
struct Side {
  std::uint64_t place;
  int halvings;
};
[[nodiscard]] inline Side side(Tile tile, std::size_t axis, std::size_t axes) {
  Side result{0, 0};
  for (int k = 0; k < depth(tile); ++k) {
    if (static_cast<std::size_t>(k) % axes == axis) {
      result.place = 2 * result.place + ((tile >> (depth(tile) - 1 - k)) & 1);
      ++result.halvings;
    }
  }
  return result;
}

// The largest tiles that cover [first, last), in order.
[[nodiscard]] inline std::vector<Tile> tiles_of(Stretch gap) {
  std::vector<Tile> result;
  while (gap.first < gap.last) {
    int size = gap.first == 0 ? most_depth : std::countr_zero(gap.first);
    while ((std::uint64_t{1} << size) > gap.last - gap.first) {
      --size;
    }
    result.push_back((whole << (most_depth - size)) | (gap.first >> size));
    gap.first += std::uint64_t{1} << size;
  }
  return result;
}

}  // namespace stickslip::numeric::atlas
