#include "tests/report/audit/sample.hpp"

#include "core/decimal.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::report {
namespace {

using namespace proofs;
using namespace proofs::symbols::vocabulary;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::symbols;

Record record(const char * id, const char * place, Status status, const char * words,
              const Statement& printed) {
  Record r;
  r.claim.id = id;
  r.claim.place = place;
  r.claim.words = words;
  r.claim.printed = {printed};
  r.status = status;
  if (status == Status::as_printed) {
    r.outcome.verdict = Verdict::proved();
    r.outcome.route = "by substitution";
  }
  return r;
}

Record misprint() {
  Record r = record("44", "A2", Status::misprint_corrected, "Time reversal, for $x < y$ & $y$ > \"0\".",
                    equation(H(-t) * E, -(E * H(t))));
  r.claim.assumptions = {{"13", equation(Z(tau), E * Z0)}, {"15", equation(Z(T), Z0)}};
  r.outcome.verdict = Verdict::refuted(
      Witness{{{"omega1", Rational(1, 2)}, {"t", Rational(1, 3)}}, "(2,1)", Ball(1), Ball(2)});
  r.claim.corrected = {equation(H(-t) * E, E * H(t))};
  r.corrected = Outcome{};
  r.corrected->verdict = Verdict::proved();
  r.corrected->uses = {"5"};
  r.corrected->assumed = {"13"};
  return r;
}

Record digits() {
  Record r = record("S.tau", "sec4", Status::digits_off, "The duration of the slip in the example of Fig. 2.",
                    equation(tau, Term(Rational(7749, 1000))));
  r.claim.kind = Kind::numbers;
  r.outcome.verdict = Verdict::refuted("7.749 is 1.3 units of its last place off");
  r.outcome.comparisons = {{"tau", "\\tau", "7.749",
                            Ball::from_interval(parse_rational("7.7502999"), parse_rational("7.7503001")),
                            Ball(parse_rational("-1.3")), Verdict::refuted("not the rounded value")}};
  return r;
}

}  // namespace

Paper sample_paper() {
  return {{"A. Author", "A Title", "A Journal 1 (2000) 1-2", "10.1000/1"},
          {{"sec2", "Section 2: the model", "section2"}, {"sec3", "Section 3: phases", "section3"}},
          {},
          {},
          {},
          {{"S001", "(2)", Kind::model, "both masses obey Newton's law", {"2"}, "", {}, "Section 2"},
           {"S002",
            "(5)",
            Kind::step,
            "the motion while the second mass slips",
            {"5", "5.where"},
            "",
            {},
            "Section 3"},
           {"S003", "(44)", Kind::identity, "time reversal, for $x < y$", {"44"}, "", {}, "Section 3"},
           {"S004", "Fig. 2", Kind::numbers, "$tau = 7.749$", {"S.tau"}, "", {}, "Section 4"},
           {"S005", "Fig. 2", Kind::figure, "a portrait is drawn", {}, "a drawing", {"17"}, "Section 4"}},
          {{"44", "line after (44)", "time runs backwards, for $x < y$", "it runs to $-t$", "$E$ & $H$",
            "stickslip check 44"}},
          {{"time",
            "Time is reversed",
            "Let $t$ be a time.",
            "for all $t$ & $x$",
            "by $E$",
            "stickslip check 5",
            {"5"}}}};
}

Audit sample_audit() {
  Record model = record("2", "sec2", Status::model, "Newton's law for both masses; $u_s$ is 100% of {$F$}.",
                        equation(Z(t), H(t) * Z0));
  model.claim.kind = Kind::model;
  Record proved = record("5", "sec3", Status::as_printed, "The motion while the second mass slips.",
                         equation(Z(t), H(t) * (Z0 - F0) + F(t)));
  proved.outcome.uses = {"2"};
  proved.outcome.free = {"omega1", "t"};
  proved.used_by = {"44"};
  model.used_by = {"5"};
  Record needs =
      record("5.where", "sec3", Status::needs_hypotheses, "The same, with ω₁ ≠ ω.", equation(Z(t), Z0));
  needs.outcome.verdict = Verdict::proved();
  needs.outcome.hypotheses = {
      {omega - omega1, "omega - omega1 != 0", "\\omega - \\omega_1 \\neq 0", "5.where"}};
  Record open =
      record("17", "A2", Status::undecided, "The symmetry of the orbit in time.", equation(Z(t), Z0));
  open.claim.origin = Origin::new_result;
  open.outcome.verdict = Verdict::undecided("the search ran out of its budget, " + std::string(120, 'x'));
  return {{model, proved, needs, digits(), misprint(), open}};
}

}  // namespace stickslip::report
