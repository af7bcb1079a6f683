// Two engines of the kernel on the same random terms: what the normal form proves, balls must not refute at
// any point where its hypotheses hold; and derivatives by rule agree with differences in balls.
// STICKSLIP_SEED sets the terms.
#include "tests/numeric/families/random_data.hpp"
#include "tests/proofs/kernel/attacks.hpp"

using namespace stickslip::proofs::kernel;
using namespace stickslip::proofs::kernel::attacks;
using stickslip::Rational;

namespace {

class RandomTerms {
 public:
  explicit RandomTerms(unsigned seed) : engine_(seed) {}

  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }

  Term number(int depth) {
    const int kind = depth == 0 ? below(6) : below(17);
    switch (kind) {
      case 0:
      case 1:
        return x;
      case 2:
        return y;
      case 3:
        return below(3);
      case 4:
        return below(3) == 0 ? pi() : Term(Rational(1 + below(3), 2));
      case 5:
        return entry(M, below(2), below(2));
      case 6:
      case 7:
        return number(depth - 1) + number(depth - 1);
      case 8:
        return number(depth - 1) - number(depth - 1);
      case 9:
      case 10:
        return number(depth - 1) * number(depth - 1);
      case 11:
        return number(depth - 1) / number(depth - 1);
      case 12:
        return cos(number(depth - 1));
      case 13:
        return sin(number(depth - 1));
      case 14:
        return power(number(depth - 1), below(3));
      case 15:
        return exp(number(depth - 1));
      default:
        return entry(square(depth - 1), below(2), below(2));
    }
  }

  Term square(int depth) {
    switch (depth == 0 ? 0 : below(5)) {
      case 0:
        return M;
      case 1:
        return inverse(square(depth - 1));
      case 2:
        return square(depth - 1) * square(depth - 1);
      case 3:
        return square(depth - 1) + square(depth - 1);
      default:
        return matrix(2, 2, {number(depth - 1), number(depth - 1), number(depth - 1), number(depth - 1)});
    }
  }

  // A term that is equal to it for a reason that need not be sound.
  Term like(const Term& term) {
    switch (below(9)) {
      case 0:
        return term * number(1) / number(1);
      case 1:
        return term + number(1) - number(1);
      case 2:
        return term * (power(cos(number(1)), 2) + power(sin(number(1)), 2));
      case 3:
        return substitute(term, {{x, Term(x) + 2 * pi()}});
      case 4:
        return substitute(term, {{x, -Term(x)}});
      case 5:
        return substitute(term, {{x, pi() / 2 - x}});
      case 6:
        return substitute(term, {{x, y}});
      case 7:
        return 1 / (1 / term);
      default:
        return substitute(term, {{y, Term(y) * x / x}});
    }
  }

  Substitution point() {
    const auto coordinate = [&] { return Term(Rational(1 + below(40), 1 + below(16))); };
    return {{x, coordinate()},
            {y, coordinate()},
            {M, matrix(2, 2, {coordinate(), coordinate(), coordinate(), coordinate()})}};
  }

 private:
  std::mt19937_64 engine_;
};

// Whether balls show that all hypotheses d ≠ 0 of the theorem hold there, and that its equation does not.
bool is_contradicted(const Theorem& theorem, const Substitution& point) {
  const Theorem there = Theorem::instantiate(theorem, point);
  try {
    for (const Formula& hypothesis : there.hypotheses()) {
      static_cast<void>(Theorem::sign(hypothesis));
    }
    static_cast<void>(Theorem::sign(differ(there.conclusion().parts()[0], there.conclusion().parts()[1])));
  } catch (const KernelError&) {
    return false;
  }
  return true;
}

}  // namespace

TEST_CASE("what the normal form proves, balls do not refute") {
  const unsigned seed = stickslip::examples::RandomData().seed();
  INFO("STICKSLIP_SEED=", seed);
  RandomTerms terms(seed);
  int proved = 0;
  for (int k = 0; k < 4000; ++k) {
    const Term a = terms.number(2);
    const Term b = terms.below(4) == 0 ? terms.number(2) : terms.like(a);
    try {
      const Theorem theorem = Theorem::combination(equal(a, b));
      ++proved;
      INFO(to_string(theorem.sequent()));
      for (int i = 0; i < 3; ++i) {
        REQUIRE_FALSE(is_contradicted(theorem, terms.point()));
      }
    } catch (const KernelError&) {
      continue;  // not equal, or not decided
    }
  }
  CHECK(proved > 400);
}

TEST_CASE("a derivative by rule is near a difference in balls") {
  const unsigned seed = stickslip::examples::RandomData().seed();
  INFO("STICKSLIP_SEED=", seed);
  RandomTerms terms(seed);
  int compared = 0;
  const Rational h(1, 1 << 20);
  for (int k = 0; k < 1500; ++k) {
    const Substitution point = terms.point();
    Substitution rest = point;
    rest.erase(x);
    const Term f = lambda(t, substitute(substitute(terms.number(2), rest), {{x, t}}));
    const Term p = point.at(x);
    try {
      const Theorem slope = Theorem::differentiate(f, p);
      for (const Formula& hypothesis : slope.hypotheses()) {
        static_cast<void>(Theorem::sign(hypothesis));
      }
      const Term value = slope.conclusion().parts()[2];
      const Term difference = (apply(f, p + h) - apply(f, p - h)) / (2 * Term(h));
      const Term error = power(value - difference, 2), size = power(value, 2) + 1;
      static_cast<void>(
          Theorem::sign(less(size, 1000000)));  // no differences of what grows or turns too fast
      INFO(to_string(slope.sequent()));
      bool far = true;  // by more than a hundredth of its size
      try {
        static_cast<void>(Theorem::sign(less(size / 10000, error)));
      } catch (const KernelError&) {
        far = false;
      }
      // A pole or fast waves near by make any difference useless: a quarter of the step must say the same.
      if (far) {
        const Rational fine = h / 64;
        const Term finer = (apply(f, p + fine) - apply(f, p - fine)) / (2 * Term(fine));
        const Term finer_error = power(value - finer, 2);
        bool improves = true;
        try {
          static_cast<void>(Theorem::sign(less(finer_error, error / 100)));
        } catch (const KernelError&) {
          improves = false;
        }
        CHECK(improves);
      }
      ++compared;
    } catch (const KernelError&) {
      continue;  // a divisor is zero there
    }
  }
  CHECK(compared > 700);
}
