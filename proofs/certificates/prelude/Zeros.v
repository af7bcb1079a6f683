(* Krawczyk's test of equations that are read as expressions: slopes are found, and all enclosures computed, at
   once. *)
From Coq Require Import ZArith Lia List.
From Stickslip Require Export Krawczyk Numbers.
From Interval.Eval Require Import Tree Prog Reify.
Import Enclosures.
Open Scope R_scope.

(* ---- slopes of expressions *)

Definition evaluated (n : nat) (fs : list expr) (x : nat -> R) : list R :=
  map (fun f => eval f (map x (seq 0 n))) fs.

Fixpoint closed (e : expr) : bool :=
  match e with
  | Evar _ => false
  | Econst _ => true
  | Eunary _ a => closed a
  | Ebinary _ a b => (closed a && closed b)%bool
  end.
(* Made of n variables, and of what has slopes here. *)
Fixpoint smooth (n : nat) (e : expr) : bool :=
  match e with
  | Evar k => Nat.ltb k n
  | Econst _ => true
  | Eunary Neg a | Eunary Cos a | Eunary Sin a | Eunary (PowerInt (Zpos _)) a => smooth n a
  | Eunary _ a => closed a
  | Ebinary Add a b | Ebinary Sub a b | Ebinary Mul a b => (smooth n a && smooth n b)%bool
  | Ebinary Div a b => (smooth n a && closed b)%bool
  end.
Definition is_zero (e : expr) : bool := match e with Econst (Int 0) => true | _ => false end.
Definition is_one (e : expr) : bool := match e with Econst (Int 1) => true | _ => false end.
Definition sum (a b : expr) : expr := if is_zero a then b else if is_zero b then a else plus a b.
Definition product (a b : expr) : expr :=
  if is_zero a then a else if is_zero b then b else if is_one b then a else times a b.
Fixpoint slope_by (k : nat) (e : expr) : expr :=
  if closed e then number 0 else
  match e with
  | Evar j => if Nat.eqb j k then number 1 else number 0
  | Eunary Neg a => product (number (-1)) (slope_by k a)
  | Eunary Cos a => product (opposite (sine a)) (slope_by k a)
  | Eunary Sin a => product (cosine a) (slope_by k a)
  | Eunary (PowerInt (Zpos p)) a =>
      product (times (number (Zpos p)) (Eunary (PowerInt (Z.pred (Zpos p))) a)) (slope_by k a)
  | Ebinary Add a b => sum (slope_by k a) (slope_by k b)
  | Ebinary Sub a b => sum (slope_by k a) (product (number (-1)) (slope_by k b))
  | Ebinary Mul a b => sum (product b (slope_by k a)) (product a (slope_by k b))
  | Ebinary Div a b => product (inverse b) (slope_by k a)
  | _ => number 0
  end.

Lemma is_zero_ok e l : is_zero e = true -> eval e l = 0.
Proof. destruct e as [|[[| |]| |]| |]; try discriminate. reflexivity. Qed.
Lemma is_one_ok e l : is_one e = true -> eval e l = 1.
Proof. destruct e as [|[[|[| |]|]| |]| |]; try discriminate. reflexivity. Qed.
Lemma sum_ok a b l : eval (sum a b) l = eval a l + eval b l.
Proof.
  unfold sum. destruct (is_zero a) eqn:A; [rewrite (is_zero_ok a l A); ring|].
  destruct (is_zero b) eqn:B; [rewrite (is_zero_ok b l B); ring | reflexivity].
Qed.
Lemma product_ok a b l : eval (product a b) l = eval a l * eval b l.
Proof.
  unfold product. destruct (is_zero a) eqn:A; [rewrite (is_zero_ok a l A); ring|].
  destruct (is_zero b) eqn:B; [rewrite (is_zero_ok b l B); ring|].
  destruct (is_one b) eqn:C; [rewrite (is_one_ok b l C); ring | reflexivity].
Qed.
Lemma closed_ok e : closed e = true -> forall l m, eval e l = eval e m.
Proof.
  induction e as [| |o a A|o a A b B]; simpl; intros C l m; try discriminate; [reflexivity| |].
  - now rewrite (A C l m).
  - apply andb_prop in C as [C D]. now rewrite (A C l m), (B D l m).
Qed.

Section Slopes.
Context (n : nat) (z : nat -> R -> R) (d : nat -> R) (t : R) (D : forall j, derivative (z j) t (d j)).
Definition along_curve (e : expr) (u : R) : R := eval e (map (fun j => z j u) (seq 0 n)).
Definition total (e : expr) : R := rsum n (fun k => along_curve (slope_by k e) t * d k).

Lemma nth_along k u : (k < n)%nat -> nth k (map (fun j => z j u) (seq 0 n)) 0 = z k u.
Proof.
  intros K. rewrite (nth_indep _ 0 (z 0%nat u)) by (now rewrite map_length, seq_length).
  rewrite (map_nth (fun j => z j u)). now rewrite seq_nth.
Qed.
Lemma total_ext e (v : nat -> R) : (forall k, (k < n)%nat -> along_curve (slope_by k e) t = v k) ->
  total e = rsum n (fun k => v k * d k).
Proof. intros E. apply rsum_ext. intros k K. now rewrite (E k K). Qed.
Lemma total_zero e : (forall k, along_curve (slope_by k e) t = 0) -> total e = 0.
Proof.
  intros E. rewrite (total_ext e (fun _ => 0)) by auto.
  rewrite (rsum_ext n _ (fun _ => 0)) by (intros; ring). apply rsum_zero.
Qed.
Lemma total_scaled e a c : (forall k, along_curve (slope_by k e) t = c * along_curve (slope_by k a) t) ->
  total e = c * total a.
Proof.
  intros E. unfold total. rewrite <- rsum_scal. apply rsum_ext. intros k _. rewrite E. ring.
Qed.
Lemma total_both e a b c f :
  (forall k, along_curve (slope_by k e) t = c * along_curve (slope_by k a) t + f * along_curve (slope_by k b) t) ->
  total e = c * total a + f * total b.
Proof.
  intros E. unfold total. rewrite <- !rsum_scal, <- rsum_plus. apply rsum_ext. intros k _. rewrite E. ring.
Qed.
Lemma slope_of_closed e k : closed e = true -> along_curve (slope_by k e) t = 0.
Proof. unfold along_curve. intros C. destruct e; simpl in *; rewrite ?C; try reflexivity; discriminate. Qed.
Lemma closed_derivative e : closed e = true -> derivative (along_curve e) t (total e).
Proof.
  intros C. rewrite (total_zero e) by (intros; now apply slope_of_closed).
  apply (is_derive_ext (fun _ => along_curve e t)); [|apply (d_const (along_curve e t))].
  intros u. now apply closed_ok.
Qed.
Lemma total_derivative e : smooth n e = true -> derivative (along_curve e) t (total e).
Proof.
  induction e as [j|c|o a A|o a A b B]; intros S.
  - apply Nat.ltb_lt in S. unfold along_curve. simpl.
    rewrite (total_ext _ (fun k => one j k)).
    + rewrite rsum_one by exact S. apply (is_derive_ext (z j)); [|apply D].
      intros u. symmetry. now apply nth_along.
    + intros k K. unfold along_curve, one. simpl. rewrite Nat.eqb_sym. now destruct (Nat.eqb k j).
  - apply closed_derivative. reflexivity.
  - destruct (closed (Eunary o a)) eqn:C; [now apply closed_derivative|].
    assert (F : forall k, slope_by k (Eunary o a) = match o with
      | Neg => product (number (-1)) (slope_by k a)
      | Cos => product (opposite (sine a)) (slope_by k a)
      | Sin => product (cosine a) (slope_by k a)
      | PowerInt (Zpos p) =>
          product (times (number (Zpos p)) (Eunary (PowerInt (Z.pred (Zpos p))) a)) (slope_by k a)
      | _ => number 0 end) by (intros k; simpl in *; rewrite C; now destruct o).
    simpl in C. destruct o; simpl in S; try (rewrite S in C; discriminate).
    + rewrite (total_scaled _ a (-1)) by (intros k; unfold along_curve; rewrite F, product_ok; reflexivity).
      eapply (is_derive_ext (fun u => -1 * along_curve a u)); [intros u; unfold along_curve; simpl; ring|].
      eapply d_value; [apply (d_mult (fun _ => -1) (along_curve a)); [apply d_const | exact (A S)]|]. ring.
    + rewrite (total_scaled _ a (- sin (along_curve a t))) by (intros k; unfold along_curve; rewrite F, product_ok; reflexivity).
      eapply d_value; [apply (d_cos (along_curve a) t _ (A S))|]. ring.
    + rewrite (total_scaled _ a (cos (along_curve a t))) by (intros k; unfold along_curve; rewrite F, product_ok; reflexivity).
      exact (d_sin (along_curve a) t _ (A S)).
    + destruct n0 as [|p|p]; try (rewrite S in C; discriminate).
      rewrite (total_scaled _ a (INR (Pos.to_nat p) * along_curve a t ^ pred (Pos.to_nat p))).
      * eapply d_value; [apply (d_pow (along_curve a) (Pos.to_nat p) t _ (A S))|]. ring.
      * intros k. unfold along_curve at 1. rewrite F, product_ok. fold (along_curve (slope_by k a) t). f_equal.
        unfold times, number. cbn [eval unary_real binary_real nullary_real]. rewrite <- positive_nat_Z at 1. rewrite <- INR_IZR_INZ. f_equal.
        fold (along_curve a t).
        replace (Z.pred (Z.pos p)) with (Z.of_nat (pred (Pos.to_nat p))) by (pose proof (Pos2Nat.is_pos p); lia).
        symmetry. apply pow_powerRZ.
  - destruct (closed (Ebinary o a b)) eqn:C; [now apply closed_derivative|].
    assert (F : forall k, slope_by k (Ebinary o a b) = match o with
      | Add => sum (slope_by k a) (slope_by k b)
      | Sub => sum (slope_by k a) (product (number (-1)) (slope_by k b))
      | Mul => sum (product b (slope_by k a)) (product a (slope_by k b))
      | Div => product (inverse b) (slope_by k a) end) by (intros k; simpl in *; rewrite C; now destruct o).
    destruct o; simpl in S; apply andb_prop in S as [S T].
    + rewrite (total_both _ a b 1 1) by (intros k; unfold along_curve; rewrite F, sum_ok; ring).
      eapply d_value; [apply (d_plus (along_curve a) (along_curve b)); [exact (A S) | exact (B T)]|]. ring.
    + rewrite (total_both _ a b 1 (-1)) by (intros k; unfold along_curve; rewrite F, sum_ok, product_ok; simpl; ring).
      eapply (is_derive_ext (fun u => along_curve a u + -1 * along_curve b u)); [intros u; unfold along_curve; simpl; ring|].
      eapply d_value; [apply (d_plus (along_curve a) (fun u => -1 * along_curve b u)); [exact (A S)|]|].
      * apply (d_mult (fun _ => -1) (along_curve b)); [apply d_const | exact (B T)].
      * ring.
    + rewrite (total_both _ a b (along_curve b t) (along_curve a t))
        by (intros k; unfold along_curve; rewrite F, sum_ok, !product_ok; ring).
      eapply d_value; [apply (d_mult (along_curve a) (along_curve b)); [exact (A S) | exact (B T)]|]. ring.
    + rewrite (total_scaled _ a (/ along_curve b t)) by (intros k; unfold along_curve; rewrite F, product_ok; reflexivity).
      eapply (is_derive_ext (fun u => / along_curve b t * along_curve a u)).
      * intros u. unfold along_curve. simpl. unfold Rdiv. rewrite (closed_ok b T _ (map (fun j => z j u) (seq 0 n))). ring.
      * eapply d_value; [apply (d_mult (fun _ => / along_curve b t) (along_curve a)); [apply d_const | exact (A S)]|]. ring.
Qed.
End Slopes.

(* ---- the test *)

(* A number as it is written: a whole one, or over another. *)
Definition fraction (e : expr) : option (Z * positive) :=
  match e with
  | Econst (Int a) => Some (a, 1%positive)
  | Ebinary Mul (Econst (Int a)) (Eunary Inv (Econst (Int (Zpos b)))) => Some (a, b)
  | _ => None
  end.
Lemma fraction_ok e a b : fraction e = Some (a, b) -> eval e nil = IZR a / IZR (Zpos b).
Proof.
  destruct e as [|c|o e|o e1 e2]; try discriminate; simpl.
  - destruct c as [z| |]; try discriminate. intros E. injection E as <- <-. simpl. field.
  - destruct o; try discriminate. destruct e1 as [|c| |]; try discriminate. destruct c as [z| |]; try discriminate.
    destruct e2 as [| |o e|]; try discriminate. destruct o; try discriminate.
    destruct e as [|c| |]; try discriminate. destruct c as [y| |]; try discriminate.
    destruct y as [|p|p]; try discriminate. intros E. injection E as <- <-. reflexivity.
Qed.
(* The interval is 2 r wide. *)
Definition has_radius (r : expr) (b : expr * expr) : bool :=
  match fraction (fst b), fraction (snd b), fraction r with
  | Some (a, p), Some (c, q), Some (m, o) =>
      ((c * Zpos p - a * Zpos q) * Zpos o =? 2 * m * (Zpos p * Zpos q))%Z
  | _, _, _ => false
  end.
Lemma has_radius_ok r b : has_radius r b = true -> eval (snd b) nil = eval (fst b) nil + 2 * eval r nil.
Proof.
  unfold has_radius. destruct (fraction (fst b)) as [[a p]|] eqn:A; [|discriminate].
  destruct (fraction (snd b)) as [[c q]|] eqn:C; [|discriminate].
  destruct (fraction r) as [[m o]|] eqn:M; [|discriminate]. intros E. apply Z.eqb_eq in E.
  rewrite (fraction_ok _ _ _ A), (fraction_ok _ _ _ C), (fraction_ok _ _ _ M).
  apply (f_equal IZR) in E. rewrite !mult_IZR, minus_IZR, !mult_IZR in E.
  assert (P : forall x, IZR (Zpos x) <> 0) by (intros x; apply not_0_IZR; discriminate).
  apply (Rmult_eq_reg_r (IZR (Zpos p) * IZR (Zpos q) * IZR (Zpos o))).
  - transitivity (IZR c * IZR (Zpos p) * IZR (Zpos o)); [field; auto|].
    transitivity (IZR a * IZR (Zpos q) * IZR (Zpos o) + 2 * IZR m * (IZR (Zpos p) * IZR (Zpos q))); [lra | field; auto].
  - repeat apply Rmult_integral_contrapositive_currified; apply P.
Qed.
Definition is_positive (r : expr) : bool := match fraction r with Some (a, _) => (0 <? a)%Z | None => false end.
Lemma is_positive_ok r : is_positive r = true -> 0 < eval r nil.
Proof.
  unfold is_positive. destruct (fraction r) as [[a b]|] eqn:F; [|discriminate]. intros L. apply Z.ltb_lt in L.
  rewrite (fraction_ok _ _ _ F). apply Rmult_lt_0_compat; [now apply IZR_lt|].
  apply Rinv_0_lt_compat. now apply IZR_lt.
Qed.

(* Between these ends, one variable after another. *)
Fixpoint within (bs : list (expr * expr)) (k : nat) (x : nat -> R) : Prop :=
  match bs with
  | nil => True
  | b :: nil => eval (fst b) nil <= x k <= eval (snd b) nil
  | b :: others => eval (fst b) nil <= x k <= eval (snd b) nil /\ within others (S k) x
  end.
Definition no_side : expr * expr := (number 0, number 0).
Definition lies_in (b : expr * expr) (x : R) : Prop := eval (fst b) nil <= x <= eval (snd b) nil.
Lemma within_each : forall bs k x,
  within bs k x <-> forall i, (i < length bs)%nat -> lies_in (nth i bs no_side) (x (k + i)%nat).
Proof.
  induction bs as [|b [|c bs] H]; intros k x.
  - split; [intros _ i I; inversion I | easy].
  - split.
    + intros B [|i] I; [now rewrite Nat.add_0_r | simpl in I; lia].
    + intros A. specialize (A O ltac:(simpl; lia)). now rewrite Nat.add_0_r in A.
  - change (within (b :: c :: bs) k x) with (lies_in b (x k) /\ within (c :: bs) (S k) x). rewrite H. split.
    + intros [B A] [|i] I; [now rewrite Nat.add_0_r|]. rewrite <- Nat.add_succ_comm. apply A. simpl in *. lia.
    + intros A. split.
      * specialize (A O ltac:(simpl; lia)). now rewrite Nat.add_0_r in A.
      * intros i I. specialize (A (S i) ltac:(simpl in *; lia)). now rewrite <- Nat.add_succ_comm in A.
Qed.
Definition box_of (bs : list (expr * expr)) : list (list (bound expr)) :=
  map (fun b => Between (fst b) (snd b) :: nil) bs.
Lemma in_box_of : forall bs l (G : Prop), assuming (box_of bs) l G -> length l = length bs ->
  (forall i, (i < length bs)%nat -> lies_in (nth i bs no_side) (nth i l 0)) -> G.
Proof.
  unfold assuming. induction bs as [|b bs H]; intros [|x l] G A L B; try discriminate; [exact A|].
  injection L as L. apply (H l G); [|exact L|].
  - apply A. exact (B O ltac:(simpl; lia)).
  - intros i I. apply (B (S i)). simpl. lia.
Qed.

Definition middle_of (r : expr) (b : expr * expr) : expr * expr := (plus (fst b) r, plus (fst b) r).
Definition zero_test (n : nat) (fs : list expr) (bs : list (expr * expr)) (r : expr) (s : Z)
    (Y M : list (list Z)) (w e : Z) : bool :=
  (Nat.eqb (length bs) n && (0 <? s)%Z && is_positive r && forallb (has_radius r) bs && forallb (smooth n) fs &&
   below n (fun i => enclosed 80 O nil (box_of (map (middle_of r) bs)) (nth i fs (number 0))
     (Gabsle true (times r (over (number e) (number s))))) &&
   below n (fun i => below n (fun j => enclosed 40 O nil (box_of bs)
     (plus (slope_by j (nth i fs (number 0))) (times (number (-1)) (over (number (entry_of M i j)) (number s))))
     (Gabsle true (over (number w) (number s))))) &&
   passes n s Y M (repeat (repeat w n) n) (repeat e n))%bool.

Lemma nth_repeat_in : forall (A : Type) (d e : A) n i, (i < n)%nat -> nth i (repeat e n) d = e.
Proof. induction n; intros i I; [lia|]. destruct i; simpl; [reflexivity|]. apply IHn. lia. Qed.
Lemma evaluated_at n fs x i : nth i (evaluated n fs x) 0 = eval (nth i fs (number 0)) (map x (seq 0 n)).
Proof.
  unfold evaluated. change 0 with ((fun f => eval f (map x (seq 0 n))) (number 0)) at 1. now rewrite map_nth.
Qed.
Lemma nth_in_environment n (x : nat -> R) i : (i < n)%nat -> nth i (map x (seq 0 n)) 0 = x i.
Proof.
  intros I. rewrite (nth_indep _ 0 (x 0%nat)) by (now rewrite map_length, seq_length).
  rewrite map_nth. now rewrite seq_nth.
Qed.

Theorem zero_in_box n f fs bs r s Y M w e : (forall x, f x = evaluated n fs x) ->
  zero_test n fs bs r s Y M w e = true ->
  (exists x, within bs 0 x /\ forall i, (i < n)%nat -> nth i (f x) 0 = 0) /\
  (forall x y, within bs 0 x -> within bs 0 y -> (forall i, (i < n)%nat -> nth i (f x) 0 = 0) ->
   (forall i, (i < n)%nat -> nth i (f y) 0 = 0) -> forall i, (i < n)%nat -> x i = y i).
Proof.
  intros F T. unfold zero_test in T. repeat (apply andb_prop in T as [T ?H]).
  rename H into passed, H0 into near, H1 into start, H2 into smooth_all, H3 into radii, H4 into positive, H5 into scale.
  apply Nat.eqb_eq in T. apply Z.ltb_lt in scale. apply is_positive_ok in positive.
  rewrite forallb_forall in smooth_all, radii.
  set (c := fun i => eval (fst (nth i bs no_side)) nil + eval r nil).
  assert (R2 : forall i, (i < n)%nat -> eval (snd (nth i bs no_side)) nil = eval (fst (nth i bs no_side)) nil + 2 * eval r nil).
  { intros i I. apply has_radius_ok, radii, nth_In. now rewrite T. }
  assert (B : forall x, within bs 0 x <-> inbox n c (eval r nil) x).
  { intros x. rewrite within_each. unfold inbox, lies_in, c. rewrite T. split; intros A i I; specialize (A i I);
      rewrite (R2 i I) in *; simpl in *; lra. }
  assert (S : forall i, smooth n (nth i fs (number 0)) = true).
  { intros i. destruct (nth_in_or_default i fs (number 0)) as [J|J]; [now apply smooth_all | now rewrite J]. }
  destruct (one_zero n (fun x i => nth i (f x) 0)
              (fun x i j => eval (slope_by j (nth i fs (number 0))) (map x (seq 0 n))) c (eval r nil) s Y M
              (repeat (repeat w n) n) (repeat e n)) as [[x [X Z]] U]; try assumption.
  - intros i I y d t.
    eapply (is_derive_ext (fun u => eval (nth i fs (number 0)) (map (fun j => y j + u * d j) (seq 0 n)))).
    { intros u. now rewrite F, evaluated_at. }
    apply (total_derivative n (fun j u => y j + u * d j) d t); [|apply S].
    intros j. eapply d_value; [derive | ring].
  - intros x X i j I J. unfold entry_of at 2. rewrite (nth_repeat_in _ nil) by exact I. rewrite nth_repeat_in by exact J.
    apply B in X. rewrite within_each in X. rewrite T in X.
    pose proof (below_all n _ (below_all n _ near i I) j J) as E. cbv beta in E.
    apply (enclosed_ok _ _ _ _ (map x (seq 0 n))) in E. apply in_box_of in E; [exact E | now rewrite map_length, seq_length |].
    rewrite T. intros k K. rewrite nth_in_environment by exact K. exact (X k K).
  - intros i I. rewrite nth_repeat_in by exact I. rewrite F, evaluated_at.
    pose proof (below_all n _ start i I) as E. cbv beta in E.
    apply (enclosed_ok _ _ _ _ (map c (seq 0 n))) in E.
    apply in_box_of in E; [exact E | now rewrite !map_length, seq_length |].
    rewrite map_length, T. intros k K. rewrite nth_in_environment by exact K.
    rewrite (nth_indep _ no_side (middle_of r no_side)) by (now rewrite map_length, T). rewrite map_nth.
    unfold lies_in, c, middle_of. simpl. lra.
  - split.
    + exists x. split; [now apply B | exact Z].
    + intros u v V W. apply U; now apply B.
Qed.

Lemma environment_of_column : forall n (x : nat -> R), exists A : Mat n 1, forall i, (i < n)%nat -> ent i 0 A = x i.
Proof.
  intros n x. exists (column n (map x (seq 0 n))). intros i I.
  rewrite <- (nth_in_environment n x i I). generalize (map x (seq 0 n)). clear x. revert i I.
  induction n as [|n H]; intros i I l; [lia|]. destruct i as [|i]; unfold ent; simpl.
  - now destruct l.
  - change (ent i 0 (column n (tl l)) = nth (S i) l 0). rewrite H by lia. destruct l; [now destruct i | reflexivity].
Qed.

(* The same of columns. *)
Theorem zero_of_columns n f fs bs r s Y M w e : (forall x, f x = evaluated n fs x) ->
  zero_test n fs bs r s Y M w e = true ->
  (exists A : Mat n 1, within bs 0 (fun i => ent i 0 A) /\ column n (f (fun i => ent i 0 A)) = mzero n 1) /\
  (forall A B : Mat n 1,
    (within bs 0 (fun i => ent i 0 A) /\ column n (f (fun i => ent i 0 A)) = mzero n 1) /\
    (within bs 0 (fun i => ent i 0 B) /\ column n (f (fun i => ent i 0 B)) = mzero n 1) -> A = B).
Proof.
  intros F T. pose proof T as L. unfold zero_test in L. repeat (apply andb_prop in L as [L _]). apply Nat.eqb_eq in L.
  destruct (zero_in_box n f fs bs r s Y M w e F T) as [[x [X Z]] U]. split.
  - destruct (environment_of_column n x) as [A E]. exists A. split.
    + rewrite within_each in *. rewrite L in *. intros i I. simpl. rewrite (E i I). exact (X i I).
    + apply column_zero. replace (f (fun i => ent i 0 A)) with (f x); [exact Z|]. rewrite !F. unfold evaluated.
      replace (map (fun i => ent i 0 A) (seq 0 n)) with (map x (seq 0 n)); [reflexivity|].
      apply map_ext_in. intros k K. apply in_seq in K. symmetry. apply E. lia.
  - intros A B [[XA ZA] [XB ZB]]. apply mequal_entries. intros i j I J.
    replace j with 0%nat by lia. apply (U (fun i => ent i 0 A) (fun i => ent i 0 B)); auto; now apply zero_column.
Qed.

Strategy expand [evaluated within column].

(* A function of n numbers to a list of numbers as expressions; pairs of numbers. *)
Ltac functions_read t := read_exactly t.
Ltac numbers_read t := read_exactly constr:(t).
