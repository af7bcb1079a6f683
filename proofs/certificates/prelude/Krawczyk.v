(* Exactly one zero of n equations in n unknowns in a box, by Krawczyk's test: x - Y f(x) maps the box into
   itself and halves distances, and Y has an inverse. What is computed is computed with whole numbers over a
   common denominator s. *)
From Stickslip Require Export Calculus.
From Coq Require Import ZArith Lia FunctionalExtensionality.
Open Scope R_scope.

(* ---- sums *)

Fixpoint rsum (n : nat) (a : nat -> R) : R :=
  match n with O => 0 | S m => rsum m a + a m end.

Lemma rsum_ext : forall n a b, (forall k, (k < n)%nat -> a k = b k) -> rsum n a = rsum n b.
Proof. induction n; intros a b E; simpl; [reflexivity|]. rewrite (IHn a b), (E n); auto. Qed.
Lemma rsum_plus : forall n a b, rsum n (fun k => a k + b k) = rsum n a + rsum n b.
Proof. induction n; intros; simpl; [ring|]. rewrite IHn. ring. Qed.
Lemma rsum_scal : forall n c a, rsum n (fun k => c * a k) = c * rsum n a.
Proof. induction n; intros; simpl; [ring|]. rewrite IHn. ring. Qed.
Lemma rsum_zero : forall n, rsum n (fun _ => 0) = 0.
Proof. induction n; simpl; [reflexivity|]. rewrite IHn. ring. Qed.
Lemma rsum_swap : forall n m a, rsum n (fun i => rsum m (fun j => a i j)) = rsum m (fun j => rsum n (fun i => a i j)).
Proof.
  induction n; intros; simpl; [now rewrite rsum_zero|]. rewrite IHn. symmetry. apply rsum_plus.
Qed.
Lemma rsum_le : forall n a b, (forall k, (k < n)%nat -> a k <= b k) -> rsum n a <= rsum n b.
Proof.
  induction n; intros a b L; simpl; [lra|]. apply Rplus_le_compat; [apply IHn; auto | apply L; auto].
Qed.
Lemma rsum_abs : forall n a, Rabs (rsum n a) <= rsum n (fun k => Rabs (a k)).
Proof.
  induction n; intros; simpl; [rewrite Rabs_R0; lra|].
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_r. apply IHn.
Qed.
Definition one (i j : nat) : R := if Nat.eqb i j then 1 else 0.
Lemma rsum_one : forall n i a, (i < n)%nat -> rsum n (fun j => one i j * a j) = a i.
Proof.
  induction n; intros i a L; [lia|]. simpl. unfold one at 2. destruct (Nat.eqb_spec i n) as [->|N].
  - rewrite (rsum_ext n _ (fun _ => 0)); [rewrite rsum_zero; ring|]. intros k K. unfold one.
    destruct (Nat.eqb_spec n k); [lia | ring].
  - rewrite IHn by lia. ring.
Qed.

(* ---- the largest of |v 0|, …, |v (n - 1)| *)

Fixpoint largest (n : nat) (v : nat -> R) : R :=
  match n with O => 0 | S m => Rmax (largest m v) (Rabs (v m)) end.
Lemma largest_bounds : forall n v k, (k < n)%nat -> Rabs (v k) <= largest n v.
Proof.
  induction n; intros v k L; [lia|]. simpl. destruct (Nat.eq_dec k n) as [->|N]; [apply Rmax_r|].
  eapply Rle_trans; [apply (IHn v k); lia | apply Rmax_l].
Qed.
Lemma largest_least : forall n v b, 0 <= b -> (forall k, (k < n)%nat -> Rabs (v k) <= b) -> largest n v <= b.
Proof. induction n; intros v b P L; simpl; [exact P|]. apply Rmax_lub; [apply IHn; auto | apply L; auto]. Qed.
Lemma largest_pos : forall n v, 0 <= largest n v.
Proof. induction n; intros; simpl; [lra|]. eapply Rle_trans; [apply IHn | apply Rmax_l]. Qed.
(* What is at most half of itself is nothing. *)
Lemma nothing : forall n v, (forall k, (k < n)%nat -> Rabs (v k) <= / 2 * largest n v) ->
  forall k, (k < n)%nat -> v k = 0.
Proof.
  intros n v L k K. pose proof (largest_pos n v).
  assert (largest n v <= / 2 * largest n v) by (apply largest_least; [lra | exact L]).
  pose proof (largest_bounds n v k K). pose proof (Rabs_pos (v k)).
  assert (Rabs (v k) = 0) as E by lra. destruct (Req_dec (v k) 0) as [Z|N]; [exact Z|].
  apply Rabs_no_R0 in N. lra.
Qed.

(* ---- the test, in real numbers *)

Definition inbox (n : nat) (c : nat -> R) (r : R) (x : nat -> R) : Prop :=
  forall i, (i < n)%nat -> c i + -1 * r <= x i <= c i + r.

(* All that the test needs. *)
Class Test (n : nat) (f : (nat -> R) -> nat -> R) (J : (nat -> R) -> nat -> nat -> R) (c : nat -> R) (r : R)
  (Y M W : nat -> nat -> R) (E : nat -> R) : Prop := {
  r_pos : 0 < r;
  slope : forall i, (i < n)%nat -> forall (y d : nat -> R) (t : R),
    derivative (fun s : R => f (fun j => y j + s * d j) i) t (rsum n (fun j => J (fun j => y j + t * d j) i j * d j));
  near_M : forall x, inbox n c r x -> forall i j, (i < n)%nat -> (j < n)%nat ->
    Rabs (J x i j + -1 * M i j) <= W i j;
  near_0 : forall i, (i < n)%nat -> Rabs (f c i) <= r * E i;
  rows : forall i, (i < n)%nat ->
    rsum n (fun k => Rabs (Y i k) * E k) <= / 2 /\
    rsum n (fun j => Rabs (one i j + -1 * rsum n (fun k => Y i k * M k j)) + rsum n (fun k => Rabs (Y i k) * W k j)) <= / 2;
  regular : forall i, (i < n)%nat ->
    rsum n (fun j => Rabs (one i j + -1 * rsum n (fun k => M i k * Y k j))) <= / 2 }.

Lemma inbox_between {n f J c r Y M W E} {test : Test n f J c r Y M W E} : forall x y t, inbox n c r x -> inbox n c r y -> 0 <= t <= 1 -> inbox n c r (fun j => y j + t * (x j + -1 * y j)).
Proof.
  pose proof r_pos as r_is_pos.
  intros x y t X Y' T i I. specialize (X i I). specialize (Y' i I). split; nra.
Qed.

Lemma difference {n f J c r Y M W E} {test : Test n f J c r Y M W E} : forall x y i, inbox n c r x -> inbox n c r y -> (i < n)%nat ->
  exists z, inbox n c r z /\ f x i + -1 * f y i = rsum n (fun j => J z i j * (x j + -1 * y j)).
Proof.
  pose proof r_pos as r_is_pos.
  intros x y i X Y' I.
  pose (d := fun j => x j + -1 * y j).
  destruct (mean_value (fun s => f (fun j => y j + s * d j) i)
              (fun t => rsum n (fun j => J (fun j => y j + t * d j) i j * d j)) 0 1) as [t [T D]]; [lra | | |].
  - intros t T eps P.
    assert (C : continuity_pt (fun s => f (fun j => y j + s * d j) i) t).
    { apply derivable_continuous_pt. eexists. apply is_derive_Reals. apply (slope i I y d t). }
    destruct (C eps P) as [delta [Q N]]. exists delta. split; [exact Q|]. intros s S L.
    destruct (Req_dec t s) as [->|O]; [rewrite Rplus_comm; replace (-1 * f (fun j => y j + s * d j) i + f (fun j => y j + s * d j) i) with 0 by ring; now rewrite Rabs_R0|].
    specialize (N s). unfold dist in N; simpl in N; unfold R_dist in N.
    replace (f (fun j => y j + s * d j) i + -1 * f (fun j => y j + t * d j) i)
      with (Rminus (f (fun j => y j + s * d j) i) (f (fun j => y j + t * d j) i)) by ring.
    apply N. split; [split; [exact Logic.I | exact O]|]. replace (Rminus s t) with (s + -1 * t) by ring. exact L.
  - intros t T. apply (slope i I y d t).
  - exists (fun j => y j + t * d j). split; [apply inbox_between; [exact X | exact Y' | lra]|].
    assert (one_end : f x i = f (fun j => y j + 1 * d j) i).
    { f_equal. apply functional_extensionality. intros j. unfold d. cbv beta. ring. }
    assert (other : f y i = f (fun j => y j + 0 * d j) i).
    { f_equal. apply functional_extensionality. intros j. unfold d. cbv beta. ring. }
    rewrite one_end, other, D. unfold d. ring.
Qed.

Definition T (n : nat) (f : (nat -> R) -> nat -> R) (Y : nat -> nat -> R) (x : nat -> R) (i : nat) : R :=
  x i + -1 * rsum n (fun k => Y i k * f x k).

(* T halves distances in the box. *)
Lemma halves {n f J c r Y M W E} {test : Test n f J c r Y M W E} : forall x y b, inbox n c r x -> inbox n c r y -> (forall j, (j < n)%nat -> Rabs (x j + -1 * y j) <= b) ->
  forall i, (i < n)%nat -> Rabs (T n f Y x i + -1 * T n f Y y i) <= / 2 * b.
Proof.
  pose proof r_pos as r_is_pos.
  intros x y b X Y' B i I.
  assert (0 <= b) as P by (eapply Rle_trans; [apply Rabs_pos | apply (B i I)]).
  assert (exists z : nat -> nat -> R, forall k, (k < n)%nat -> inbox n c r (z k) /\
            f x k + -1 * f y k = rsum n (fun j => J (z k) k j * (x j + -1 * y j))) as [z Z].
  { assert (forall m, (m <= n)%nat -> exists z : nat -> nat -> R, forall k, (k < m)%nat -> inbox n c r (z k) /\
              f x k + -1 * f y k = rsum n (fun j => J (z k) k j * (x j + -1 * y j))) as A.
    { induction m; intros L; [exists (fun _ => x); intros k K; lia|].
      destruct IHm as [z Z]; [lia|]. destruct (difference x y m X Y') as [w W']; [lia|].
      exists (fun k => if Nat.eqb k m then w else z k). intros k K.
      destruct (Nat.eqb_spec k m) as [->|N]; [exact W' | apply Z; lia]. }
    apply (A n). lia. }
  assert (Eq : T n f Y x i + -1 * T n f Y y i =
          rsum n (fun j => (one i j + -1 * rsum n (fun k => Y i k * J (z k) k j)) * (x j + -1 * y j))).
  { unfold T.
    replace (x i + -1 * rsum n (fun k => Y i k * f x k) + -1 * (y i + -1 * rsum n (fun k => Y i k * f y k)))
      with ((x i + -1 * y i) + -1 * rsum n (fun k => Y i k * (f x k + -1 * f y k))).
    2:{ rewrite (rsum_ext n (fun k => Y i k * (f x k + -1 * f y k)) (fun k => Y i k * f x k + -1 * (Y i k * f y k)))
          by (intros; ring). rewrite rsum_plus, rsum_scal. ring. }
    rewrite (rsum_ext n (fun k => Y i k * (f x k + -1 * f y k))
               (fun k => rsum n (fun j => Y i k * J (z k) k j * (x j + -1 * y j)))).
    2:{ intros k K. destruct (Z k K) as [_ D]. rewrite D, <- rsum_scal. apply rsum_ext. intros; ring. }
    rewrite rsum_swap.
    rewrite <- (rsum_one n i (fun j => x j + -1 * y j) I) at 1.
    rewrite <- rsum_scal, <- rsum_plus. apply rsum_ext. intros j _.
    rewrite (rsum_ext n (fun k => Y i k * J (z k) k j * (x j + -1 * y j)) (fun k => (x j + -1 * y j) * (Y i k * J (z k) k j)))
      by (intros; ring). rewrite rsum_scal. ring. }
  rewrite Eq. eapply Rle_trans; [apply rsum_abs|].
  destruct (rows i I) as [_ R2].
  apply Rle_trans with (rsum n (fun j => b * (Rabs (one i j + -1 * rsum n (fun k => Y i k * M k j)) + rsum n (fun k => Rabs (Y i k) * W k j)))).
  - apply rsum_le. intros j L. rewrite Rabs_mult, Rmult_comm.
    apply Rmult_le_compat; [apply Rabs_pos | apply Rabs_pos | apply B, L|].
    replace (one i j + -1 * rsum n (fun k => Y i k * J (z k) k j))
      with ((one i j + -1 * rsum n (fun k => Y i k * M k j)) + -1 * rsum n (fun k => Y i k * (J (z k) k j + -1 * M k j))).
    2:{ rewrite (rsum_ext n (fun k => Y i k * (J (z k) k j + -1 * M k j)) (fun k => Y i k * J (z k) k j + -1 * (Y i k * M k j)))
          by (intros; ring). rewrite rsum_plus, rsum_scal. ring. }
    eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l.
    rewrite Rabs_mult. replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra). rewrite Rmult_1_l.
    eapply Rle_trans; [apply rsum_abs|]. apply rsum_le. intros k K. rewrite Rabs_mult.
    apply Rmult_le_compat_l; [apply Rabs_pos|]. apply near_M; [apply (Z k K) | exact K | exact L].
  - rewrite rsum_scal. rewrite Rmult_comm. apply Rmult_le_compat_r; assumption.
Qed.

Lemma inbox_c {n f J c r Y M W E} {test : Test n f J c r Y M W E} : inbox n c r c.
Proof. pose proof r_pos. intros i I. lra. Qed.
Lemma start {n f J c r Y M W E} {test : Test n f J c r Y M W E} : forall i, (i < n)%nat -> Rabs (T n f Y c i + -1 * c i) <= / 2 * r.
Proof.
  pose proof r_pos as r_is_pos.
  intros i I. unfold T.
  replace (c i + -1 * rsum n (fun k => Y i k * f c k) + -1 * c i) with (-1 * rsum n (fun k => Y i k * f c k)) by ring.
  rewrite Rabs_mult. replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra). rewrite Rmult_1_l.
  eapply Rle_trans; [apply rsum_abs|]. destruct (rows i I) as [R1 _].
  apply Rle_trans with (rsum n (fun k => r * (Rabs (Y i k) * E k))).
  - apply rsum_le. intros k K. rewrite Rabs_mult.
    replace (r * (Rabs (Y i k) * E k)) with (Rabs (Y i k) * (r * E k)) by ring.
    apply Rmult_le_compat_l; [apply Rabs_pos | apply near_0, K].
  - rewrite rsum_scal. rewrite Rmult_comm. apply Rmult_le_compat_r; [lra | exact R1].
Qed.
Lemma inbox_T {n f J c r Y M W E} {test : Test n f J c r Y M W E} : forall x, inbox n c r x -> inbox n c r (T n f Y x).
Proof.
  pose proof r_pos as r_is_pos.
  intros x X i I.
  assert (Rabs (T n f Y x i + -1 * T n f Y c i) <= / 2 * r) as H.
  { apply halves; [exact X | exact inbox_c | | exact I]. intros j L. specialize (X j L). apply Rabs_le. lra. }
  pose proof (start i I) as H'. apply Rabs_le_between in H, H'. lra.
Qed.

Fixpoint steps (n : nat) (f : (nat -> R) -> nat -> R) (Y : nat -> nat -> R) (c : nat -> R) (k : nat) : nat -> R :=
  match k with O => c | S m => T n f Y (steps n f Y c m) end.
Lemma steps_inbox {n f J c r Y M W E} {test : Test n f J c r Y M W E} : forall k, inbox n c r (steps n f Y c k).
Proof. induction k; simpl; [exact inbox_c | now apply inbox_T]. Qed.
Lemma steps_near {n f J c r Y M W E} {test : Test n f J c r Y M W E} : forall k i, (i < n)%nat -> Rabs (steps n f Y c (S k) i + -1 * steps n f Y c k i) <= r * (/ 2) ^ k.
Proof.
  pose proof r_pos as r_is_pos.
  induction k; intros i I.
  - eapply Rle_trans; [apply (start i I)|]. simpl. lra.
  - replace (r * (/ 2) ^ S k) with (/ 2 * (r * (/ 2) ^ k)) by (simpl; ring).
    apply (halves (steps n f Y c (S k)) (steps n f Y c k)); auto using steps_inbox.
Qed.
Lemma limit_of {n f J c r Y M W E} {test : Test n f J c r Y M W E} : forall i, exists l : R, (i < n)%nat -> is_lim_seq (fun k => steps n f Y c k i) l.
Proof.
  pose proof r_pos as r_is_pos.
  intros i. destruct (Compare_dec.lt_dec i n) as [I|N]; [|exists 0; intros; lia].
  assert (ex_series (fun k => steps n f Y c (S k) i + -1 * steps n f Y c k i)) as [l L].
  { apply (ex_series_le (K := R_AbsRing) (V := R_CompleteNormedModule) _ (fun k => r * (/ 2) ^ k)).
    - intros k. apply (steps_near k i I).
    - apply (ex_series_scal (K := R_AbsRing) (V := R_NormedModule)). apply ex_series_geom.
      rewrite Rabs_right; lra. }
  exists (c i + l). intros _. apply is_lim_seq_incr_1.
  apply (is_lim_seq_ext (fun k => c i + sum_n (fun k => steps n f Y c (S k) i + -1 * steps n f Y c k i) k)).
  - induction n0.
    + rewrite sum_O. simpl. ring.
    + rewrite sum_Sn. unfold plus; simpl plus. simpl in *. lra.
  - apply (is_lim_seq_plus _ _ (c i) l); [apply is_lim_seq_const | exact L | reflexivity].
Qed.
Lemma limits {n f J c r Y M W E} {test : Test n f J c r Y M W E} : exists x : nat -> R, forall i, (i < n)%nat -> is_lim_seq (fun k => steps n f Y c k i) (x i).
Proof.
  pose proof r_pos as r_is_pos.
  assert (forall m, (m <= n)%nat -> exists x : nat -> R, forall i, (i < m)%nat -> is_lim_seq (fun k => steps n f Y c k i) (x i)) as A.
  { induction m; intros L; [exists c; intros; lia|]. destruct IHm as [x X]; [lia|].
    destruct (limit_of m) as [l C]. exists (fun i => if Nat.eqb i m then l else x i). intros i I.
    destruct (Nat.eqb_spec i m) as [->|N]; [apply C; lia | apply X; lia]. }
  apply (A n). lia.
Qed.
Lemma close {n f J c r Y M W E} {test : Test n f J c r Y M W E} : forall (x : nat -> R), (forall i, (i < n)%nat -> is_lim_seq (fun k => steps n f Y c k i) (x i)) ->
  forall eps, 0 < eps -> exists N, forall k, (N <= k)%nat -> forall i, (i < n)%nat -> Rabs (steps n f Y c k i + -1 * x i) <= eps.
Proof.
  pose proof r_pos as r_is_pos.
  intros x X eps P.
  assert (forall m, (m <= n)%nat -> exists N, forall k, (N <= k)%nat -> forall i, (i < m)%nat -> Rabs (steps n f Y c k i + -1 * x i) <= eps) as A.
  { induction m; intros L; [exists 0%nat; intros; lia|]. destruct IHm as [N H]; [lia|].
    assert (m < n)%nat as I by lia.
    pose proof (proj2 (is_lim_seq_Reals (fun k => steps n f Y c k m) (x m)) ) as _.
    pose proof (proj1 (is_lim_seq_Reals (fun k => steps n f Y c k m) (x m)) (X m I)) as C.
    destruct (C eps P) as [N' H'].
    exists (max N N'). intros k K i J'. destruct (Nat.eq_dec i m) as [->|O]; [|apply H; lia].
    assert (k >= N')%nat as K' by lia. specialize (H' k K'). unfold R_dist in H'.
    replace (steps n f Y c k m + -1 * x m) with (Rminus (steps n f Y c k m) (x m)) by ring. lra. }
  apply (A n). lia.
Qed.

Lemma zero_of_fixed {n f J c r Y M W E} {test : Test n f J c r Y M W E} : forall x, (forall i, (i < n)%nat -> T n f Y x i = x i) -> forall i, (i < n)%nat -> f x i = 0.
Proof.
  pose proof r_pos as r_is_pos.
  intros x F. apply nothing. intros i I. set (v := f x).
  assert (forall k, (k < n)%nat -> rsum n (fun j => Y k j * v j) = 0) as Z.
  { intros k K. specialize (F k K). unfold T in F. fold v in F. lra. }
  replace (v i) with (rsum n (fun j => (one i j + -1 * rsum n (fun k => M i k * Y k j)) * v j)).
  2:{ rewrite (rsum_ext n _ (fun j => one i j * v j + -1 * rsum n (fun k => M i k * (Y k j * v j)))).
      2:{ intros j _. rewrite (rsum_ext n (fun k => M i k * (Y k j * v j)) (fun k => v j * (M i k * Y k j))) by (intros; ring).
          rewrite rsum_scal. ring. }
      rewrite rsum_plus, rsum_one by exact I. rewrite rsum_scal, rsum_swap.
      rewrite (rsum_ext n (fun j => rsum n (fun i0 => M i j * (Y j i0 * v i0))) (fun _ => 0)); [rewrite rsum_zero; ring|].
      intros k K. rewrite rsum_scal, Z by exact K. ring. }
  eapply Rle_trans; [apply rsum_abs|].
  apply Rle_trans with (rsum n (fun j => largest n v * Rabs (one i j + -1 * rsum n (fun k => M i k * Y k j)))).
  - apply rsum_le. intros j L. rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat_r; [apply Rabs_pos | now apply largest_bounds].
  - rewrite rsum_scal, Rmult_comm. apply Rmult_le_compat_r; [apply largest_pos | apply regular, I].
Qed.

Theorem one_zero_real {n f J c r Y M W E} {test : Test n f J c r Y M W E} : (exists x, inbox n c r x /\ forall i, (i < n)%nat -> f x i = 0) /\
  (forall x y, inbox n c r x -> inbox n c r y -> (forall i, (i < n)%nat -> f x i = 0) -> (forall i, (i < n)%nat -> f y i = 0) ->
   forall i, (i < n)%nat -> x i = y i).
Proof.
  pose proof r_pos as r_is_pos.
  split.
  - destruct limits as [x X].
    assert (inbox n c r x) as B.
    { intros i I. split.
      - apply (is_lim_seq_le (fun _ => c i + -1 * r) (fun k => steps n f Y c k i) (c i + -1 * r) (x i));
          [intros k; apply (steps_inbox k i I) | apply is_lim_seq_const | apply X, I].
      - apply (is_lim_seq_le (fun k => steps n f Y c k i) (fun _ => c i + r) (x i) (c i + r));
          [intros k; apply (steps_inbox k i I) | apply X, I | apply is_lim_seq_const]. }
    exists x. split; [exact B|]. apply zero_of_fixed. intros i I.
    destruct (Req_dec (T n f Y x i) (x i)) as [E'|N]; [exact E'|]. exfalso.
    pose (eps := Rabs (T n f Y x i + -1 * x i) / 4).
    assert (0 < Rabs (T n f Y x i + -1 * x i)) by (apply Rabs_pos_lt; lra).
    assert (0 < eps) as P by (unfold eps; lra).
    destruct (close x X eps P) as [k K].
    pose proof (K k (le_n k)) as K0. pose proof (K (S k) (le_S k k (le_n k)) i I) as K1.
    assert (Rabs (T n f Y (steps n f Y c k) i + -1 * T n f Y x i) <= / 2 * eps) as H' by (apply halves; auto using steps_inbox).
    simpl steps in K1. apply Rabs_le_between in K1, H'.
    assert (Rabs (T n f Y x i + -1 * x i) <= 2 * eps) by (apply Rabs_le; lra). unfold eps in *. lra.
  - intros x y X Y' Zx Zy.
    assert (forall u, (forall i, (i < n)%nat -> f u i = 0) -> forall i, T n f Y u i = u i) as F.
    { intros u U i. unfold T. rewrite (rsum_ext n _ (fun _ => 0)) by (intros k K; rewrite U by exact K; ring).
      rewrite rsum_zero. ring. }
    pose (v := fun i => x i + -1 * y i).
    assert (forall i, (i < n)%nat -> v i = 0) as V.
    { apply nothing. intros i I. unfold v at 1. rewrite <- (F x Zx i), <- (F y Zy i).
      apply halves; auto. intros j L. apply (largest_bounds n v j L). }
    intros i I. specialize (V i I). unfold v in V. lra.
Qed.

(* ---- what is computed *)

Definition entry_of (A : list (list Z)) (i j : nat) : Z := nth j (nth i A nil) 0%Z.
Fixpoint zsum (n : nat) (a : nat -> Z) : Z := match n with O => 0%Z | S m => (zsum m a + a m)%Z end.
Definition below (n : nat) (test : nat -> bool) : bool := forallb test (seq 0 n).
(* Y f(c) is at most r/2, Y J(x) is near 1, and so is M Y. *)
Definition passes (n : nat) (s : Z) (Y M W : list (list Z)) (E : list Z) : bool :=
  let unit i j := if Nat.eqb i j then (s * s)%Z else 0%Z in
  below n (fun i =>
    ((2 * zsum n (fun k => Z.abs (entry_of Y i k) * nth k E 0) <=? s * s)%Z &&
    (2 * zsum n (fun j => Z.abs (unit i j - zsum n (fun k => entry_of Y i k * entry_of M k j)) +
                          zsum n (fun k => Z.abs (entry_of Y i k) * entry_of W k j)) <=? s * s)%Z &&
    (2 * zsum n (fun j => Z.abs (unit i j - zsum n (fun k => entry_of M i k * entry_of Y k j))) <=? s * s)%Z)%bool).

Lemma IZR_zsum : forall n a, IZR (zsum n a) = rsum n (fun k => IZR (a k)).
Proof. induction n; intros; simpl; [reflexivity|]. now rewrite plus_IZR, IHn. Qed.
Lemma below_all : forall n test, below n test = true -> forall i, (i < n)%nat -> test i = true.
Proof.
  intros n test H i I. unfold below in H. rewrite forallb_forall in H. apply H. apply in_seq. lia.
Qed.

Theorem one_zero : forall (n : nat) (f : (nat -> R) -> nat -> R) (J : (nat -> R) -> nat -> nat -> R)
  (c : nat -> R) (r : R) (s : Z) (Y M W : list (list Z)) (E : list Z),
  0 < r -> (0 < s)%Z ->
  (forall i, (i < n)%nat -> forall y d t,
    derivative (fun u : R => f (fun j => y j + u * d j) i) t (rsum n (fun j => J (fun j => y j + t * d j) i j * d j))) ->
  (forall x, inbox n c r x -> forall i j, (i < n)%nat -> (j < n)%nat ->
    Rabs (J x i j + -1 * (IZR (entry_of M i j) / IZR s)) <= IZR (entry_of W i j) / IZR s) ->
  (forall i, (i < n)%nat -> Rabs (f c i) <= r * (IZR (nth i E 0%Z) / IZR s)) ->
  passes n s Y M W E = true ->
  (exists x, inbox n c r x /\ forall i, (i < n)%nat -> f x i = 0) /\
  (forall x y, inbox n c r x -> inbox n c r y -> (forall i, (i < n)%nat -> f x i = 0) ->
   (forall i, (i < n)%nat -> f y i = 0) -> forall i, (i < n)%nat -> x i = y i).
Proof.
  intros n f J c r s Y M W E Pr Ps D NM N0 C.
  assert (0 < IZR s) as S0 by (now apply IZR_lt).
  assert (IZR s <> 0) as S1 by lra.
  pose (over := fun z : Z => IZR z / IZR s).
  assert (forall a b, over a * over b = IZR (a * b) * (/ IZR s * / IZR s)) as Mul.
  { intros a b. unfold over. rewrite mult_IZR. ring. }
  assert (forall a, Rabs (over a) = over (Z.abs a)) as Abs.
  { intros a. unfold over. rewrite Rabs_mult, abs_IZR, (Rabs_right (/ IZR s)); [reflexivity|].
    left. now apply Rinv_0_lt_compat. }
  assert (forall a, 2 * IZR a <= IZR s * IZR s -> IZR a * (/ IZR s * / IZR s) <= / 2) as Half.
  { intros a L. apply (Rmult_le_reg_r (IZR s * IZR s)); [nra|].
    replace (IZR a * (/ IZR s * / IZR s) * (IZR s * IZR s)) with (IZR a) by (field; exact S1). lra. }
  assert (forall a, (2 * a <=? s * s)%Z = true -> 2 * IZR a <= IZR s * IZR s) as Le.
  { intros a L. apply Z.leb_le in L. apply IZR_le in L. rewrite !mult_IZR in L. exact L. }
  assert (forall i j, one i j = IZR (if Nat.eqb i j then (s * s)%Z else 0%Z) * (/ IZR s * / IZR s)) as One.
  { intros i j. unfold one. destruct (Nat.eqb i j); [rewrite mult_IZR; field; exact S1 | ring]. }
  assert (forall a b : nat -> Z, rsum n (fun k => over (a k) * over (b k)) =
            IZR (zsum n (fun k => (a k * b k)%Z)) * (/ IZR s * / IZR s)) as Sum.
  { intros a b. rewrite IZR_zsum, Rmult_comm, <- rsum_scal. apply rsum_ext. intros k _. rewrite Mul. ring. }
  assert (forall (A B : nat -> nat -> Z) i j,
            Rabs (one i j + -1 * rsum n (fun k => over (A i k) * over (B k j))) =
            IZR (Z.abs ((if Nat.eqb i j then (s * s)%Z else 0%Z) - zsum n (fun k => (A i k * B k j)%Z))) *
            (/ IZR s * / IZR s)) as Off.
  { intros A B i j. rewrite (Sum (fun k => A i k) (fun k => B k j)), One, abs_IZR, minus_IZR.
    rewrite <- (Rabs_right (/ IZR s * / IZR s)) at 3.
    - rewrite <- Rabs_mult. f_equal. ring.
    - left. apply Rmult_lt_0_compat; now apply Rinv_0_lt_compat. }
  cut (Test n f J c r (fun i j => over (entry_of Y i j)) (fun i j => over (entry_of M i j))
           (fun i j => over (entry_of W i j)) (fun i => over (nth i E 0%Z))).
  { intros test. exact one_zero_real. }
  constructor; auto.
  - intros i I. pose proof (below_all n _ C i I) as P. cbv beta in P.
    apply andb_prop in P as [P _]. apply andb_prop in P as [P1 P2]. split.
    + rewrite (rsum_ext n _ (fun k => over (Z.abs (entry_of Y i k)) * over (nth k E 0%Z))) by (intros; now rewrite Abs).
      rewrite Sum. apply Half, Le, P1.
    + rewrite (rsum_ext n _ (fun j => (/ IZR s * / IZR s) * IZR
         (Z.abs ((if Nat.eqb i j then (s * s)%Z else 0%Z) - zsum n (fun k => (entry_of Y i k * entry_of M k j)%Z)) +
          zsum n (fun k => (Z.abs (entry_of Y i k) * entry_of W k j)%Z)))).
      * rewrite rsum_scal, <- IZR_zsum, Rmult_comm. apply Half, Le, P2.
      * intros j _. rewrite plus_IZR, Rmult_plus_distr_l, (Rmult_comm (/ IZR s * / IZR s)).
        rewrite (Off (entry_of Y) (entry_of M)). f_equal.
        rewrite (rsum_ext n _ (fun k => over (Z.abs (entry_of Y i k)) * over (entry_of W k j))) by (intros; now rewrite Abs).
        rewrite (Sum (fun k => Z.abs (entry_of Y i k)) (fun k => entry_of W k j)). ring.
  - intros i I. pose proof (below_all n _ C i I) as P. cbv beta in P. apply andb_prop in P as [_ P].
    rewrite (rsum_ext n _ (fun j => (/ IZR s * / IZR s) * IZR
         (Z.abs ((if Nat.eqb i j then (s * s)%Z else 0%Z) - zsum n (fun k => (entry_of M i k * entry_of Y k j)%Z))))).
    + rewrite rsum_scal, <- IZR_zsum, Rmult_comm. apply Half, Le, P.
    + intros j _. rewrite (Off (entry_of M) (entry_of Y)). ring.
Qed.

(* A list as a column. *)
Fixpoint column (n : nat) (l : list R) : Mat n 1 :=
  match n with O => tt | S m => ((hd 0 l, tt), column m (tl l)) end.
Lemma column_zero : forall n l, (forall i, (i < n)%nat -> nth i l 0 = 0) -> column n l = mzero n 1.
Proof.
  induction n; intros l Z; [reflexivity|]. change (((hd 0 l, tt), column n (tl l)) = ((0, tt), mzero n 1)).
  f_equal.
  - f_equal. generalize (Z O ltac:(lia)). destruct l; trivial.
  - apply IHn. intros i I. generalize (Z (S i) ltac:(lia)). destruct l; [destruct i|]; trivial.
Qed.
Lemma zero_column : forall n l, column n l = mzero n 1 -> forall i, (i < n)%nat -> nth i l 0 = 0.
Proof.
  induction n; intros l Z i I; [lia|].
  change (((hd 0 l, tt), column n (tl l)) = ((0, tt), mzero n 1)) in Z. injection Z as H T.
  destruct i as [|i]; [destruct l; trivial|].
  generalize (IHn (tl l) T i ltac:(lia)). destruct l; [destruct i|]; trivial.
Qed.
