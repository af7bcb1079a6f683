#include "proofs/kernel/term.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <unordered_map>

#include "proofs/kernel/rule.hpp"

namespace stickslip::proofs::kernel {
namespace {

constexpr long deepest = 1000;  // what recursion through a term may need of the stack

void require_valid(const Type& type) {
  require(type.rows >= 1 && type.columns >= 1 && type.rows <= 64 && type.columns <= 64,
          "a matrix has between 1 and 64 rows and columns");
  require(type.sort != Sort::formula || (type.rows == 1 && type.columns == 1), "formulas have no shape");
}

Type shape_of_sum(const std::vector<Term>& parts) {
  require(!parts.empty(), "a sum has at least one part");
  Type type = parts.front().type();
  for (const Term& part : parts) {
    require(part.type().is_numeric(), "only numbers and matrices are added");
    require(part.type() == type, "a sum's parts differ in shape");
  }
  return type;
}

Type shape_of_product(const Type& a, const Type& b) {
  require(a.is_numeric() && b.is_numeric(), "only numbers and matrices are multiplied");
  if (a.is_scalar() || b.is_scalar()) {
    return a.is_scalar() ? Type{Sort::real, b.rows, b.columns} : Type{Sort::real, a.rows, a.columns};
  }
  require(a.columns == b.rows, "a product's shapes do not fit");
  return {Sort::real, a.rows, b.columns};
}

Type shape_of_definition(const Node& node) {
  const std::vector<Variable>& parameters = node.definition->parameters();
  require(parameters.size() == node.parts.size(), "a definition has another number of arguments");
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    require(node.parts[i].type() == parameters[i].type, "a definition's argument is of another type");
  }
  return node.definition->body().type();
}

Type numeric_type(const Node& node) {
  const std::vector<Term>& parts = node.parts;
  switch (node.kind) {
    case Kind::number:
    case Kind::pi:
      return real_number;
    case Kind::sum:
      return shape_of_sum(parts);
    case Kind::product:
      return shape_of_product(parts[0].type(), parts[1].type());
    case Kind::power:
      require(parts[0].type().is_scalar(), "only a number is raised to a power");
      require(node.value->value().get_den() == 1 && *node.value >= 0 && *node.value <= 1000,
              "an exponent is a whole number from 0 to 1000");
      return parts[0].type();
    case Kind::inverse:
      require(parts[0].type().is_numeric() && parts[0].type().rows == parts[0].type().columns &&
                  parts[0].type().rows <= 4,
              "only a square matrix of at most 4 rows is inverted");
      return parts[0].type();
    case Kind::cosine:
    case Kind::sine:
    case Kind::exponential:
      require(parts[0].type().is_scalar(), "cos, sin and exp are of numbers");
      return real_number;
    case Kind::matrix: {
      const Type type{Sort::real, node.row, node.column};
      require_valid(type);
      require(parts.size() == static_cast<std::size_t>(node.row * node.column) &&
                  std::all_of(parts.begin(), parts.end(), [](const Term& p) { return p.type().is_scalar(); }),
              "a matrix is made of as many numbers as it has entries");
      return type;
    }
    case Kind::entry:
      require(parts[0].type().is_numeric(), "only a matrix has entries");
      require(node.row >= 0 && node.column >= 0 && node.row < parts[0].type().rows &&
                  node.column < parts[0].type().columns,
              "a matrix has no such entry");
      return real_number;
    case Kind::defined:
      return shape_of_definition(node);
    default:  // apply
      require(parts[0].type().sort == Sort::function, "only a function is applied");
      require(parts[1].type().is_scalar(), "a function is applied to a number");
      return {Sort::real, parts[0].type().rows, parts[0].type().columns};
  }
}

void check_formula(const Node& node) {
  const std::vector<Term>& parts = node.parts;
  const auto are_formulas = [&] {
    return std::all_of(parts.begin(), parts.end(),
                       [](const Term& part) { return part.type() == truth_value; });
  };
  switch (node.kind) {
    case Kind::equal:
      require(parts[0].type().is_numeric() && parts[0].type() == parts[1].type(),
              "the sides of an equation differ in shape");
      return;
    case Kind::less:
    case Kind::at_most:
      require(parts[0].type().is_scalar() && parts[1].type().is_scalar(), "only numbers are ordered");
      return;
    case Kind::derivative:
      require(parts[0].type().sort == Sort::function, "only a function has a derivative");
      require(parts[1].type().is_scalar(), "a derivative is taken at a number");
      require(parts[2].type().is_numeric() && parts[2].type().rows == parts[0].type().rows &&
                  parts[2].type().columns == parts[0].type().columns,
              "a derivative has the function's shape");
      return;
    case Kind::continuous:
      require(parts[0].type().sort == Sort::function, "only a function is continuous");
      require(parts[1].type().is_scalar() && parts[2].type().is_scalar(), "an interval's ends are numbers");
      return;
    case Kind::inside_unit_circle:
      require(parts[0].type().is_numeric() && parts[0].type().rows >= 2 && parts[0].type().columns == 1,
              "a polynomial's coefficients are a column of at least two");
      return;
    default:  // and, or, not, implies, for all, there is, finite
      require(are_formulas(), "a formula is made of formulas");
  }
}

Type type_of(const Node& node) {
  if (node.kind == Kind::variable || node.kind == Kind::bound) {
    require(node.binds.sort != Sort::formula, "a variable does not stand for a formula");
    return node.binds;
  }
  if (is_binder(node.kind)) {
    require(node.binds.sort != Sort::formula, "a variable does not stand for a formula");
    require((node.kind != Kind::lambda && node.kind != Kind::finite) || node.binds == real_number,
            "time is a real number");
  }
  if (node.kind == Kind::lambda) {
    require(node.parts[0].type().is_numeric(), "a function's values are numbers or matrices");
    return {Sort::function, node.parts[0].type().rows, node.parts[0].type().columns};
  }
  if (node.kind == Kind::apply || node.kind == Kind::exponential || node.kind < Kind::lambda) {
    return numeric_type(node);
  }
  check_formula(node);
  return truth_value;
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t next) {
  return (hash ^ next) * 1099511628211ULL + 0x9e3779b97f4a7c15ULL;
}

std::uint64_t hash_of(const Node& node) {
  std::uint64_t hash = mixed(14695981039346656037ULL, static_cast<std::uint64_t>(node.kind));
  const auto add = [&hash](const std::string& text) {  // a collision costs time, never truth
    for (const char c : text) {
      hash = mixed(hash, static_cast<unsigned char>(c));
    }
  };
  if (!is_binder(node.kind)) {
    add(node.name);
  }
  add(node.value ? node.value->value().get_str() : "0");
  if (node.definition) {
    add(node.definition->name());
  }
  hash = mixed(mixed(hash, static_cast<std::uint64_t>(node.row)), static_cast<std::uint64_t>(node.column));
  for (const Term& part : node.parts) {
    hash = mixed(hash, Node::of(part).hash);
  }
  return hash;
}

// The free variables of the parts: mostly those of one of them.
std::shared_ptr<const Variables> variables_of(const Node& node) {
  if (node.kind == Kind::variable) {
    require(!node.name.empty(), "a variable has a name");
    return std::make_shared<const Variables>(Variables{{node.name, node.type}});
  }
  static const auto none = std::make_shared<const Variables>();
  std::shared_ptr<const Variables> most = none;
  for (const Term& part : node.parts) {
    const std::shared_ptr<const Variables>& here = Node::of(part).variables;
    most = here->size() > most->size() ? here : most;
  }
  std::optional<Variables> more;
  for (const Term& part : node.parts) {
    const Variables& here = part.variables();
    if (&here != most.get() && !std::includes(most->begin(), most->end(), here.begin(), here.end())) {
      more = more ? more : std::optional(*most);
      more->insert(here.begin(), here.end());
    }
  }
  return more ? std::make_shared<const Variables>(*std::move(more)) : most;
}

// How many parts a term of that kind has; nothing where it may have any number.
std::optional<std::size_t> arity(Kind kind) {
  switch (kind) {
    case Kind::variable:
    case Kind::bound:
    case Kind::number:
    case Kind::pi:
      return 0;
    case Kind::sum:
    case Kind::matrix:
    case Kind::defined:
    case Kind::conjunction:
    case Kind::disjunction:
      return std::nullopt;
    case Kind::product:
    case Kind::apply:
    case Kind::equal:
    case Kind::less:
    case Kind::at_most:
    case Kind::implication:
      return 2;
    case Kind::derivative:
    case Kind::continuous:
      return 3;
    default:
      return 1;
  }
}

void require_complete(const Node& node) {
  require(node.parts.size() == arity(node.kind).value_or(node.parts.size()), "a term lacks parts");
  require(node.value.has_value() ||
              (node.kind != Kind::number && node.kind != Kind::power && node.kind != Kind::bound),
          "a term lacks its number");
  require(node.kind != Kind::bound ||
              (*node.value >= 0 && *node.value <= deepest && node.value->value().get_den() == 1),
          "an index counts binders");
  require(node.definition.has_value() == (node.kind == Kind::defined), "a term lacks its definition");
}

// Nodes that are alive, by hash, in all threads. What is built alike, hints included, is one node: then most
// comparisons are of two pointers.
class Pool {
 public:
  // The node that is built alike, if there is one; else the one that `make` makes of it, which makes no
  // other.
  template <class Make>
  [[nodiscard]] std::shared_ptr<const Node> shared(const Node& node, const Make& make) {
    const std::lock_guard alone(mutex_);
    const auto [first, last] = nodes_.equal_range(node.hash);
    auto dead = last;
    for (auto one = first; one != last; ++one) {
      auto known = one->second.lock();
      if (known && alike(*known, node)) {
        return known;
      }
      dead = known ? dead : one;
    }
    const std::shared_ptr<const Node> made = make();
    if (dead != last) {
      dead->second = made;
      return made;
    }
    if (nodes_.size() > limit_) {
      std::erase_if(nodes_, [](const auto& entry) { return entry.second.expired(); });
      limit_ = 2 * nodes_.size() + fewest;
    }
    nodes_.emplace(made->hash, made);
    return made;
  }

 private:
  static constexpr std::size_t fewest = 2000;

  static bool alike(const Node& a, const Node& b) {
    return a.kind == b.kind && a.row == b.row && a.column == b.column && a.binds == b.binds &&
           a.name == b.name && a.value == b.value && a.definition == b.definition &&
           std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(), Node::is_same);
  }

  std::mutex mutex_;
  std::unordered_multimap<std::uint64_t, std::weak_ptr<const Node>> nodes_;
  std::size_t limit_ = fewest;
};

}  // namespace

Term Node::make(Node node) {
  require_valid(node.binds);
  require_complete(node);
  if (node.kind == Kind::apply && node.parts[0].kind() == Kind::lambda && node.parts[1].type().is_scalar()) {
    return instantiated(node.parts[0].parts()[0], node.parts[1]);
  }
  node.type = type_of(node);
  if (node.kind == Kind::lambda && node.parts[0].kind() == Kind::apply) {
    const std::vector<Term>& inner = node.parts[0].parts();
    const bool of_the_time = inner[1].kind() == Kind::bound && inner[1].value() == 0;
    if (of_the_time && (inner[0].kind() == Kind::variable || inner[0].value() > 0)) {
      return shifted(inner[0], -1);
    }
  }
  node.hash = hash_of(node);
  static std::array<Pool, 64> pools;  // so that threads seldom wait for one another
  return Term(pools[node.hash % pools.size()].shared(node, [&] {
    node.variables = variables_of(node);
    node.loose = node.kind == Kind::bound ? node.value->value().get_num().get_si() + 1 : 0;
    node.depth = 1;
    node.applies_definitions = node.kind == Kind::defined;
    for (const Term& part : node.parts) {
      node.loose = std::max(node.loose, of(part).loose - (is_binder(node.kind) ? 1 : 0));
      node.depth = std::max(node.depth, of(part).depth + 1);
      require(node.depth <= deepest, "a term is nested more than 1000 deep");
      node.applies_definitions = node.applies_definitions || of(part).applies_definitions;
    }
    return std::make_shared<const Node>(std::move(node));
  }));
}

Kind Term::kind() const {
  return node_->kind;
}
const Type& Term::type() const {
  return node_->type;
}
const std::vector<Term>& Term::parts() const {
  return node_->parts;
}
const std::string& Term::name() const {
  return node_->name;
}
const Rational& Term::value() const {
  static const Rational none = 0;
  return node_->value ? node_->value->value() : none;
}
int Term::row() const {
  return node_->row;
}
int Term::column() const {
  return node_->column;
}
const Type& Term::binds() const {
  return node_->binds;
}
const Definition& Term::definition() const {
  require(node_->definition.has_value(), "the term is not a definition applied");
  return *node_->definition;
}
const Variables& Term::variables() const {
  return *node_->variables;
}
bool Term::is_closed() const {
  return node_->loose == 0;
}

bool Before::operator()(const Variable& a, const Variable& b) const {
  return a < b;
}
bool Before::operator()(const Term& a, const Term& b) const {
  return a < b;
}
bool Before::operator()(const Definition& a, const Definition& b) const {
  return a < b;
}

std::strong_ordering operator<=>(const Term& a, const Term& b) {
  if (a.node_ == b.node_) {
    return std::strong_ordering::equal;
  }
  const Node& m = *a.node_;
  const Node& n = *b.node_;
  if (m.hash != n.hash) {  // almost always
    return m.hash <=> n.hash;
  }
  for (const auto order : {m.kind <=> n.kind, m.type <=> n.type, m.binds <=> n.binds, m.row <=> n.row,
                           m.column <=> n.column, cmp(a.value(), b.value()) <=> 0,
                           is_binder(m.kind) ? std::strong_ordering::equal : m.name <=> n.name}) {
    if (order != 0) {
      return order;
    }
  }
  if (m.kind == Kind::defined) {
    if (const auto order = *m.definition <=> *n.definition; order != 0) {
      return order;
    }
  }
  return m.parts <=> n.parts;
}

}  // namespace stickslip::proofs::kernel
