#include "numeric/zeros/effort.hpp"

#include <algorithm>
#include <limits>

namespace stickslip::numeric::zeros {
namespace {

struct Wish {
  std::optional<long> cells;
  std::optional<double> seconds;
};
Wish wish;

constexpr double most_seconds = 1e9;  // thirty years

}  // namespace

Effort::Effort(std::optional<long> cells, std::optional<double> seconds) {
  wish = {cells, seconds};
}
Effort::~Effort() {
  wish = {};
}

Limit::Limit(long cells)
    : cells_(wish.cells.value_or(wish.seconds ? std::numeric_limits<long>::max() : cells)) {
  using std::chrono::steady_clock;
  if (wish.seconds) {
    until_ = steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(
                                       std::chrono::duration<double>(std::min(*wish.seconds, most_seconds)));
  }
}

std::optional<const char *> Limit::reached(long examined) const {
  if (examined >= cells_) {
    return "the search was stopped at its limit of cells";
  }
  if (until_ && std::chrono::steady_clock::now() >= *until_) {
    return "the search was stopped at its limit of time";
  }
  return std::nullopt;
}

}  // namespace stickslip::numeric::zeros
