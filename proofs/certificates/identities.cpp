#include "proofs/certificates/identities.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "proofs/certificates/coq_terms.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

Term difference(const Term& a, const Term& b) {
  return sum({a, Term(-1) * b});
}

std::optional<Theorem> identity(const Term& left, const Term& right, const Definitions& unfolded) {
  try {
    return Theorem::combination(equal(left, right), {}, unfolded);
  } catch (const KernelError&) {
    return std::nullopt;
  }
}

std::string nothing(const Type& type) {
  return any_value(real_matrix(type.rows, type.columns));
}

std::string names_of(const Definitions& definitions) {
  std::vector<std::string> names;
  std::transform(definitions.begin(), definitions.end(), std::back_inserter(names),
                 [](const Definition& definition) { return definition_name(definition); });
  return fmt::format("{}", fmt::join(names, " "));
}

}  // namespace stickslip::proofs::certificates
