// How long searches go on, when a person has said so.
#pragma once

#include <chrono>
#include <optional>

namespace stickslip::numeric::zeros {

// While an object of this type lives, each search examines at most so many cells, for at most so many
// seconds, in place of its own limit; with seconds alone, any number of cells. Not to be nested, nor made
// while one runs.
class Effort {
 public:
  Effort(std::optional<long> cells, std::optional<double> seconds);
  ~Effort();
  Effort(const Effort&) = delete;
  Effort& operator=(const Effort&) = delete;
};

// The limits of one search that begins now: its own limit of cells, unless an Effort lives.
class Limit {
 public:
  explicit Limit(long cells);

  [[nodiscard]] long cells() const { return cells_; }
  // Why a search that has examined so many cells is to stop; nothing if it is to go on.
  [[nodiscard]] std::optional<const char *> reached(long examined) const;

 private:
  long cells_;
  std::optional<std::chrono::steady_clock::time_point> until_;
};

}  // namespace stickslip::numeric::zeros
