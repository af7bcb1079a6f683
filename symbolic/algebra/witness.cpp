#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "symbolic/algebra/decide.hpp"
#include "symbolic/algebra/evaluate.hpp"

namespace stickslip::symbolic::algebra {
namespace {

using GiNaC::ex;

std::string name_of(const ex& symbol) {
  return GiNaC::ex_to<GiNaC::symbol>(symbol).get_name();
}

// Small rationals, so that a reader can type them: 0 < omega1 < 1 < omega2, everything else positive.
Rational draw(const std::string& name, std::mt19937& generator) {
  const auto pick = [&](unsigned most) { return 1 + static_cast<long>(generator() % most); };
  Rational value(name == "omega1" ? pick(9) : pick(29), 10);
  value.canonicalize();
  return name == "omega2" ? Rational(1) + value : value;
}

std::vector<std::string> sorted_names(const GiNaC::exset& symbols) {
  std::vector<std::string> names;
  std::transform(symbols.begin(), symbols.end(), std::back_inserter(names), name_of);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

bool differs_from_zero(const ex& expression) {
  std::mt19937 generator(2);
  std::map<std::string, ex> symbols;
  for (const ex& symbol : symbols_of(expression)) {
    symbols[name_of(symbol)] = symbol;
  }
  const WorkingPrecision precision(128);
  BallValues values;
  for (const auto& [name, symbol] : symbols) {
    values[symbol] = Ball(draw(name, generator));
  }
  return evaluate(expression, values).is_nonzero();
}

std::optional<Witness> find_witness(const ex& left, const ex& right) {
  constexpr int points = 40;
  const GiNaC::exset symbols = symbols_of(GiNaC::lst{left, right});
  std::mt19937 generator(1);  // the same points on every run
  for (int i = 0; i < points; ++i) {
    Witness witness;
    std::map<std::string, Rational> values;
    for (const std::string& name : sorted_names(symbols)) {
      witness.point.push_back({name, draw(name, generator)});
      values[name] = witness.point.back().value;
    }
    for (const long bits : {64, 256, 1024}) {
      const WorkingPrecision precision(bits);
      BallValues balls;
      for (const ex& symbol : symbols) {
        balls[symbol] = Ball(values[name_of(symbol)]);
      }
      witness.left = evaluate(left, balls);
      witness.right = evaluate(right, balls);
      if (!witness.left.overlaps(witness.right)) {
        return witness;
      }
    }
  }
  return std::nullopt;
}

}  // namespace stickslip::symbolic::algebra
