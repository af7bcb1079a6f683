// False sequents with proofs as an export would write them: Coq refuses each, and accepts the same proof of
// the sequent that is true.
#include <doctest/doctest.h>

#include "tests/proofs/certificates/coq.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;

namespace {

struct Sequent {
  const char * what;
  const char * variables;  // "(x y : R)"
  const char * lacking;    // the hypothesis without which it is false
  std::vector<std::string> hypotheses;
  const char * conclusion;
  const char * proof;
};

// An equation from others: by_difference, the identity, the multiples.
const char * const combined = R"(
  apply (by_difference _ _ (/ d * (d * z10 - 0) * 1)).
  { by_fractions. }
  { assert (z'1 : / d * (d * z10 - 0) * 1 = 0) by (rewrite (rdiffer _ _ hyp1); vanish). exact z'1. })";

const std::vector<Sequent> sequents{
    {"a division by what may be 0", "(d z10 : R)", "d <> 0", {"d * z10 = 0"}, "z10 = 0", combined},
    {"a quotient of a number by itself",
     "(tau1 : R)",
     "tau1 <> 0",
     {},
     "tau1 / tau1 = 1",
     "apply (by_difference _ _ 0). { by_fractions. } { exact eq_refl. }"},
    {"a sum of fractions over what may be 0",
     "(tau tau1 : R)",
     "tau + tau1 <> 0",
     {"tau - tau1 <> 0"},
     "tau / (2 * tau + 2 * tau1) + / 2 * (tau1 / (tau + tau1)) = / 2",
     "by_fractions."},
    {"a cosine and a sine of no angle",
     "(c s : R)",
     "c * c = 1 - s * s",
     {"s <> 0"},
     "c ^ 3 / s = c / s - c * s",
     "by_fractions."},
    {"cosines and sines of two angles, of which one is none",
     "(c s d e : R)",
     "c * c = 1 - s * s",
     {"d * d = 1 - e * e"},
     "(c + d) * (c - d) * (c * d) = (e ^ 2 - s ^ 2) * d * c",
     "by_fractions."},
    {"a sine divided by q2 omega",
     "(q omega phi : R)",
     "q * omega <> 0",
     {"q * omega * sin phi = 0"},
     "sin phi = 0",
     R"(
  apply (by_difference _ _ (/ (q * omega) * (q * omega * sin phi - 0) * 1)).
  { generalize (sin phi). intros. split_factors. by_fractions. }
  { assert (z'1 : / (q * omega) * (q * omega * sin phi - 0) * 1 = 0) by (rewrite (rdiffer _ _ hyp1); vanish).
    exact z'1. })"},
    {"an equation of one state said of all",
     "(z zbar : Mat 4 1) (A B : Mat 4 4)",
     "A ** z = B ** zbar",
     {},
     "A ** z = B ** zbar",
     R"(
  apply (by_difference_m 4 1 _ _ (A ** z -m B ** zbar)). { reflexivity. }
  { apply mdiffer. match goal with H : _ = _ |- _ => exact H end. })"},
    {"a closed form beyond its range",
     "(f : R -> R) (a b t : R)",
     "t <= b",
     {"continuous_on f a b", "forall s : R, a < s < b -> derivative f s 0", "a <= t"},
     "f t = f a",
     "apply (constant f a b hyp1 hyp2). split; assumption."},
    {"a zero of the sine without its range",
     "(x : R)",
     "x < 1 * PI",
     {"sin x = 0", "(-1) * PI < x"},
     "x = 0 * PI",
     R"(
  destruct (zero_of_sine _ hyp1) as [k' E'].
  assert (L' : -1 < IZR k' + 0) by (apply (Rmult_lt_reg_r PI); [exact PI_RGT_0 | rewrite <- E'; lra]).
  assert (U' : IZR k' + 0 < 1) by (apply (Rmult_lt_reg_r PI); [exact PI_RGT_0 | rewrite <- E'; assumption]).
  assert ((-1 < k')%Z) by (apply lt_IZR; lra). assert ((k' < 1)%Z) by (apply lt_IZR; lra).
  destruct (Z.eq_dec k' 0) as [->|?]; [rewrite E'; field|]. exfalso; lia.)"},
    {"a letter that is not tied to what it stands for",
     "(x y delta : R)",
     "delta = x - y",
     {"x = 1", "y = 1"},
     "delta = 0",
     R"(
  apply (by_difference _ _ (delta - (x - y) + (x - 1) - (y - 1))). { ring. }
  { rewrite hyp1, hyp2. match goal with H : delta = _ |- _ => rewrite H end. rewrite hyp1, hyp2. ring. })"},
    {"the mean value theorem on an interval that ends before it begins",
     "(tau : R)",
     "tau < 0",
     {},
     "exists c : R, 0 < c < (-1) * tau /\\ (-1) * tau - 0 = 1 * ((-1) * tau - 0)",
     R"(
  assert (C' : continuous_on (fun t : R => t) 0 ((-1) * tau)) by apply c_id.
  assert (D' : forall t : R, 0 < t < (-1) * tau -> derivative (fun t : R => t) t 1) by (intros; apply d_id).
  assert (L' : 0 < (-1) * tau) by lra.
  destruct (mean_value (fun t : R => t) (fun t : R => 1) _ _ L' C' D') as [c' [I' E']].
  exists c'. split; [exact I' | cbv beta in E'; lra].)"},
    {"a zero between two values of which one has no sign",
     "(f : R -> R) (a b : R)",
     "0 < f b",
     {"continuous_on f a b", "f a < 0", "a < b"},
     "exists c : R, a < c < b /\\ f c = 0",
     "apply (intermediate_value f a b); assumption."},
    {"a number that is nearer than its bound to what bounds it",
     "(x : R)",
     "Rabs (x - 1) <= / 4",
     {},
     "1 - / 4 <= x <= 1 + / 4",
     "apply by_distance. assumption."},
    {"a number between two bounds where its variable has one",
     "(x : R)",
     "x <= 2",
     {"1 <= x"},
     "1 <= x * x <= 5",
     "by_enclosure."},
    {"a number strictly between two bounds, one of which it may be",
     "(x : R)",
     "x < 3 / 2",
     {"1 <= x", "x <= 2"},
     "0 < x * x < 4",
     "by_enclosure."},
    {"a square, as a number that cannot be below 0, of a number without bound",
     "(x : R)",
     "x <= 1",
     {"(-1) <= x"},
     "cos x * cos x + x * x <= 2",
     "by_enclosure."},
    {"a number that was read before, where its variable has no bound",
     "(x : R)",
     "0 <= x",
     {"x <= 1"},
     "0 < x * x + x + 1 / 8",
     "by_known_enclosure (eq_refl (x * x + x + 1 / 8) : x * x + x + 1 / 8 = Tree.eval ltac:(number_read (fun "
     "x : R => "
     "x * x + x + 1 / 8)) (x :: nil))."},
    {"a polynomial of which one coefficient has no bound",
     "(c : R)",
     "c < 1",
     {"(-1) < c"},
     "inside_unit_circle (mat 2 1 ⟦⟦c⟧, ⟦1⟧⟧)",
     R"(
  apply inside_by_schur; cbv beta iota delta [schur next Nat.sub]; reduce_matrices.
  assert (c * c < 1) by nra. split; [lra | intros E'; lra].)"},
    {"a polynomial of degree two with a coefficient on the wrong side",
     "(c : R)",
     "0 <= c",
     {"c <= / 2"},
     "inside_unit_circle (mat 3 1 ⟦⟦c⟧, ⟦c / 4⟧, ⟦1⟧⟧)",
     R"(
  apply inside_by_schur; cbv beta iota delta [schur next Nat.sub]; reduce_matrices.
  repeat split; by_enclosure.)"},
    {"a decrease of a function that jumps",
     "(f : R -> R) (a b : R)",
     "continuous_on f a b",
     {"forall s : R, a < s < b -> exists v : R, derivative f s v /\\ 0 <= v", "a <= b"},
     "f a <= f b",
     R"(
  apply (monotone f a b); [assumption | | assumption].
  exists nil. intros t [I' N']. exfalso. apply N'. exact (hyp1 t I').)"},
    {"a derivative through t -> -t without the chain rule's factor",
     "(f : R -> R) (p v : R)",
     "v = (-1) * v",
     {"derivative f ((-1) * p) v"},
     "derivative (fun t : R => f ((-1) * t)) p v",
     R"(
  pose proof hyp1 as d'0. eapply d_value; [derive|]. cbv beta.
  transitivity ((-1) * v); [ring | symmetry; assumption].)"},
    {"a product of inequalities of which one sign is unknown",
     "(a b : R)",
     "0 < b",
     {"0 < a"},
     "0 < a * b",
     R"(
  apply (by_less _ _ (1 * 1 ^ 2 * (a - 0) * (b - 0))). { ring. }
  { pose proof (less_gap _ _ hyp1) as p'0. assert (p'1 : 0 < b - 0) by lra. positive_sum. })"},
    {"a whole number that does not fit",
     "(tau : R)",
     "tau = 0",
     {},
     "4294967297 * tau = tau",
     "apply (by_difference _ _ (4294967296 * tau)). { ring. } { lra. }"},
    {"cos tau squared is not 1, where sin tau is 0",
     "(tau : R)",
     "sin tau <> 0",
     {},
     "cos tau ^ 2 <> 1",
     R"(
  intros E'. pose proof (circle tau).
  assert (S' : sin tau * sin tau = 0) by lra.
  destruct (zero_product _ _ S'); contradiction.)"},
    {"an inverse of a matrix that has none",
     "(A B : Mat 2 2)",
     "det 2 A <> 0",
     {"B = A ** B"},
     "minv A ** B = B",
     "apply (inverse_solves A _ _); [assumption | exact hyp1]."},
    {"2 = 0",
     "(x y : R)",
     "x = y",
     {"x = 1", "y = -1"},
     "2 = 0",
     R"(
  apply (by_difference _ _ ((x - y) - (x - 1) + (y - -1))). { ring. }
  { assert (z'1 : x - y = 0) by lra. rewrite z'1, hyp1, hyp2. ring. })"},
};

Asked asked(const Sequent& sequent, bool is_true) {
  std::string statement = std::string("  forall ") + sequent.variables + ",\n", names;
  const std::string variables(sequent.variables);
  if (is_true) {
    statement += std::string("  ") + sequent.lacking + " ->\n";
  }
  for (std::size_t k = 0; k < sequent.hypotheses.size(); ++k) {
    statement += "  (" + sequent.hypotheses[k] + ") ->\n";
    names += " hyp" + std::to_string(k + 1);
  }
  // The variables by their own names, the hypotheses as an export names them.
  std::string intros = "intros";
  std::string word;
  bool in_type = false;
  for (const char c : variables) {
    in_type = c == ':' || (in_type && c != ')');
    if (!in_type && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')) {
      word += c;
    } else if (!word.empty()) {
      intros += " " + word;
      word.clear();
    }
  }
  intros += (is_true ? " lacking" : "") + names + ".\n";
  return {statement + "  " + sequent.conclusion, intros + sequent.proof};
}

}  // namespace

TEST_CASE("Coq refuses every false sequent, and accepts the true one beside it" * doctest::timeout(600)) {
  const TemporaryDirectory temporary;
  (void)compiled(temporary.path(), {"38.init"});
  std::vector<Asked> all;
  for (const Sequent& sequent : sequents) {
    all.push_back(asked(sequent, false));
    all.push_back(asked(sequent, true));
  }
  const std::vector<bool> answers = accepted(temporary.path(), {}, all);
  for (std::size_t i = 0; i < sequents.size(); ++i) {
    CAPTURE(std::string(sequents[i].what));
    CHECK_FALSE(answers[2 * i]);
    CHECK(answers[2 * i + 1]);
  }
}
