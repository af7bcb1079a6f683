// What (1) and (3) say beyond names.
#include <doctest/doctest.h>

#include "proofs/methods/implications.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "tests/proofs/checks/decided.hpp"
#include "tests/proofs/checks/wrong.hpp"

using namespace stickslip::proofs;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
namespace k = stickslip::proofs::kernel;

namespace {

const k::Theorem& theorem_of(const std::string& id) {
  return record(id).outcome.theorems.at(0);
}

}  // namespace

TEST_SUITE_BEGIN("the_whole_audit" * doctest::skip());

TEST_CASE("Omega is one positive number: there is one, and any two are equal") {
  const k::Variable k1{"k1"}, k2{"k2"}, m1{"m1"}, x{"x"}, y{"y"};
  const auto is_unit = [&](const k::Variable& one) {
    return k::all({k::less(0, one), k::equal(k::power(one, 2), (k::Term(k1) + k2) / m1)});
  };
  CHECK(theorem_of("3.Omega").hypotheses() == k::Formulas{k::less(0, k1), k::less(0, k2), k::less(0, m1)});
  CHECK(theorem_of("3.Omega").conclusion() ==
        k::all({k::exists(x, is_unit(x)),
                k::for_all(x, k::for_all(y, k::implies(k::all({is_unit(x), is_unit(y)}), k::equal(x, y))))}));
}

TEST_CASE("the chain rule multiplies velocities by Omega and accelerations by its square") {
  const k::Theorem& theorem = theorem_of("3.rates");
  CHECK(theorem.hypotheses().empty());
  CHECK(theorem.conclusion().variables().size() == 4);  // x, v, a, Omega
  // For x = t^2: the acceleration in time is 2 Omega^2.
  const k::Variable t{"t"};
  const auto f = [](const char * name) { return k::Variable{name, k::function_of_time()}; };
  const k::Theorem square = k::Theorem::instantiate(theorem, {{f("x"), k::lambda(t, k::power(t, 2))},
                                                              {f("v"), k::lambda(t, 2 * k::Term(t))},
                                                              {f("a"), k::lambda(t, 2)},
                                                              {k::Variable{"Omega"}, 3}});
  const k::Formula second = k::opened(square.conclusion().parts()[1].parts()[1], 0).parts()[1];
  CHECK(second.kind() == k::Kind::derivative);
  CHECK_NOTHROW(static_cast<void>(k::Theorem::combination(k::equal(second.parts()[2], 18))));
}

TEST_CASE("a theorem that rests on more than the ranges of its variables is none of a claim in words") {
  const auto truth = [](k::Theorem (*make)()) {
    const Claim claim{.id = "one", .place = "test", .words = "anything", .prove = by_theorem("", make)};
    return audit({claim}, {}).records.front().outcome.verdict.truth;
  };
  const auto wrong = [] { return k::Theorem::assume(k::equal(k::Variable{"x"}, 1)); };
  const auto any_truth = [] { return k::Theorem::assume(k::any({})); };
  const auto in_range = [] { return k::Theorem::assume(k::less(0, k::Variable{"x"})); };
  const auto fails = []() -> k::Theorem { throw k::KernelError("it does not come out"); };
  CHECK(truth(wrong) == stickslip::Truth::undecided);
  CHECK(truth(any_truth) == stickslip::Truth::undecided);
  CHECK(truth(in_range) == stickslip::Truth::proved);
  CHECK(truth(fails) == stickslip::Truth::undecided);
}

TEST_CASE("the load of (2) is that of (1) with the units of (3), and no other") {
  CHECK(record("3.load").outcome.by_kernel);
  CHECK(hypotheses("3.load").empty());
  int tried = 0;
  CHECK(proved_mutants(paper().claims, {"3.load"}, tried) == std::vector<std::string>{});
  CHECK(tried > 10);
}

TEST_SUITE_END();
