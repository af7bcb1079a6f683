#include "proofs/checks/linear_value.hpp"

#include <algorithm>
#include <set>

#include "proofs/symbols/derived.hpp"
#include "proofs/symbols/table.hpp"

namespace stickslip::proofs::checks {

using namespace symbols;

namespace {

Value<Ball> number(const Ball& value) {
  return Value<Ball>::Constant(1, 1, value);
}

Value<Ball> times(const Value<Ball>& a, const Value<Ball>& b) {
  return a.size() == 1   ? Value<Ball>(b * a(0, 0))
         : b.size() == 1 ? Value<Ball>(a * b(0, 0))
                         : Value<Ball>(a.lazyProduct(b));
}

void add(std::map<std::size_t, Value<Ball>>& slopes, std::size_t unknown, const Value<Ball>& more) {
  const auto [place, fresh] = slopes.emplace(unknown, more);
  if (!fresh) {
    place->second += more;
  }
}

template <class Function>
LinearValue mapped(LinearValue value, const Function& function) {
  value.constant = function(value.constant);
  for (auto& slope : value.slopes) {
    slope.second = function(slope.second);
  }
  return value;
}

}  // namespace

LinearValue LinearValues::operator()(const Term& term) {
  switch (term.op()) {
    case Op::symbol: {
      const Symbol * row = symbol_table().find(term);
      if (row != nullptr && (row->value || row->means)) {
        return (*this)(row->value ? *row->value : *row->means);
      }
      if (term.shape().is_scalar() && term.name() != "I") {
        return scalar(term.name());
      }
      break;
    }
    case Op::sum: {
      LinearValue total{Value<Ball>::Constant(term.shape().rows, term.shape().columns, Ball(0))};
      for (const Term& argument : term.arguments()) {
        if (!argument.is_zero()) {
          const LinearValue part = (*this)(argument);
          total.constant += part.constant;
          for (const auto& [unknown, slope] : part.slopes) {
            add(total.slopes, unknown, slope);
          }
        }
      }
      return total;
    }
    case Op::product: {
      LinearValue result = (*this)(term.arguments().front());
      for (std::size_t i = 1; i < term.arguments().size(); ++i) {
        result = product(result, (*this)(term.arguments()[i]));
      }
      return result;
    }
    case Op::quotient: {
      const LinearValue below = (*this)(term.arguments()[1]);
      if (!below.slopes.empty()) {
        break;
      }
      return mapped((*this)(term.arguments()[0]),
                    [factor = Ball(Ball(1) / below.constant(0, 0))](const Value<Ball>& value) {
                      return Value<Ball>(value * factor);
                    });
    }
    case Op::negate:
      return mapped((*this)(term.arguments().front()),
                    [](const Value<Ball>& value) { return Value<Ball>(-value); });
    case Op::block:
      return block(term);
    default:
      break;
  }
  return by_differences([&](const Lookup<Ball>& lookup) { return evaluate<Ball>(term, lookup); });
}

const LinearValue& LinearValues::scalar(const std::string& name) {
  if (const auto known = known_.find(name); known != known_.end()) {
    return known->second;
  }
  const auto unknown = std::find(solved_for().begin(), solved_for().end(), name);
  const auto value = premises_.values.find(name);
  LinearValue result;
  if (value != premises_.values.end()) {
    result = (*this)(value->second);
  } else if (unknown != solved_for().end()) {
    const auto place = static_cast<std::size_t>(unknown - solved_for().begin());
    result = {number(Ball(0)), {{place, number(Ball(1))}}};
  } else {
    result = by_differences([&](const Lookup<Ball>& lookup) {
      const std::optional<Ball> formula = derived<Ball>(name, lookup);
      return number(formula ? *formula : free_(name));
    });
  }
  return known_.emplace(name, std::move(result)).first->second;
}

// Where one unknown is 1, so it is in both factors.
LinearValue LinearValues::product(const LinearValue& a, const LinearValue& b) {
  LinearValue result{times(a.constant, b.constant)};
  for (const auto& [unknown, slope] : a.slopes) {
    const auto other = b.slopes.find(unknown);
    add(result.slopes, unknown,
        times(slope, other == b.slopes.end() ? b.constant : Value<Ball>(b.constant + other->second)));
  }
  for (const auto& [unknown, slope] : b.slopes) {
    add(result.slopes, unknown, times(a.constant, slope));
  }
  return result;
}

LinearValue LinearValues::block(const Term& term) {
  const Value<Ball> zero = Value<Ball>::Constant(term.shape().rows, term.shape().columns, Ball(0));
  LinearValue result{zero};
  Eigen::Index row = 0, column = 0;
  for (const Term& argument : term.arguments()) {
    const LinearValue part = (*this)(argument);
    const Eigen::Index rows = part.constant.rows(), columns = part.constant.cols();
    result.constant.block(row, column, rows, columns) = part.constant;
    for (const auto& [unknown, slope] : part.slopes) {
      result.slopes.emplace(unknown, zero).first->second.block(row, column, rows, columns) = slope;
    }
    column += columns;
    if (column == zero.cols()) {
      column = 0;
      row += rows;
    }
  }
  return result;
}

LinearValue LinearValues::by_differences(const Function& function) {
  std::set<std::size_t> met;
  LinearValue result{function([&](const std::string& name) {
    const LinearValue& value = scalar(name);
    for (const auto& slope : value.slopes) {
      met.insert(slope.first);
    }
    return value.constant(0, 0);
  })};
  for (const std::size_t unknown : met) {
    const Value<Ball> there = function([&](const std::string& name) {
      const LinearValue& value = scalar(name);
      const auto slope = value.slopes.find(unknown);
      return slope == value.slopes.end() ? value.constant(0, 0)
                                         : Ball(value.constant(0, 0) + slope->second(0, 0));
    });
    result.slopes.emplace(unknown, there - result.constant);
  }
  return result;
}

}  // namespace stickslip::proofs::checks
