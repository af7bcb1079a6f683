#include "symbolic/algebra/symbols.hpp"

#include <map>

#include "model/parameters.hpp"

namespace stickslip::symbolic::algebra {

using GiNaC::ex;

ex symbol(const std::string& name) {
  static std::map<std::string, GiNaC::symbol> known;
  return known.try_emplace(name, name).first->second;
}

ex in_frequencies(const ex& expression) {
  static const GiNaC::exmap substitution = [] {
    const ex omega1 = symbol("omega1");
    const ex omega2 = symbol("omega2");
    const ex chi = model::chi_from_frequencies<ex>(omega1, omega2);
    return GiNaC::exmap{{symbol("chi"), chi},
                        {symbol("eta"), model::eta_from_frequencies<ex>(omega1, omega2)},
                        {symbol("lambda1"), model::lambda<ex>(chi, omega1).normal()},
                        {symbol("lambda2"), model::lambda<ex>(chi, omega2).normal()}};
  }();
  return expression.subs(substitution, GiNaC::subs_options::no_pattern);
}

}  // namespace stickslip::symbolic::algebra
