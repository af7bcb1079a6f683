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
(* What is to be put for a letter's square. *)
Definition Rules := list (positive * (Z * Mon * Polynomial)).
Definition rules_of (cs : list (positive * positive)) : Rules :=
  combine (map fst cs)
    (mk_monpol_list 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool Z.quotrem (map (fun '(c, s) => rule c s) cs)).
Definition obeyed (rules : Rules) (l : list R) : Prop := MPcond 0 1 Rplus Rmult (@eq R) IZR (map snd rules) l.

Lemma whole_division : div_theory (@eq R) Z.add Z.mul IZR Z.quotrem.
Proof. constructor. intros a b. pose proof (Z.quotrem_eq a b). destruct (Z.quotrem a b). rewrite H. f_equal. lia. Qed.
Lemma obeyed_part : forall l (ks : list positive) rules, MPcond 0 1 Rplus Rmult (@eq R) IZR rules l ->
  obeyed (combine ks rules) l.
Proof.
  unfold obeyed. induction ks as [|k ks H]; intros [|[M P] rules] O; try exact I. destruct O as [E O].
  split; [exact E | now apply H].
Qed.
Lemma rules_ok cs l : circles l cs -> obeyed (rules_of cs) l.
Proof.
  intros C. apply obeyed_part.
  apply (interp_PElist_ok reals_set reals_ext reals_ring whole_numbers R_power_theory whole_division l).
  induction cs as [|[c s] [|d cs] H]; [exact I| |].
  - destruct C as [C _]. simpl. exact C.
  - destruct C as [C D]. split; [simpl; exact C | exact (H D)].
Qed.
(* A square stands in a product only if its letter stands in both factors, where none stands in either. *)
Fixpoint letters (P : Polynomial) : N :=
  match P with
  | Pc _ => 0
  | Pinj j P => N.shiftl (letters P) (Npos j)
  | PX P _ Q => N.lor (letters P) (N.succ_double (letters Q))
  end.
Definition rules_for (P Q : Polynomial) (rules : Rules) : Rules :=
  match N.land (letters P) (letters Q) with
  | N0 => nil
  | both => filter (fun r => N.testbit both (Pos.pred_N (fst r))) rules
  end.
Lemma obeyed_for P Q rules l : obeyed rules l -> obeyed (rules_for P Q rules) l.
Proof.
  unfold rules_for. destruct (N.land (letters P) (letters Q)) as [|both]; [intros _; exact I|].
  unfold obeyed. induction rules as [|[k [M R]] rules H]; [trivial|]. intros [E O]. cbn [filter fst].
  destruct (N.testbit (Npos both) (Pos.pred_N k)); [split; [exact E | now apply H] | now apply H].
Qed.
Definition reduced (rules : Rules) (P : Polynomial) : Polynomial :=
  match rules with
  | nil => P
  | _ => PNSubstL 0%Z 1%Z Z.add Z.mul Zeq_bool Z.quotrem P (map snd rules) 50 50
  end.
Lemma reduced_ok rules P l : obeyed rules l -> at_ l (reduced rules P) = at_ l P.
Proof.
  intros O. symmetry. unfold reduced. destruct rules; [reflexivity|].
  exact (PNSubstL_ok reals_set reals_ext reals_ring whole_numbers whole_division 50 50 _ P l O).
Qed.
