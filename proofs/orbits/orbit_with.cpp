#include "proofs/orbits/orbit_with.hpp"

#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;

Theorem of_orbit(const Theorem& orbit, const std::function<Theorem(const Theorem&)>& more) {
  std::vector<Formula> existences{orbit.conclusion()};
  std::vector<Variable> names;
  while (existences.back().kind() == Kind::exists) {
    names.push_back({existences.back().name(), existences.back().binds()});
    existences.push_back(opened(existences.back(), names.back()));
  }
  Theorem result = more(Theorem::assume(existences.back()));
  for (auto one = names.rbegin(); one != names.rend(); ++one) {
    if (result.conclusion().variables().contains(*one)) {
      result = Theorem::witness(result, kernel::exists(*one, result.conclusion()), *one);
    }
  }
  for (std::size_t i = names.size(); i-- > 0;) {
    result = Theorem::choose(i == 0 ? orbit : Theorem::assume(existences[i]), names[i], result);
  }
  return result;
}

Theorem orbit_with(const Theorem& orbit, const std::function<Theorem(const Theorem&)>& more) {
  return of_orbit(orbit, [&](const Theorem& body) { return tactics::both({body, more(body)}); });
}

}  // namespace stickslip::proofs::orbits
