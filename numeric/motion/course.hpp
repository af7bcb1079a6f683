// A function of time over a phase, as what bounds it from below needs it.
#pragma once

#include <array>

#include "model/waves.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::motion {

class Course {
 public:
  virtual ~Course() = default;
  // g, g', g'', g''' at the time s.
  [[nodiscard]] virtual std::array<Ball, 4> at(double s) const = 0;
  // The same in floating point: only a guess.
  [[nodiscard]] virtual std::array<double, 4> guess_at(double s) const = 0;
};

// Bounds of |g'''| and |g''''| over the whole phase.
struct DerivativeBounds {
  Ball third, fourth;
};

// A wave, at all times.
class WaveCourse : public Course {
 public:
  explicit WaveCourse(const model::Wave<Ball>& g);
  [[nodiscard]] std::array<Ball, 4> at(double s) const override;
  [[nodiscard]] std::array<double, 4> guess_at(double s) const override;
  [[nodiscard]] DerivativeBounds bounds() const;  // at all times, reversed or not

 private:
  model::Wave<Ball> g_;
  model::Wave<double> guess_;
};

}  // namespace stickslip::numeric::motion
