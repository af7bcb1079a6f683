// Appendix 5 for two motions: what the kernel proves of them, and false variants that it must refuse.
#include <doctest/doctest.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/checks/mutants.hpp"
#include "proofs/methods/motions.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/meaning.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "tests/proofs/checks/decided.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;
using namespace stickslip::proofs::symbols;
using namespace stickslip::proofs::symbols::vocabulary;

namespace {

const std::vector<std::string> chain{"A5.energy", "A5.sides",  "A5.difference", "A5.free",
                                     "A5.moves",  "A5.unique", "A5.mirror",     "A5.symmetry"};

Claim claim_of(const std::string& id) {
  const std::vector<Claim>& all = paper().claims;
  return *std::find_if(all.begin(), all.end(), [&](const Claim& claim) { return claim.id == id; });
}

// The outcome of a claim beside the paper's, under another id.
Outcome outcome(Claim claim) {
  claim.id = "variant";
  Outcome result = claim.prove(the_prover(), claim);
  look_for_witness(result, the_prover(), claim);
  return result;
}

bool refused(const Claim& claim) {
  const Outcome result = outcome(claim);
  return result.verdict.truth == Truth::refuted ||
         (!result.by_kernel && result.theorems.empty() && result.verdict.truth == Truth::undecided);
}

// Proved, if at all, where something nonzero that it does not assume is nonzero.
bool conditional(const Claim& claim) {
  return refused(claim) || !outcome(claim).hypotheses.empty();
}

Claim printing(const std::string& id, const Statement& statement) {
  Claim claim = claim_of(id);
  claim.printed = {statement};
  return claim;
}

// The claim with another assumption under this id.
Claim assuming_instead(const std::string& id, const std::string& assumption, const Statement& statement) {
  Claim claim = claim_of(id);
  std::ranges::find(claim.assumptions, assumption, &Assumption::id)->statement = statement;
  return claim;
}

Statement law(const Term& motion, const Term& side, const Term& end) {
  return almost_always(
      0, end,
      equation(derivative(motion),
               first_order(K) * motion + column({0, 0, 0, eta * us * side + p * cos(omega * t + phi)})));
}

const Term speed_x = component(3, X(t)), speed_y = component(3, Y(t));
const Term below_x = sign(V - speed_x), below_y = sign(V - speed_y);

}  // namespace

TEST_SUITE_BEGIN("the_whole_audit" * doctest::skip());

TEST_CASE("uniqueness and symmetry are theorems that rest on no more than they say, and need all of it") {
  for (const std::string& id : chain) {
    CAPTURE(id);
    const Record& record = proofs::record(id);
    CHECK(record.status == (record.claim.origin == Origin::paper ? Status::as_printed : Status::proved));
    CHECK(record.outcome.by_kernel);
    REQUIRE(record.outcome.theorems.size() == 1);
    CHECK(record.outcome.hypotheses.empty());
    CHECK(record.outcome.assumed.size() == record.claim.assumptions.size());
    // Each hypothesis is a formula that is assumed, or of the parameters' domain.
    Reader read;
    kernel::Formulas known;
    for (const Assumption& assumption : record.claim.assumptions) {
      known.insert(read(assumption.statement));
    }
    for (const kernel::Theorem& one : parameters()) {
      known.insert(one.hypotheses().begin(), one.hypotheses().end());
    }
    for (const kernel::Formula& one : record.outcome.theorems.front().hypotheses()) {
      CHECK(known.contains(one));
    }
  }
}

TEST_CASE("without any one of what is assumed there is no theorem") {
  for (const std::string& id : chain) {
    const Claim whole = claim_of(id);
    for (const Assumption& dropped : whole.assumptions) {
      CAPTURE(id);
      CAPTURE(dropped.id);
      Claim less = whole;
      std::erase_if(less.assumptions, [&](const Assumption& one) { return one.id == dropped.id; });
      CHECK((dropped.id == "70.resonance" ? conditional(less) : refused(less)));
    }
  }
}

TEST_CASE("the energy decreases by friction of this sign only") {
  // Friction that drives the difference, on one side or on both.
  CHECK(refused(assuming_instead("A5.energy", "4.x", law(X(t), -below_x, Theta))));
  CHECK(refused(assuming_instead("A5.sides", "4.x", law(X(t), -below_x, Theta))));
  CHECK(refused(assuming_instead("A5.unique", "4.y", law(Y(t), sign(speed_y - V), Theta))));
  // Two belts.
  CHECK(refused(assuming_instead("A5.unique", "4.y", law(Y(t), sign(-V - speed_y), Theta))));
  // The law that says nothing of where it slips.
  CHECK(refused(assuming_instead("A5.unique", "4.y", law(Y(t), scalar("s0"), Theta))));
  const Claim driven =
      printing("A5.energy", almost_always(0, Theta, equation(derivative(power(speed_x, 2)), 0)));
  CHECK(refused(driven));
  CHECK(refused(printing("A5.sides", almost_always(0, Theta, equation(below_x, -below_y)))));
  CHECK(refused(printing("A5.sides", almost_always(0, Theta, equation(below_x, 1)))));
  CHECK(refused(printing("A5.sides", during(0, Theta, equation(speed_x, speed_y)))));
  for (const Term& weight : {-2 * us, us - us, V}) {
    Claim claim = claim_of("A5.sides");
    claim.prove = by_periodic_decrease(
        {.rate = from("A5.energy"), .returns = {"A5.returns.x", "A5.returns.y"}, .weight = weight});
    CHECK(refused(claim));
  }
}

TEST_CASE("equal frictions at one time are not equal frictions at almost all times") {
  Claim claim = claim_of("A5.moves");
  for (const Statement& same : {equation(component(3, X(0)), component(3, Y(0))), equation(speed_x, speed_y),
                                during(0, Theta / 2, equation(speed_x, speed_y)),
                                almost_always(0, Theta / 2, equation(below_x, below_y)),
                                almost_always(0, Theta, equation(below_x, -below_y))}) {
    Claim some = claim;
    some.assumptions = {claim.assumptions[0], claim.assumptions[1], {"same", same}};
    some.prove = by_chain_rule({assuming("4.x"), assuming("4.y"), assuming("same")});
    CAPTURE(text(same));
    CHECK(refused(some));
  }
  const Statement always = almost_always(0, Theta, equation(below_x, below_y));
  claim.assumptions = {claim.assumptions[0], claim.assumptions[1], {"same", always}};
  claim.prove = by_chain_rule({assuming("4.x"), assuming("4.y"), assuming("same")});
  CHECK(outcome(claim).by_kernel);
}

TEST_CASE("all is said of one interval") {
  CHECK(refused(assuming_instead("A5.unique", "4.y", law(Y(t), below_y, Theta / 2))));
  CHECK(refused(assuming_instead("A5.unique", "A5.returns.y", equation(Y(2 * Theta), Y(0)))));
  CHECK(refused(assuming_instead("A5.unique", "A5.returns.y", equation(X(Theta), Y(0)))));
  CHECK(refused(assuming_instead("A5.unique", "t.to", {t, 2 * Theta, Relation::less_or_equal})));
  CHECK(conditional(
      assuming_instead("A5.unique", "70.resonance",
                       {cos(omega1 * Theta / 2) * cos(omega2 * Theta / 2), 0, Relation::not_equal})));
  CHECK(conditional(
      assuming_instead("A5.free", "70.resonance", {sin(omega1 * Theta / 2), 0, Relation::not_equal})));
  CHECK(refused(assuming_instead("A5.mirror", "4.x", law(X(t), below_x, Theta))));
  CHECK(refused(assuming_instead("A5.mirror", "28.period", equation(Theta, 3 * pi() / omega))));
  CHECK(refused(assuming_instead("A5.symmetry", "28.period", equation(Theta, pi() / omega))));
  CHECK(refused(assuming_instead("A5.symmetry", "4.x", law(X(t), below_x, Theta))));
  CHECK(refused(assuming_instead("A5.symmetry", "A5.returns.later", equation(X(Theta / 2), X(0)))));
  CHECK(refused(assuming_instead("A5.symmetry", "A5.V", equation(V, 1))));
  // A longer interval is as good.
  CHECK(outcome(assuming_instead("A5.unique", "4.y", law(Y(t), below_y, 2 * Theta))).by_kernel);
}

TEST_CASE("what follows is this and nothing like it") {
  const Term later = t + Theta / 2;
  for (const Statement& wrong :
       {equation(X(t), -Y(t)), equation(X(t), Y(t + Theta)), equation(X(t), Y(later)),
        equation(X(t), 2 * Y(t)), equation(X(t), zero(4, 1)), equation(X(0), Y(Theta / 2)), equation(t, 0),
        equation(1, 0)}) {
    CAPTURE(text(wrong));
    CHECK(refused(printing("A5.unique", wrong)));
  }
  for (const Statement& wrong : {equation(X(t), X(later)), equation(X(t), -X(t + Theta)),
                                 equation(X(t), -X(t)), equation(X(t), -X(t + Theta / 4))}) {
    CAPTURE(text(wrong));
    CHECK(refused(printing("A5.symmetry", wrong)));
  }
  const Function delta{"delta", {4, 1}};
  CHECK(refused(printing("A5.difference", equation(delta(t), H(-t) * delta(0)))));
  CHECK(refused(printing("A5.difference", equation(delta(t), delta(0)))));
  CHECK(outcome(printing("A5.unique", equation(X(t) - Y(t), zero(4, 1)))).by_kernel);
}

TEST_CASE("no single edit of what is printed survives, but for what is true, too") {
  const std::set<std::string> ids(chain.begin(), chain.end());
  const checks::Gate gate =
      checks::mutant_gate(paper().claims, ids, {}, [](const std::string&, std::size_t, std::size_t) {});
  CHECK(gate.mutants.size() > 50);
  for (const checks::Mutant& mutant : gate.mutants) {
    CAPTURE(mutant.claim);
    CAPTURE(mutant.statement);
    CHECK(mutant.fate != checks::Fate::survived);
  }
}

TEST_CASE("almost always is read with continuity, a finite set, and strict signs") {
  Reader read;
  const kernel::Variable x{"X", kernel::function_of_time(4)}, time{"t"}, end{"Theta"};
  const kernel::Term V_ = kernel::Variable{"V"};
  const kernel::Term row = kernel::matrix(1, 4, {0, 0, 0, 1}), X_t = apply(x, time), gap = V_ - row * X_t;
  const Statement doubling = equation(derivative(X(t)), below_x * X(t));
  const auto rate = [&](int side) { return kernel::derivative(x, time, kernel::Term(side) * X_t); };
  const kernel::Formula usual = kernel::any(
      {kernel::all({kernel::less(0, gap), rate(1)}), kernel::all({kernel::less(gap, 0), rate(-1)})});
  CHECK(read(almost_always(0, Theta, doubling)) ==
        kernel::all(
            {kernel::continuous(x, 0, end),
             kernel::finite(time, kernel::all({kernel::between(0, time, end), kernel::negation(usual)}))}));
  // A sign has no meaning where its argument may be zero, nor a derivative, a sign or the time where they
  // stand for something else.
  CHECK_THROWS_AS((void)read(during(0, Theta, doubling)), NoValue);
  CHECK_THROWS_AS((void)read(equation(V, below_x)), NoValue);
  CHECK_THROWS_AS((void)read(almost_always(0, Theta, equation(V, sign(sign(V))))), NoValue);
  CHECK_THROWS_AS((void)read(almost_always(0, Theta, equation(derivative(below_x), 0))), NoValue);
  CHECK_THROWS_AS((void)read(almost_always(0, Theta, equation(derivative(X(t)), derivative(Y(t))))), NoValue);
  CHECK_THROWS_AS((void)read(almost_always(0, Theta, equation(X(t), derivative(X(t))))), NoValue);
  CHECK_THROWS_AS((void)read(almost_always(0, Theta, equation(V, sign(derivative(speed_x))))), NoValue);
  CHECK_THROWS_AS((void)read(almost_always(0, derivative(speed_x), equation(X(t), Y(t)))), NoValue);
  CHECK_THROWS_AS((void)read(almost_always(0, Theta, {derivative(speed_x), V, Relation::less})), NoValue);
  CHECK_THROWS_AS((void)read(almost_always(0, t, equation(X(t), Y(t)))), NoValue);
}

TEST_CASE("on a moving belt the slip below the belt's velocity is the longer one, and nothing else follows") {
  for (const char * id : {"A5.tan", "A5.longer", "A5.stable"}) {
    CHECK(outcome(claim_of(id)).by_kernel);
  }
  CHECK(refused(printing("A5.tan", {sin(s), s * cos(s), Relation::less})));
  CHECK(refused(
      assuming_instead("A5.tan", "s.pi", {s, 2 * pi(), Relation::less})));  // sin(s) < s cos(s) near 3/2 pi
  CHECK(refused(printing("A5.longer", {tau, Theta / 2, Relation::less})));
  CHECK(refused(printing("A5.longer", {2 * Theta / 3, tau, Relation::less})));
  CHECK(refused(assuming_instead("A5.longer", "A5.V.sign", {V, 0, Relation::less})));
  CHECK(refused(assuming_instead("A5.longer", "A5.V.sign", equation(V, 0))));
  Claim grows = claim_of("A5.stable");
  std::swap(grows.printed.front().left, grows.printed.front().right);
  CHECK(refused(grows));
  CHECK(refused(assuming_instead("A5.stable", "Theta.positive", {Theta, 0, Relation::less})));
}

TEST_SUITE_END();
