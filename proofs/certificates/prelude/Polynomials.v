(* Polynomials with whole coefficients, those of Coq's tactic ring, and the squares of cosines in them. *)
From Stickslip Require Import Matrices.
From Coq Require Export ZArith Lia List Ring_polynom Ring_theory RealField BinList Bool.
Import ListNotations.

Definition Polynomial := Pol Z.
Definition pconst (z : Z) : Polynomial := Pc z.
Definition padd : Polynomial -> Polynomial -> Polynomial := Padd 0%Z Z.add Zeq_bool.
Definition pmul : Polynomial -> Polynomial -> Polynomial := Pmul 0%Z 1%Z Z.add Z.mul Zeq_bool.
Definition pscale : Polynomial -> Z -> Polynomial := PmulC 0%Z 1%Z Z.mul Zeq_bool.
Definition popp : Polynomial -> Polynomial := Popp Z.opp.
Definition peq : Polynomial -> Polynomial -> bool := Peq Zeq_bool.
Definition pletter (k : positive) : Polynomial := mk_X 0%Z 1%Z k.
Definition at_ (l : list R) (P : Polynomial) : R := Pphi 0 Rplus Rmult IZR l P.

Lemma reals_set : Setoid.Setoid_Theory R (@eq R).
Proof. exact (Eqsth R). Qed.
Lemma reals_ext : ring_eq_ext Rplus Rmult Ropp (@eq R).
Proof. exact (Eq_ext Rplus Rmult Ropp). Qed.
Lemma reals_ring : almost_ring_theory 0 1 Rplus Rmult Rminus Ropp (@eq R).
Proof. exact (Rth_ARth reals_set reals_ext RTheory). Qed.
Lemma whole_numbers : ring_morph 0 1 Rplus Rmult Rminus Ropp (@eq R) 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool IZR.
Proof.
  constructor; try reflexivity.
  - exact plus_IZR.
  - exact minus_IZR.
  - exact mult_IZR.
  - exact opp_IZR.
  - intros x y E. now rewrite (Zeq_bool_eq _ _ E).
Qed.

Lemma padd_ok P Q l : at_ l (padd P Q) = at_ l P + at_ l Q.
Proof. exact (Padd_ok reals_set reals_ext reals_ring whole_numbers Q P l). Qed.
Lemma pmul_ok P Q l : at_ l (pmul P Q) = at_ l P * at_ l Q.
Proof. exact (Pmul_ok reals_set reals_ext reals_ring whole_numbers P Q l). Qed.
Lemma pscale_ok P c l : at_ l (pscale P c) = at_ l P * IZR c.
Proof. exact (PmulC_ok reals_set reals_ext reals_ring whole_numbers c P l). Qed.
Lemma popp_ok P l : at_ l (popp P) = - at_ l P.
Proof. exact (Popp_ok reals_set reals_ext reals_ring whole_numbers P l). Qed.
Lemma peq_ok P Q : peq P Q = true -> forall l, at_ l P = at_ l Q.
Proof. exact (Peq_ok reals_set reals_ext whole_numbers P Q). Qed.
Lemma pletter_ok k l : at_ l (pletter k) = nth 0 k l.
Proof. symmetry. exact (mkX_ok reals_set reals_ext reals_ring whole_numbers k l). Qed.

(* ---- cos cos is 1 - sin sin *)

Fixpoint circles (l : list R) (cs : list (positive * positive)) : Prop :=
  match cs with
  | nil => True
  | (c, s) :: rest => nth 0 c l * nth 0 c l = 1 + -1 * (nth 0 s l * nth 0 s l) /\ circles l rest
  end.
Definition rule (c s : positive) : PExpr Z * PExpr Z :=
  (PEmul (PEX Z c) (PEX Z c), PEadd (PEc 1%Z) (PEmul (PEc (-1)%Z) (PEmul (PEX Z s) (PEX Z s)))).
Definition Rules := list (Z * Mon * Polynomial).
Definition rules_of (cs : list (positive * positive)) : Rules :=
  mk_monpol_list 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool Z.quotrem (map (fun '(c, s) => rule c s) cs).
Definition obeyed (rules : Rules) (l : list R) : Prop := MPcond 0 1 Rplus Rmult (@eq R) IZR rules l.

Lemma whole_division : div_theory (@eq R) Z.add Z.mul IZR Z.quotrem.
Proof. constructor. intros a b. pose proof (Z.quotrem_eq a b). destruct (Z.quotrem a b). rewrite H. f_equal. lia. Qed.
Lemma rules_ok cs l : circles l cs -> obeyed (rules_of cs) l.
Proof.
  intros C.
  apply (interp_PElist_ok reals_set reals_ext reals_ring whole_numbers R_power_theory whole_division l).
  induction cs as [|[c s] [|d cs] H]; [exact I| |].
  - destruct C as [C _]. simpl. exact C.
  - destruct C as [C D]. split; [simpl; exact C | exact (H D)].
Qed.
Definition reduced (rules : Rules) (P : Polynomial) : Polynomial :=
  PNSubstL 0%Z 1%Z Z.add Z.mul Zeq_bool Z.quotrem P rules 50 50.
Lemma reduced_ok rules P l : obeyed rules l -> at_ l (reduced rules P) = at_ l P.
Proof.
  intros O. symmetry.
  exact (PNSubstL_ok reals_set reals_ext reals_ring whole_numbers whole_division 50 50 rules P l O).
Qed.
