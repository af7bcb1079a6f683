(* Zeros of polynomials inside the unit circle, by the test of Schur, Cohn and Jury.

   Of p = c0 + c1 z + ... + cn z^n let p* be the polynomial with the coefficients turned round, and q of degree
   n - 1 be (cn p - c0 p* ) / z. Where |z| >= 1, q has no zero and |q* | <= |q|, the same is so of p if |c0| < |cn|:
   for (cn^2 - c0^2) p = cn z q + c0 q* and (cn^2 - c0^2) p* = cn q* + c0 z q. *)
From Stickslip Require Export Calculus.
Open Scope R_scope.

(* The square of the modulus. *)
Definition square (z : C) : R := fst z * fst z + snd z * snd z.
Lemma square_not_negative : forall z, 0 <= square z.
Proof. intros [x y]. unfold square; simpl. nra. Qed.
Lemma square_zero : forall z, square z = 0 -> z = RtoC 0.
Proof.
  intros [x y]. unfold square, RtoC; simpl. intros E. apply Rplus_sqr_eq_0 in E as [-> ->]. reflexivity.
Qed.
Lemma square_of_product : forall z w, square (Cmult z w) = square z * square w.
Proof. intros [x y] [u v]. unfold square, Cmult; simpl. ring. Qed.
Lemma square_of_modulus : forall z, Cmod z < 1 \/ 1 <= square z.
Proof.
  intros [x y]. destruct (Rlt_le_dec (square (x, y)) 1) as [L|L]; [left | now right].
  unfold Cmod. rewrite <- sqrt_1. apply sqrt_lt_1_alt. simpl fst; simpl snd.
  replace (x ^ 2 + y ^ 2) with (square (x, y)) by (unfold square; simpl; ring).
  split; [apply square_not_negative | exact L].
Qed.

(* g 0 + ... + g n *)
Fixpoint csum (n : nat) (g : nat -> C) : C :=
  match n with O => g O | S m => Cplus (csum m g) (g n) end.
Lemma csum_ext : forall n g h, (forall k, (k <= n)%nat -> g k = h k) -> csum n g = csum n h.
Proof. induction n; intros g h E; simpl; [apply E; lia|]. rewrite (IHn g h), E; auto. Qed.
Lemma csum_first : forall n g, csum (S n) g = Cplus (g O) (csum n (fun k => g (S k))).
Proof.
  induction n; intros g; [reflexivity|]. change (csum (S (S n)) g) with (Cplus (csum (S n) g) (g (S (S n)))).
  rewrite IHn. simpl. ring.
Qed.
Lemma csum_both : forall n g h a b,
  csum n (fun k => Cminus (Cmult a (g k)) (Cmult b (h k))) = Cminus (Cmult a (csum n g)) (Cmult b (csum n h)).
Proof. induction n; intros; simpl; [reflexivity|]. rewrite IHn. ring. Qed.
Lemma csum_times : forall n g a, csum n (fun k => Cmult a (g k)) = Cmult a (csum n g).
Proof. induction n; intros; simpl; [reflexivity|]. rewrite IHn. ring. Qed.

Fixpoint cpow (z : C) (k : nat) : C := match k with O => RtoC 1 | S m => Cmult z (cpow z m) end.
Definition value (n : nat) (f : nat -> R) (z : C) : C := csum n (fun k => Cmult (RtoC (f k)) (cpow z k)).
Definition turned (n : nat) (f : nat -> R) (k : nat) : R := f (n - k)%nat.
Definition next (n : nat) (f : nat -> R) (k : nat) : R := f (S n) * f (S k) + -1 * (f O * f (n - k)%nat).

Lemma RtoC_next : forall a b c d : R,
  RtoC (a * b + -1 * (c * d)) = Cminus (Cmult (RtoC a) (RtoC b)) (Cmult (RtoC c) (RtoC d)).
Proof. intros. apply injective_projections; simpl; ring. Qed.

Lemma next_value : forall n f z, Cmult z (value n (next n f) z) =
  Cminus (Cmult (RtoC (f (S n))) (value (S n) f z)) (Cmult (RtoC (f O)) (value (S n) (turned (S n) f) z)).
Proof.
  intros n f z. unfold value. rewrite !csum_first. unfold turned at 1. rewrite Nat.sub_0_r.
  rewrite <- csum_times.
  rewrite (csum_ext n _ (fun k => Cminus (Cmult (RtoC (f (S n))) (Cmult (RtoC (f (S k))) (cpow z (S k))))
                                     (Cmult (RtoC (f O)) (Cmult (RtoC (turned (S n) f (S k))) (cpow z (S k)))))).
  - rewrite csum_both. simpl. ring.
  - intros k _. unfold next, turned. simpl. rewrite RtoC_next. ring.
Qed.
Lemma next_turned : forall n f z, value n (turned n (next n f)) z =
  Cminus (Cmult (RtoC (f (S n))) (value (S n) (turned (S n) f) z)) (Cmult (RtoC (f O)) (value (S n) f z)).
Proof.
  intros n f z. unfold value. simpl csum. unfold turned at 3. rewrite Nat.sub_diag.
  rewrite (csum_ext n _ (fun k => Cminus (Cmult (RtoC (f (S n))) (Cmult (RtoC (turned (S n) f k)) (cpow z k)))
                                     (Cmult (RtoC (f O)) (Cmult (RtoC (f k)) (cpow z k))))).
  - rewrite csum_both. simpl. ring.
  - intros k K. unfold next, turned. replace (n - (n - k))%nat with k by lia.
    replace (S n - k)%nat with (S (n - k)) by lia.
    rewrite RtoC_next. ring.
Qed.

Fixpoint schur (n : nat) (f : nat -> R) : Prop :=
  match n with
  | O => f O <> 0
  | S m => 0 < f (S m) * f (S m) + -1 * (f O * f O) /\ schur m (next m f)
  end.

Lemma schur_outside : forall n f, schur n f -> forall z, 1 <= square z ->
  value n f z <> RtoC 0 /\ square (value n (turned n f) z) <= square (value n f z).
Proof.
  induction n; intros f S z L.
  - simpl in S. unfold value, turned; simpl. split.
    + intros E. apply S. apply (f_equal fst) in E. simpl in E. lra.
    + apply Rle_refl.
  - destruct S as [D S]. destruct (IHn _ S z L) as [N M].
    pose proof (next_value n f z) as V. pose proof (next_turned n f z) as T.
    revert N M V T. generalize (value n (next n f) z) (value n (turned n (next n f)) z).
    generalize (value (Datatypes.S n) f z) (value (Datatypes.S n) (turned (Datatypes.S n) f) z).
    revert D. generalize (f (Datatypes.S n)) (f O). clear S IHn. intros c d D p p' q q' N M V T.
    assert (Q : 0 < square q).
    { destruct (Rle_lt_or_eq_dec _ _ (square_not_negative q)) as [|E]; [assumption|]. exfalso. apply N.
      now apply square_zero. }
    assert (W : square q <= square (Cmult z q)) by (rewrite square_of_product; nra).
    rewrite V in W.
    assert (A : square (Cminus (Cmult (RtoC c) p) (Cmult (RtoC d) p')) +
                -1 * square (Cminus (Cmult (RtoC c) p') (Cmult (RtoC d) p)) =
                (c * c + -1 * (d * d)) * (square p + -1 * square p')).
    { destruct p, p'. unfold square, Cminus, Cmult, RtoC, Copp, Cplus; simpl. ring. }
    rewrite T in M. split.
    + intros ->.
      assert (B : square (Cminus (Cmult (RtoC c) p') (Cmult (RtoC d) (RtoC 0))) = c * c * square p').
      { destruct p'. unfold square, Cminus, Cmult, RtoC, Copp, Cplus; simpl. ring. }
      assert (Z : square (RtoC 0) = 0) by (unfold square; simpl; ring).
      pose proof (square_not_negative p'). rewrite B in A, M. rewrite Z in A. nra.
    + nra.
Qed.

Lemma value_of_polynomial : forall n (c : Mat (S n) 1) z, polynomial (S n) c z = value n (fun k => ent k 0 c) z.
Proof.
  unfold value. induction n; intros [[a []] c] z.
  - simpl. unfold ent; simpl. ring.
  - change (polynomial (S (S n)) (a, tt, c) z) with (Cplus (RtoC a) (Cmult z (polynomial (S n) c z))).
    rewrite IHn, csum_first, <- csum_times. unfold ent at 2; simpl. f_equal; [ring|].
    apply csum_ext. intros k _. unfold ent; simpl. ring.
Qed.

Theorem inside_by_schur : forall n (c : Mat (S n) 1), schur n (fun k => ent k 0 c) -> inside_unit_circle c.
Proof.
  intros n c S z E. destruct (square_of_modulus z) as [|L]; [assumption|].
  exfalso. apply (proj1 (schur_outside n _ S z L)). now rewrite <- value_of_polynomial.
Qed.
