#include "numeric/motion/eigenvalues.hpp"

#if __has_include(<flint/acb_mat.h>)
#include <flint/acb_mat.h>
#else
#include <acb_mat.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::numeric::motion {
namespace {

class ComplexMatrix {
 public:
  ComplexMatrix(long rows, long columns) { acb_mat_init(value_, rows, columns); }
  ~ComplexMatrix() { acb_mat_clear(value_); }
  ComplexMatrix(const ComplexMatrix&) = delete;
  ComplexMatrix& operator=(const ComplexMatrix&) = delete;
  [[nodiscard]] acb_mat_struct * raw() { return value_; }
  // The first row, whose numbers stand one after the other.
  [[nodiscard]] acb_ptr row() { return acb_mat_entry(value_, 0, 0); }

 private:
  acb_mat_t value_;
};

bool overlap(const ComplexBall& a, const ComplexBall& b) {
  return a.re.overlaps(b.re) && a.im.overlaps(b.im);
}

// The conjugate of an eigenvalue of a real matrix is one too: if it can be in no other enclosure it is in the
// same one, which holds a single eigenvalue, hence a real one.
void mark_real(std::vector<ComplexBall>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ComplexBall conjugate{values[i].re, -values[i].im};
    bool alone = values[i].im.contains_zero();
    for (std::size_t j = 0; j < values.size(); ++j) {
      alone = alone && (i == j || (!overlap(values[i], values[j]) && !overlap(conjugate, values[j])));
    }
    if (alone) {
      values[i].im = Ball(0);
    }
  }
}

void sort(std::vector<ComplexBall>& values) {
  const auto rank = [](const ComplexBall& v) {
    const double re = v.re.approximate();
    const double im = v.im.approximate();
    const double modulus = std::hypot(re, im);
    // The two of a pair have one modulus up to rounding.
    return std::array<double, 3>{-std::floor(std::log2(modulus + 0x1p-500) * 0x1p20), -std::abs(im), -im};
  };
  std::sort(values.begin(), values.end(),
            [&](const ComplexBall& a, const ComplexBall& b) { return rank(a) < rank(b); });
}

}  // namespace

std::optional<std::vector<ComplexBall>> eigenvalues(const SquareMatrix& matrix) {
  const long n = matrix.rows();
  const long bits = WorkingPrecision::bits();
  ComplexMatrix A(n, n), R(n, n), approximate(1, n), enclosed(1, n);
  for (long i = 0; i < n; ++i) {
    for (long j = 0; j < n; ++j) {
      if (!matrix(i, j).is_finite()) {
        return std::nullopt;
      }
      acb_set_arb(acb_mat_entry(A.raw(), i, j), matrix(i, j).raw());
    }
  }
  acb_mat_approx_eig_qr(approximate.row(), nullptr, R.raw(), A.raw(), nullptr, 0, bits);
  if (acb_mat_eig_multiple(enclosed.row(), A.raw(), approximate.row(), R.raw(), bits) == 0) {
    return std::nullopt;
  }
  std::vector<ComplexBall> values(static_cast<std::size_t>(n));
  for (long i = 0; i < n; ++i) {
    ComplexBall& value = values[static_cast<std::size_t>(i)];
    arb_set(value.re.raw(), acb_realref(enclosed.row() + i));
    arb_set(value.im.raw(), acb_imagref(enclosed.row() + i));
    if (!value.re.is_finite() || !value.im.is_finite()) {
      return std::nullopt;
    }
  }
  mark_real(values);
  sort(values);
  return values;
}

}  // namespace stickslip::numeric::motion
