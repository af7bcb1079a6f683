#include "numeric/scalars.hpp"

#include <cln/float.h>
#include <cln/integer_io.h>
#include <cln/rational.h>
#include <cln/rational_io.h>

namespace stickslip {

cln::cl_R to_cln(const Rational& value, long bits) {
  const cln::cl_I numerator(value.get_num().get_str().c_str());
  const cln::cl_I denominator(value.get_den().get_str().c_str());
  const cln::float_format_t format =
      cln::float_format(static_cast<unsigned long>(static_cast<double>(bits) * 0.30103) + 1);
  return cln::cl_float(cln::cl_RA(numerator / denominator), format);
}

}  // namespace stickslip
