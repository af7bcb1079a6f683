#include "proofs/orbits/orbit_with.hpp"

#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;

Theorem orbit_with(const Theorem& orbit, const std::function<Theorem(const Theorem&)>& more) {
  std::vector<Formula> existences{orbit.conclusion()};
  std::vector<Variable> names;
  while (existences.back().kind() == Kind::exists) {
    names.push_back({existences.back().name(), existences.back().binds()});
    existences.push_back(opened(existences.back(), names.back()));
  }
  const Theorem body = Theorem::assume(existences.back());
  Theorem result = tactics::both({body, more(body)});
  Formula said = result.conclusion();
  for (auto one = names.rbegin(); one != names.rend(); ++one) {
    said = kernel::exists(*one, said);
    result = Theorem::witness(result, said, *one);
  }
  for (std::size_t i = names.size(); i-- > 0;) {
    result = Theorem::choose(i == 0 ? orbit : Theorem::assume(existences[i]), names[i], result);
  }
  return result;
}

}  // namespace stickslip::proofs::orbits
