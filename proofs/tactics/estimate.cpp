#include "proofs/tactics/estimate.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace stickslip::proofs::tactics {
namespace {

using namespace kernel;
using Real = long double;
using Value = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

constexpr Real nearly = 1e-10L;

Value number(Real x) {
  return Value::Constant(1, 1, x);
}

class Estimate {
 public:
  explicit Estimate(const Definitions& unfolded) : unfolded_(&unfolded) {}
  // All definitions are looked into.
  explicit Estimate(const std::map<Variable, Rational, Before>& values) {
    for (const auto& [variable, value] : values) {
      values_.emplace(variable, number(static_cast<Real>(value.get_d())));
    }
  }

  const Value& operator()(const Term& term) {
    const auto known = values_.find(term);
    return known != values_.end() ? known->second : values_.emplace(term, value(term)).first->second;
  }

 private:
  // Numbers between 1/2 and 3/2 that stand for something of which only name and arguments are known.
  static Value made_up(const std::string& name, const Type& type, const std::vector<Value>& arguments) {
    std::size_t seed = std::hash<std::string>{}(name);
    const auto mix = [&seed](std::size_t next) {
      seed = (seed ^ next) * 0x9e3779b97f4a7c15ULL + (seed >> 29U);
    };
    for (const Value& argument : arguments) {
      for (const Real& entry : argument.reshaped()) {
        mix(static_cast<std::size_t>(std::llround(entry * 1e8L)));
      }
    }
    Value result(type.rows, type.columns);
    for (Real& entry : result.reshaped()) {
      mix(0x632be59bd9b4e019ULL);
      entry = 0.5L + static_cast<Real>(seed >> 11U) / static_cast<Real>(1ULL << 53U);
    }
    return result;
  }

  Value value(const Term& term) {
    const std::vector<Term>& parts = term.parts();
    const auto part = [&](std::size_t i) -> const Value& { return (*this)(parts[i]); };
    switch (term.kind()) {
      case Kind::number:
        return number(static_cast<Real>(term.value().get_d()));
      case Kind::pi:
        return number(std::numbers::pi_v<Real>);
      case Kind::variable:
        return made_up(term.name(), term.type(), {});
      case Kind::sum: {
        Value total = part(0);
        for (std::size_t i = 1; i < parts.size(); ++i) {
          total += part(i);
        }
        return total;
      }
      case Kind::product: {
        const Value &left = part(0), &right = part(1);
        return left.size() == 1    ? Value(left(0, 0) * right)
               : right.size() == 1 ? Value(left * right(0, 0))
                                   : Value(left * right);
      }
      case Kind::power:
        return number(std::pow(part(0)(0, 0), static_cast<Real>(term.value().get_d())));
      case Kind::inverse:
        return part(0).inverse();
      case Kind::cosine:
        return number(std::cos(part(0)(0, 0)));
      case Kind::sine:
        return number(std::sin(part(0)(0, 0)));
      case Kind::matrix: {
        Value result(term.type().rows, term.type().columns);
        for (std::size_t i = 0; i < parts.size(); ++i) {
          result(static_cast<Eigen::Index>(i) / result.cols(), static_cast<Eigen::Index>(i) % result.cols()) =
              part(i)(0, 0);
        }
        return result;
      }
      case Kind::entry:
        return number(part(0)(term.row(), term.column()));
      case Kind::defined: {
        if (unfolded_ == nullptr || unfolded_->contains(term.definition())) {
          return (*this)(term.definition().unfolded(parts));
        }
        std::vector<Value> arguments;
        for (const Term& argument : parts) {
          arguments.push_back(argument.type().is_numeric() ? (*this)(argument) : number(0));
        }
        return made_up(term.definition().name(), term.type(), arguments);
      }
      case Kind::apply:
        return made_up(parts[0].kind() == Kind::variable ? parts[0].name() : to_string(parts[0]), term.type(),
                       {part(1)});
      default:
        throw KernelError("no number: " + to_string(term));
    }
  }

  const Definitions * unfolded_ = nullptr;
  std::map<Term, Value> values_;
};

}  // namespace

double estimated(const Term& number, const std::map<Variable, Rational, Before>& values) {
  return static_cast<double>(Estimate(values)(number)(0, 0));
}

bool seems_zero(const std::vector<Term>& parts, const Definitions& unfolded) {
  Estimate estimate(unfolded);
  Value total = estimate(parts.front());
  Real size = 1 + total.cwiseAbs().maxCoeff();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Value& part = estimate(parts[i]);
    total += part;
    size = std::max(size, part.cwiseAbs().maxCoeff());
  }
  const Real rest = total.cwiseAbs().maxCoeff();
  return !std::isfinite(rest) || rest <= nearly * size;
}

}  // namespace stickslip::proofs::tactics
