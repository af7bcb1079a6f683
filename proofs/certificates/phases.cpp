#include "proofs/certificates/phases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "proofs/certificates/coq_terms.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

// Powers of atoms, by their text; and a sum of rational multiples of such.
using Monomial = std::map<std::string, long>;
using Linear = std::map<Monomial, Rational>;

Linear scaled(const Linear& sum, const Rational& factor, const Monomial& by) {
  Linear result;
  for (const auto& [monomial, coefficient] : sum) {
    Monomial product = monomial;
    for (const auto& [atom, power] : by) {
      if ((product[atom] += power) == 0) {
        product.erase(atom);
      }
    }
    result[product] += coefficient * factor;
  }
  return result;
}

void add(Linear& total, const Linear& more) {
  for (const auto& [monomial, coefficient] : more) {
    if ((total[monomial] += coefficient) == 0) {
      total.erase(monomial);
    }
  }
}

Linear times(const Linear& a, const Linear& b) {
  Linear result;
  for (const auto& [monomial, coefficient] : b) {
    add(result, scaled(a, coefficient, monomial));
  }
  return result;
}

Linear linear(const Term& term);

Linear reciprocal(const Term& term) {
  const Linear inverted = linear(term);
  if (inverted.size() != 1) {
    return {{{{coq(term), -1}}, 1}};
  }
  Monomial monomial = inverted.begin()->first;
  for (auto& [atom, power] : monomial) {
    power = -power;
  }
  return {{monomial, 1 / inverted.begin()->second}};
}

Linear linear(const Term& term) {
  switch (term.kind()) {
    case Kind::number:
      return term.value() == 0 ? Linear{} : Linear{{{}, term.value()}};
    case Kind::sum: {
      Linear total;
      for (const Term& part : term.parts()) {
        add(total, linear(part));
      }
      return total;
    }
    case Kind::product:
      if (term.parts()[0].type().is_scalar() && term.parts()[1].type().is_scalar()) {
        return times(linear(term.parts()[0]), linear(term.parts()[1]));
      }
      break;
    case Kind::power: {
      Linear total{{{}, 1}};
      for (long k = term.value().get_num().get_si(); k > 0; --k) {
        total = times(total, linear(term.parts()[0]));
      }
      return total;
    }
    case Kind::inverse:
      return reciprocal(term.parts()[0]);
    default:
      break;
  }
  return {{{{coq(term), 1}}, 1}};
}

std::string text(const Monomial& monomial) {
  std::string product;
  for (const auto& [atom, power] : monomial) {
    for (long k = std::abs(power); k > 0; --k) {
      product += product.empty() ? (power < 0 ? "/ " + atom : atom) : (power < 0 ? " / " : " * ") + atom;
    }
  }
  const bool one_atom = monomial.size() == 1 && monomial.begin()->second == 1;
  return product.empty() ? "1" : one_atom ? product : "(" + product + ")";
}

// Without parentheses: what differs without them differs in Coq.
std::string bare(std::string text) {
  std::erase_if(text, [](char c) { return c == '(' || c == ')'; });
  return text;
}

const Monomial pi{{"PI", 1}};

// A multiple of pi without whole turns: more than -2, less than 2. What is between stays, for the double of
// an angle is to be seen as such.
Rational within_turn(const Rational& coefficient) {
  mpz_class turns;
  mpz_tdiv_q(turns.get_mpz_t(), coefficient.get_num_mpz_t(),
             mpz_class(2 * coefficient.get_den()).get_mpz_t());
  return coefficient - Rational(2 * turns);
}

// A multiple of a phase: a monomial divided by a whole number.
struct Part {
  Monomial monomial;
  Rational coefficient;
};

bool is_quarters(const Part& part) {
  return part.monomial == pi && Rational(part.coefficient * 2).get_den() == 1;
}

// By which numbers a monomial is divided: those of its coefficients, in as few phases as have no factor in
// common; fractions of pi with nothing in common may be phases of their own.
class Divisors {
 public:
  explicit Divisors(bool pi_apart) : pi_apart_(pi_apart) {}
  void add(const Part& part) {
    mpz_class divisor = part.coefficient.get_den();
    std::vector<mpz_class>& known = divisors_[part.monomial];
    for (auto one = known.begin(); one != known.end();) {
      if (part.monomial != pi || !pi_apart_ || gcd(*one, divisor) > 1) {
        divisor = lcm(*one, divisor);
        one = known.erase(one);
      } else {
        ++one;
      }
    }
    known.push_back(divisor);
  }
  [[nodiscard]] mpz_class of(const Part& part) const {
    const std::vector<mpz_class>& known = divisors_.at(part.monomial);
    return *std::find_if(known.begin(), known.end(), [&](const mpz_class& one) {
      return Rational(part.coefficient * one).get_den() == 1;
    });
  }
  [[nodiscard]] static std::string phase(const Monomial& monomial, const mpz_class& divisor) {
    return divisor == 1 ? text(monomial) : fmt::format("({} / {})", text(monomial), divisor.get_str());
  }
  [[nodiscard]] std::vector<std::string> phases() const {
    std::vector<std::string> all;
    for (const auto& [monomial, known] : divisors_) {
      for (const mpz_class& divisor : known) {
        all.push_back(phase(monomial, divisor));
      }
    }
    return all;
  }

 private:
  bool pi_apart_;
  std::map<Monomial, std::vector<mpz_class>> divisors_;
};

// The largest number of which all are whole multiples.
Rational common_unit(const std::set<Rational>& numbers) {
  mpz_class numerator, divisor = 1;
  for (const Rational& one : numbers) {
    numerator = gcd(numerator, one.get_num());
    divisor = lcm(divisor, one.get_den());
  }
  Rational unit(numerator, divisor);
  unit.canonicalize();
  return unit;
}
Rational unit_of(const Rational& number, const Numbers& numbers) {
  const auto of = std::ranges::find_if(
      numbers, [&](const std::set<Rational>& together) { return together.contains(abs(number)); });
  return common_unit(*of);
}
std::string phase(const Rational& unit) {
  return unit.get_den() == 1 ? unit.get_num().get_str()
                             : fmt::format("({} / {})", unit.get_num().get_str(), unit.get_den().get_str());
}
std::set<Term> arguments_in(const std::vector<Term>& terms, const std::set<Kind>& functions) {
  std::set<Term> arguments;
  tactics::each_part(terms, [&](const Term& part) {
    if (functions.contains(part.kind())) {
      arguments.insert(part.parts()[0]);
    }
    return part.kind() != Kind::lambda;
  });
  return arguments;
}
const std::set circular{Kind::cosine, Kind::sine}, exponential{Kind::exponential},
    all_functions{Kind::cosine, Kind::sine, Kind::exponential};
// The numbers that are added in the argument, times the factor: those that stand apart may have phases of
// their own.
void collect_numbers(const Term& argument, const Rational& factor, std::vector<Rational>& found) {
  const Linear whole = linear(argument);
  const auto number = whole.find({});
  const auto is_number = [](const Term& term) {
    return std::ranges::all_of(linear(term), [](const auto& part) { return part.first.empty(); });
  };
  const bool scales = argument.kind() == Kind::product && argument.parts()[0].type().is_scalar() &&
                      argument.parts()[1].type().is_scalar();
  if (argument.kind() == Kind::sum) {
    for (const Term& part : argument.parts()) {
      collect_numbers(part, factor, found);
    }
  } else if (scales && is_number(argument.parts()[0]) != is_number(argument.parts()[1])) {
    const std::size_t by = is_number(argument.parts()[0]) ? 0 : 1;
    const Linear scale = linear(argument.parts()[by]);
    if (!scale.empty()) {
      collect_numbers(argument.parts()[1 - by], factor * scale.begin()->second, found);
    }
  } else if (number != whole.end()) {
    found.push_back(factor * number->second);
  }
}
std::vector<Rational> numbers_in(const Term& argument) {
  std::vector<Rational> found;
  collect_numbers(argument, 1, found);
  return found;
}

void repeat(std::vector<std::string>& parts, const std::string& part, const Rational& times) {
  if (abs(times) > 40) {
    throw KernelError("a phase is taken more than 40 times");
  }
  for (long k = std::abs(times.get_num().get_si()); k > 0; --k) {
    // Coq reads - 3 as a number of its own.
    const bool whole = part.find_first_not_of("0123456789") == std::string::npos;
    parts.push_back(times > 0 ? part : whole ? fmt::format("- ({})", part) : fmt::format("- {}", part));
  }
}

}  // namespace

std::set<Rational> numbers_in_phases(const std::vector<Term>& terms) {
  std::set<Rational> numbers;
  for (const Term& argument : arguments_in(terms, all_functions)) {
    for (const Rational& number : numbers_in(argument)) {
      numbers.insert(abs(number));
    }
  }
  return numbers;
}

std::vector<Term> apart(const std::vector<Term>& terms, const Numbers& numbers) {
  std::vector<Term> result = terms;
  for (const Term& argument : arguments_in(terms, all_functions)) {
    Term other = argument;
    for (const Rational& number : numbers_in(argument)) {
      const Rational unit = unit_of(number, numbers);
      other = other - Term(number) + Term(Rational(number / unit)) * Variable{"phase " + unit.get_str()};
    }
    for (Term& term : result) {
      term = replaced(replaced(term, cos(argument), cos(other)), sin(argument), sin(other));
      term = replaced(term, exp(argument), exp(other));
    }
  }
  return result;
}

namespace {

// Where turns count, multiples of pi/2 are no phases.
Expansions expansions(const std::set<Term>& arguments, const Numbers& numbers, bool has_turns) {
  struct Sum {
    std::vector<Part> parts;
    Rational turns = 0;
  };
  std::map<Term, Sum> sums;
  Divisors divisors(has_turns);
  for (const Term& argument : arguments) {
    Sum& sum = sums[argument];
    for (const auto& [monomial, coefficient] : linear(argument)) {
      Part part{monomial, coefficient};
      if (has_turns && monomial == pi) {
        part.coefficient = within_turn(coefficient);
        sum.turns = (coefficient - part.coefficient) / 2;
      }
      sum.parts.push_back(part);
      if (!part.monomial.empty() && !(has_turns && is_quarters(part))) {
        divisors.add(part);
      }
    }
  }
  Expansions result{.arguments = {}, .phases = divisors.phases()};
  for (const std::set<Rational>& together : numbers) {
    result.phases.push_back(phase(common_unit(together)));
  }
  std::set<std::string> done;
  for (const auto& [argument, sum] : sums) {
    std::vector<std::string> parts;
    for (const Part& part : sum.parts) {
      if (has_turns && is_quarters(part)) {
        repeat(parts, "(PI / 2)", part.coefficient * 2);
      } else if (part.monomial.empty()) {
        for (const Rational& number : numbers_in(argument)) {
          const Rational unit = unit_of(number, numbers);
          repeat(parts, phase(unit), number / unit);
        }
      } else {
        const mpz_class divisor = divisors.of(part);
        repeat(parts, Divisors::phase(part.monomial, divisor), part.coefficient * divisor);
      }
    }
    // Last, so that they go first.
    repeat(parts, "(2 * PI)", sum.turns);
    const std::string shown = coq(argument);
    result.of_zero = result.of_zero || shown == "0";
    const bool is_phase = parts.size() == 1 && parts[0] == shown && !(has_turns && is_quarters(sum.parts[0]));
    if (shown == "0" || is_phase || !done.insert(shown).second) {
      continue;
    }
    const std::string all = parts.empty() ? "0" : fmt::format("{}", fmt::join(parts, " + "));
    // Another term than the argument, so that the two can be told apart.
    result.arguments.push_back({shown, bare(all) == bare(shown) ? all + " + 0" : all});
  }
  return result;
}

}  // namespace

Phases phases_of(const std::vector<Term>& terms, const Numbers& numbers) {
  const std::set<Term> exponents = arguments_in(terms, exponential);
  return {expansions(arguments_in(terms, circular), numbers, true),
          exponents.empty() ? Expansions{} : expansions(exponents, numbers, false)};
}

}  // namespace stickslip::proofs::certificates
