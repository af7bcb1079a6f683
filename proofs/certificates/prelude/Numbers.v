(* Signs of expressions between given bounds, in interval arithmetic on whole numbers: no axiom but those of
   the real numbers. *)
From Stickslip Require Export Algebra.
From Interval.Float Require Import Basic Specific_ops Specific_stdz.
From Interval Require Import Tactic.

Module BinaryIntegers := SpecificFloat StdZRadix2.
Module Enclosure := IntervalTactic BinaryIntegers.
Import Enclosure.

(* Neither side is a number. Not by lra: it would multiply everything out. *)
Lemma below_by_gap : forall a b : R, a + -1 * b < 0 -> a < b.
Proof. intros; lra. Qed.
Lemma at_most_by_gap : forall a b : R, a + -1 * b <= 0 -> a <= b.
Proof. intros; lra. Qed.
Ltac as_gap := first [apply below_by_gap | apply at_most_by_gap].
Ltac by_enclosure :=
  first
    [ as_gap; interval with (i_prec 60)
    | interval with (i_prec 60)
    | interval with (i_prec 128)
    | lra ].
(* The same where a variable has a wide range: in parts of it, of which a few do mostly. *)
Ltac by_enclosure_along x :=
  first
    [ interval with (i_bisect x, i_depth 4, i_prec 30)
    | interval with (i_prec 40)
    | as_gap; first [interval with (i_prec 40) | interval with (i_bisect x, i_depth 12, i_prec 40)]
    | interval with (i_bisect x, i_depth 12, i_prec 40) ].
(* In Krawczyk's test: where a derivative is, and how small a value is. *)
Ltac by_coarse_enclosure := first [interval with (i_prec 30) | interval with (i_prec 40)].
Ltac by_fine_enclosure := first [interval with (i_prec 64) | interval with (i_prec 80)].
