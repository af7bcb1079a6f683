#include <algorithm>
#include <map>

#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {
namespace {

// Every part replaced by visit(part, how many binders stand around it inside the term).
template <class Visit>
Term mapped(const Term& term, long depth, const Visit& visit) {
  std::vector<Term> parts;
  for (const Term& part : term.parts()) {
    parts.push_back(visit(part, depth + (is_binder(term.kind()) ? 1 : 0)));
  }
  return rebuilt(term, std::move(parts));
}

Term bound(long index, const Type& type) {
  return Node::make({.kind = Kind::bound, .parts = {}, .value = index, .binds = type});
}

Term instantiated_at(const Term& term, const Term& argument, long depth) {
  if (Node::of(term).loose <= depth) {
    return term;
  }
  if (term.kind() == Kind::bound) {
    const long index = term.value().get_num().get_si();
    return index == depth ? shifted(argument, depth) : bound(index - 1, term.binds());
  }
  return mapped(term, depth,
                [&](const Term& part, long inside) { return instantiated_at(part, argument, inside); });
}

Term abstracted_at(const Term& term, const Variable& variable, long depth) {
  if (!term.variables().contains(variable)) {
    return term;
  }
  if (term.kind() == Kind::variable) {
    return bound(depth, variable.type);
  }
  return mapped(term, depth,
                [&](const Term& part, long inside) { return abstracted_at(part, variable, inside); });
}

// What became of parts of one term, by their nodes and the binders around them: a part that stands in many
// places is replaced once.
using Done = std::map<std::pair<const Node *, long>, Term>;

// The values may hold indices of binders around the term.
Term substituted_at(const Term& term, const Substitution& substitution, long depth, Done& done) {
  if (term.kind() == Kind::variable) {
    const auto found = substitution.find({term.name(), term.type()});
    return found == substitution.end() ? term : shifted(found->second, depth);
  }
  if (std::none_of(term.variables().begin(), term.variables().end(),
                   [&](const Variable& free) { return substitution.contains(free); })) {
    return term;
  }
  const std::pair place(&Node::of(term), depth);
  if (const auto known = done.find(place); known != done.end()) {
    return known->second;
  }
  return done
      .emplace(place, mapped(term, depth,
                             [&](const Term& part, long inside) {
                               return substituted_at(part, substitution, inside, done);
                             }))
      .first->second;
}

}  // namespace

Term rebuilt(const Term& term, std::vector<Term> parts) {
  if (parts == term.parts()) {
    return term;
  }
  const Node& old = Node::of(term);
  return Node::make({.kind = old.kind,
                     .parts = std::move(parts),
                     .name = old.name,
                     .value = old.value,
                     .row = old.row,
                     .column = old.column,
                     .binds = old.binds,
                     .definition = old.definition});
}

Term shifted(const Term& term, long by, long above) {
  if (by == 0 || Node::of(term).loose <= above) {
    return term;
  }
  if (term.kind() == Kind::bound) {
    return bound(term.value().get_num().get_si() + by, term.binds());
  }
  return mapped(term, above, [&](const Term& part, long inside) { return shifted(part, by, inside); });
}

Term instantiated(const Term& body, const Term& argument) {
  return instantiated_at(body, argument, 0);
}

Term abstracted(const Term& body, const Variable& variable) {
  static_cast<void>(Term(variable));
  require(body.is_closed(), "what is bound is no part of another binder's body");
  return abstracted_at(body, variable, 0);
}

Term substitute(const Term& term, const Substitution& substitution) {
  for (const auto& [variable, value] : substitution) {
    require(value.is_closed(), "what is substituted is no part of a binder's body");
    require(value.type() == variable.type, "a variable is replaced by something of another type");
  }
  Done done;
  return substituted_at(term, substitution, 0, done);
}

Term replaced(const Term& term, const Term& part, const Term& by) {
  require(part.is_closed() && by.is_closed() && part.type() == by.type(),
          "a part is replaced by a closed term of its own type");
  const auto visit = [&](const auto& self, const Term& inner) -> Term {
    return inner == part ? by : mapped(inner, 0, [&](const Term& next, long) { return self(self, next); });
  };
  return visit(visit, term);
}

Term opened(const Term& binder, const Term& argument) {
  require(is_binder(binder.kind()) && binder.is_closed() && argument.is_closed(),
          "only a closed binder is opened, and with a closed term");
  require(argument.type() == binder.binds(), "what is bound is replaced by something of another type");
  return instantiated(binder.parts()[0], argument);
}

Variable fresh(const Type& type, const std::vector<Term>& avoid) {
  std::set<std::string> taken;
  for (const Term& term : avoid) {
    for (const Variable& variable : term.variables()) {
      taken.insert(variable.name);
    }
  }
  for (int i = 1;; ++i) {
    if (const std::string name = "t" + std::to_string(i); !taken.contains(name)) {
      return {name, type};
    }
  }
}

Term unfold(const Term& term, const Definitions& definitions) {
  const auto visit = [&](const auto& self, const Term& part) -> Term {
    if (!Node::of(part).applies_definitions) {
      return part;
    }
    const Term inner = mapped(part, 0, [&](const Term& p, long) { return self(self, p); });
    if (inner.kind() != Kind::defined || !definitions.contains(inner.definition())) {
      return inner;
    }
    const Definition& definition = inner.definition();
    Substitution arguments;
    for (std::size_t i = 0; i < inner.parts().size(); ++i) {
      arguments.emplace(definition.parameters()[i], inner.parts()[i]);
    }
    Done done;
    return self(self, substituted_at(definition.body(), arguments, 0, done));
  };
  return definitions.empty() ? term : visit(visit, term);
}

}  // namespace stickslip::proofs::kernel
