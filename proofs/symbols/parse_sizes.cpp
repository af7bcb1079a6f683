// Trees of lines as terms: 0, I and what stands about them take the sizes that fit.
#include "proofs/symbols/parse_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

namespace stickslip::proofs::symbols::parsing {
namespace {

constexpr int greatest_exponent_of_matrix = 50;

std::string sizes(const Shape& shape) {
  return shape.is_scalar()    ? "a number"
         : shape.columns == 1 ? fmt::format("a column of {}", shape.rows)
                              : fmt::format("a {} x {} matrix", shape.rows, shape.columns);
}

// Here a size may not be known: 0 rows or columns are not.
constexpr Shape unknown_size{0, 0}, scalar_size{1, 1};
bool is_known(const Shape& size) {
  return size.rows > 0 && size.columns > 0;
}
void learn(Shape& size, const Shape& other) {
  size.rows = size.rows > 0 ? size.rows : other.rows;
  size.columns = size.columns > 0 ? size.columns : other.columns;
}

class Shaper {
 public:
  Shaper(std::string_view line, const Names& names) : line_(line), names_(names) {}

  [[nodiscard]] std::pair<Term, Term> sides(const Node& left, const Node& right) const {
    Shape size = size_of(left);
    learn(size, size_of(right, size));
    learn(size, size_of(left, size));
    const Term a = sized(left, size), b = sized(right, size);
    require_same(right, b, a);
    return {a, b};
  }

  [[nodiscard]] Term scalar(const Node& node) const {
    Term term = made(node, scalar_size);
    if (!term.shape().is_scalar()) {
      fail(node.at, fmt::format("{}, where a number belongs", sizes(term.shape())));
    }
    return term;
  }

  // Of that size, where it leaves that open.
  [[nodiscard]] Term made(const Node& node, const Shape& wanted) const {
    if (node.abbreviation != nullptr) {
      Replacements arguments;
      for (std::size_t k = 0; k < node.parts.size(); ++k) {
        arguments.emplace(node.abbreviation->parameters[k], scalar(node.parts[k]));
      }
      return substitute(node.abbreviation->means, arguments);
    }
    switch (node.op) {
      case Op::number:
        return Term(node.number);
      case Op::symbol:
        return symbol(node, wanted);
      case Op::function: {
        const Shape shape = node.name == "abs" ? Shape{} : names_.functions.find(node.name)->second;
        return Function{node.name, shape}(scalar(node.parts[0]));
      }
      case Op::sum:
        return sum_made(node, wanted);
      case Op::product:
        return product_made(node, wanted);
      case Op::quotient:
        return sized(node.parts[0], wanted) / scalar(node.parts[1]);
      case Op::power: {
        const Term base = sized(node.parts[0], wanted);
        require_square(node, base);
        if (!base.shape().is_scalar() && abs(node.number) > greatest_exponent_of_matrix) {
          fail(node.at, fmt::format("the exponent of a matrix is at most {}", greatest_exponent_of_matrix));
        }
        return power(base, static_cast<int>(node.number.get_num().get_si()));
      }
      case Op::negate:
        return node.parts[0].op == Op::number && node.parts[0].number != 0
                   ? Term(Rational(-node.parts[0].number))
                   : -sized(node.parts[0], wanted);
      case Op::derivative:
        return derivative(sized(node.parts[0], wanted));
      case Op::block:
        return block_made(node, wanted);
      case Op::determinant: {
        const Term inside = made(node.parts[0], unknown_size);
        require_square(node, inside);
        return determinant(inside);
      }
    }
    fail(node.at, "a formula of unknown kind");
  }

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& what) const { throw ParseError(line_, at, what); }

  // A part of a formula: a 0 has the size that is wanted there.
  [[nodiscard]] Term sized(const Node& part, const Shape& wanted) const {
    const bool is_zero = part.op == Op::number && part.number == 0;
    return is_zero && is_known(wanted) ? zero(wanted.rows, wanted.columns) : made(part, wanted);
  }

  void require_same(const Node& node, const Term& term, const Term& other) const {
    if (term.shape() != other.shape() && !term.is_zero() && !other.is_zero()) {
      fail(node.at, fmt::format("this is {}, and what it stands with is {}", sizes(term.shape()),
                                sizes(other.shape())));
    }
  }
  void require_square(const Node& node, const Term& term) const {
    if (term.shape().rows != term.shape().columns) {
      fail(node.at, fmt::format("this is {}, and only square matrices have powers and determinants",
                                sizes(term.shape())));
    }
  }

  // As far as it is known: of it alone, or with what is known of its place.
  [[nodiscard]] Shape size_of(const Node& node, Shape wanted = unknown_size) const {
    const std::array<int, 2> place{wanted.rows, wanted.columns};
    const auto found = known_.find({&node, place});
    return found != known_.end()
               ? found->second
               : known_.emplace(std::pair(&node, place), look_at(node, wanted)).first->second;
  }
  [[nodiscard]] Shape look_at(const Node& node, const Shape& wanted) const {
    if (node.abbreviation != nullptr) {
      return node.abbreviation->means.shape();
    }
    switch (node.op) {
      case Op::number:
        return node.number == 0 ? wanted : scalar_size;
      case Op::symbol: {
        const auto found = names_.quantities.find(node.name);
        return found == names_.quantities.end() ? square(wanted) : found->second;
      }
      case Op::function: {
        const auto found = names_.functions.find(node.name);
        return found == names_.functions.end() ? scalar_size : found->second;
      }
      case Op::sum: {
        Shape size = unknown_size;
        for (const Node& part : node.parts) {
          learn(size, size_of(part));
        }
        learn(size, wanted);
        return size;
      }
      case Op::product: {
        const std::vector<Shape> factors = chain(node, wanted);
        Shape size = scalar_size;
        bool first = true;
        for (const Shape& factor : factors) {
          if (!factor.is_scalar()) {
            size = first ? factor : Shape{size.rows, factor.columns};
            first = false;
          }
        }
        return size;
      }
      case Op::power:
        return square(size_of(node.parts[0], square(wanted)));
      case Op::quotient:
      case Op::negate:
      case Op::derivative:
        return size_of(node.parts[0], wanted);
      case Op::block: {
        const Grid grid = grid_of(node, wanted);
        const auto total = [](const std::vector<int>& all) {
          return std::ranges::find(all, 0) != all.end() ? 0 : std::accumulate(all.begin(), all.end(), 0);
        };
        return {total(grid.heights), total(grid.widths)};
      }
      case Op::determinant:
        return scalar_size;
    }
    return unknown_size;
  }

  [[nodiscard]] static Shape square(Shape size) {
    learn(size, {size.columns, size.rows});
    return size;
  }

  // Of each factor, as far as the others and the place of the product say. A 0 that may be a number is one.
  [[nodiscard]] std::vector<Shape> chain(const Node& node, const Shape& wanted) const {
    std::vector<Shape> sizes;
    std::vector<std::size_t> big;  // the factors that are no numbers
    for (const Node& part : node.parts) {
      sizes.push_back(size_of(part));
      if (!sizes.back().is_scalar()) {
        big.push_back(sizes.size() - 1);
      }
    }
    if (big.empty()) {
      return sizes;
    }
    learn(sizes[big.front()], {wanted.rows, 0});
    learn(sizes[big.back()], {0, wanted.columns});
    const auto look = [&](std::size_t k) { sizes[k] = size_of(node.parts[k], sizes[k]); };
    for (std::size_t k = 0; k < big.size(); ++k) {
      if (k > 0) {
        learn(sizes[big[k]], {sizes[big[k - 1]].columns, 0});
      }
      look(big[k]);
    }
    for (std::size_t k = big.size(); k-- > 0;) {
      if (k + 1 < big.size()) {
        learn(sizes[big[k]], {0, sizes[big[k + 1]].rows});
      }
      look(big[k]);
    }
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      if (node.parts[k].op == Op::number && !is_known(sizes[k])) {
        sizes[k] = scalar_size;
      }
    }
    return sizes;
  }

  struct Grid {
    std::size_t per_row = 1;
    std::vector<int> heights, widths;  // 0 for what is not known
  };

  [[nodiscard]] Grid grid_of(const Node& node, const Shape& wanted) const {
    const auto rows = static_cast<std::size_t>(node.number.get_num().get_si());
    Grid grid{node.parts.size() / rows, std::vector<int>(rows, 0), {}};
    grid.widths.assign(grid.per_row, 0);
    const auto look = [&] {
      for (std::size_t again = 0; again < 2; ++again) {
        for (std::size_t k = 0; k < node.parts.size(); ++k) {
          int &height = grid.heights[k / grid.per_row], &width = grid.widths[k % grid.per_row];
          Shape size{height, width};
          learn(size, size_of(node.parts[k], size));
          height = size.rows;
          width = size.columns;
        }
      }
    };
    look();
    share(grid.widths, wanted.columns);
    look();
    share(grid.heights, wanted.rows);
    look();
    return grid;
  }

  // What is left of the whole, if that is known, shared evenly among those not known.
  static void share(std::vector<int>& all, int whole) {
    const auto open = static_cast<int>(std::ranges::count(all, 0));
    const int left = whole - std::accumulate(all.begin(), all.end(), 0);
    if (open > 0 && left > 0 && left % open == 0) {
      std::ranges::replace(all, 0, left / open);
    }
  }

  [[nodiscard]] Term symbol(const Node& node, const Shape& wanted) const {
    if (node.name != "I" || names_.quantities.contains("I")) {
      const Shape shape = names_.quantities.find(node.name)->second;
      return Term(Term::Node{Op::symbol, shape, node.name, 0, {}});
    }
    if (!is_known(wanted)) {
      fail(node.at, "nothing says how large this I is");
    }
    if (wanted.rows != wanted.columns || wanted.is_scalar()) {
      fail(node.at, fmt::format("I stands where {} belongs", sizes(wanted)));
    }
    return identity(wanted.rows);
  }

  [[nodiscard]] Term sum_made(const Node& node, const Shape& wanted) const {
    Shape size = size_of(node, wanted);
    for (const Node& part : node.parts) {  // what is known in part has made up its mind
      const Shape known = size_of(part);
      if (!is_known(size) && (known.rows > 0 || known.columns > 0)) {
        size = made(part, size).shape();
      }
    }
    std::optional<Term> sum;
    for (const Node& part : node.parts) {
      const Term term = sized(part, size);
      if (sum) {
        require_same(part, term, *sum);
      }
      sum = sum ? *sum + term : term;
    }
    return *sum;
  }

  [[nodiscard]] Term product_made(const Node& node, const Shape& wanted) const {
    const std::vector<Shape> sizes_of_factors = chain(node, wanted);
    std::optional<Term> product;
    for (std::size_t k = 0; k < node.parts.size(); ++k) {
      const Shape& size = sizes_of_factors[k];
      const Term factor = sized(node.parts[k], size);
      const Shape right = factor.shape(), left = product ? product->shape() : Shape{};
      if (!left.is_scalar() && !right.is_scalar() && left.columns != right.rows) {
        fail(node.parts[k].at,
             fmt::format("this is {}, and is multiplied by {} from the left", sizes(right), sizes(left)));
      }
      product = product ? *product * factor : factor;
    }
    return *product;
  }

  [[nodiscard]] Term block_made(const Node& node, const Shape& wanted) const {
    Grid grid = grid_of(node, wanted);
    std::ranges::replace(grid.heights, 0, 1);
    std::ranges::replace(grid.widths, 0, 1);
    std::vector<Term> blocks;
    for (std::size_t k = 0; k < node.parts.size(); ++k) {
      const Shape size{grid.heights[k / grid.per_row], grid.widths[k % grid.per_row]};
      Term one = sized(node.parts[k], size);
      if (one.shape() != size) {
        fail(node.parts[k].at, fmt::format("this is {}, and its row and column of blocks ask for {}",
                                           sizes(one.shape()), sizes(size)));
      }
      blocks.push_back(std::move(one));
    }
    return block(static_cast<int>(grid.heights.size()), std::move(blocks));
  }

  std::string_view line_;
  const Names& names_;
  mutable std::map<std::pair<const Node *, std::array<int, 2>>, Shape> known_;  // what size_of() found
};

}  // namespace
}  // namespace stickslip::proofs::symbols::parsing

namespace stickslip::proofs::symbols {

std::vector<Statement> parse_statements(std::string_view line, const Names& names) {
  const parsing::Relations read = parsing::relations_in(line, names);
  const parsing::Shaper shaper(line, names);
  const auto interval = [&](const std::pair<parsing::Node, parsing::Node>& ends) {
    return std::pair(shaper.scalar(ends.first), shaper.scalar(ends.second));
  };
  std::optional<Times> times;
  if (read.times) {
    const auto [from, to] = interval(*read.times);
    times = Times{from, to, read.almost};
  }
  std::vector<Statement> statements;
  for (std::size_t i = 0; i < read.between.size(); ++i) {
    const auto [left, right] = shaper.sides(read.sides[i], read.sides[i + 1]);
    statements.push_back({left, right, read.between[i], times});
  }
  if (read.continuous) {  // which what is differentiated is in any case
    const auto [from, to] = interval(*read.continuous);
    if (statements.size() != 1 || statements[0].left.op() != Op::derivative || !equal(from, times->from) ||
        !equal(to, times->to)) {
      throw ParseError(
          line, read.continuous->first.at,
          "what is differentiated is continuous, on the interval of its times, and nothing else is said "
          "to be");
    }
  }
  return statements;
}

Term parse_term(std::string_view line, const Names& names, const std::optional<Shape>& shape) {
  return parsing::Shaper(line, names)
      .made(parsing::expression_in(line, names), shape.value_or(parsing::unknown_size));
}

}  // namespace stickslip::proofs::symbols
