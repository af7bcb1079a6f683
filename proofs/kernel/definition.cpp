#include <algorithm>

#include "proofs/kernel/node.hpp"
#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {

Definition::Definition(const std::string& name, const std::vector<Variable>& parameters, const Term& body)
    : data_(std::make_shared<const Data>(Data{name, parameters, body})) {
  require(!name.empty(), "a definition has a name");
  require(body.is_closed() && body.type().sort != Sort::function,
          "a definition stands for no function of time");
  std::set<std::string> names;
  for (const Variable& parameter : parameters) {
    static_cast<void>(Term(parameter));
    require(names.insert(parameter.name).second, "two parameters of a definition have one name");
  }
  for (const Variable& free : body.variables()) {
    require(std::find(parameters.begin(), parameters.end(), free) != parameters.end(),
            "a definition has a free variable that is no parameter");
  }
}

Term Definition::operator()(const std::vector<Term>& arguments) const {
  return Node::make({.kind = Kind::defined, .parts = arguments, .definition = *this});
}

Term Definition::unfolded(const std::vector<Term>& arguments) const {
  static_cast<void>((*this)(arguments));  // checks them
  Substitution substitution;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    substitution.emplace(parameters()[i], arguments[i]);
  }
  return substitute(body(), substitution);
}

std::strong_ordering operator<=>(const Definition& a, const Definition& b) {
  if (a.data_ == b.data_) {
    return std::strong_ordering::equal;
  }
  if (const auto order = a.name() <=> b.name(); order != 0) {
    return order;
  }
  if (const auto order = a.parameters() <=> b.parameters(); order != 0) {
    return order;
  }
  return a.body() <=> b.body();
}

}  // namespace stickslip::proofs::kernel
