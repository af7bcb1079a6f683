(* Signs of expressions between given bounds, in interval arithmetic on whole numbers: no axiom but those of
   the real numbers. *)
From Stickslip Require Export Algebra.
From Interval.Float Require Import Basic Specific_ops Specific_stdz.
From Interval Require Import Tactic.

Module BinaryIntegers := SpecificFloat StdZRadix2.
Module Enclosure := IntervalTactic BinaryIntegers.
Import Enclosure.

Ltac by_enclosure :=
  first
    [ lra
    | interval with (i_prec 30)
    | match goal with  (* neither side is a number *)
      | |- ?a < ?b => cut (a + -1 * b < 0); [lra | interval with (i_prec 60)]
      | |- ?a <= ?b => cut (a + -1 * b <= 0); [lra | interval with (i_prec 60)]
      end
    | interval with (i_prec 60)
    | interval with (i_prec 128) ].
(* The same where a variable has a wide range: in parts of it. *)
Ltac by_enclosure_along x :=
  first
    [ interval with (i_prec 40)
    | match goal with
      | |- ?a < ?b => cut (a + -1 * b < 0); [lra | interval with (i_bisect x, i_depth 12, i_prec 40)]
      | |- ?a <= ?b => cut (a + -1 * b <= 0); [lra | interval with (i_bisect x, i_depth 12, i_prec 40)]
      end ].
(* In Krawczyk's test: where a derivative is, and how small a value is. *)
Ltac by_coarse_enclosure := interval with (i_prec 40).
Ltac by_fine_enclosure := interval with (i_prec 80).
