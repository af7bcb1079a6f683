#include "proofs/pascal2012/examples/examples.hpp"

#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/symmetric.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace numeric::families;
using namespace numeric::motion;

namespace {

PrintedResult legible(const char * name, const char * value) {
  return {name, parse_decimal(value), false};
}
PrintedResult without_sign(const char * name, const char * digits) {
  return {name, parse_decimal(digits), true};
}

Example example_S() {
  return {"S",
          "Fig. 2",
          &symmetric(),
          parse_parameters("0.5", "3.8", "0.02", "1", "0.6", "0.05"),
          std::nullopt,
          std::nullopt,
          {legible("tau", "7.749"), legible("T", "2.723"), legible("Theta", "10.472"),
           without_sign("z10", "1.0609"), without_sign("z20", "1.3615"), without_sign("zdot10", "0.581"),
           legible("ur", "0.1607")}};
}

Example example_O() {
  return {"O",
          "Fig. 3",
          &overshooting(),
          parse_parameters("0.2", "4", "0.05", "1", "0.6289", "0.05"),
          Rational(0),
          std::nullopt,
          {legible("tau", "4.909"), legible("tau1", "2.8275"), legible("T", "2.2543"),
           legible("Theta", "9.9908"), without_sign("z10", "1.2809"), without_sign("z20", "3.3861"),
           legible("zdot10", "-0.4117"), legible("ur", "0.4585")}};
}

Example example_P() {
  return {"P",
          "Fig. 4",
          &nonsticking(),
          parse_parameters("0.3", "4", "0.1", "0", "0.6", "1"),
          std::nullopt,
          parse_rational("0.2996"),
          {legible("Theta", "10.472"), without_sign("x10", "1.5608"), without_sign("x20", "3.3295"),
           without_sign("xdot10", "0.1523"), without_sign("phi", "0.3925")}};
}

}  // namespace

const Examples& printed_examples() {
  static const Examples all{example_S(), example_O(), example_P()};
  return all;
}

const Example& on_a_moving_belt() {
  static const Example example{"V",
                               "a moving belt",
                               &nonsticking(),
                               parse_parameters("0.3", "4", "0.1", "0.1", "0.6", "1"),
                               std::nullopt,
                               parse_rational("0.2"),
                               {}};
  return example;
}

const Example& example_named(const std::string& name) {
  return methods::example_named(printed_examples(), name);
}

}  // namespace stickslip::proofs::pascal2012
