(* Matrices of four rows that are inverted. *)
From Stickslip Require Export Algebra.
Definition identity4 : Mat 4 4 :=
  mat 4 4 ⟦⟦1, 0, 0, 0⟧, ⟦0, 1, 0, 0⟧, ⟦0, 0, 1, 0⟧, ⟦0, 0, 0, 1⟧⟧.
Ltac take_apart A := revert A; by_entries; intros.
Lemma det_product : forall A B : Mat 4 4, det 4 (A ** B) = det 4 A * det 4 B.
Proof. intros A B. take_apart A. take_apart B. reduce_matrices. by_fractions. Qed.
Lemma mmul_associative : forall A B C : Mat 4 4, A ** (B ** C) = A ** B ** C.
Proof. intros A B C. take_apart A. take_apart B. take_apart C. reduce_matrices; by_fractions. Qed.
Lemma identity_left : forall A : Mat 4 4, identity4 ** A = A.
Proof. intros A. take_apart A. unfold identity4. reduce_matrices; by_fractions. Qed.
Lemma identity_right : forall A : Mat 4 4, A ** identity4 = A.
Proof. intros A. take_apart A. unfold identity4. reduce_matrices; by_fractions. Qed.
Lemma inverse_left : forall A : Mat 4 4, det 4 A <> 0 -> minv A ** A = identity4.
Proof. by_entries. unfold identity4. reduce_matrices. intros. by_fractions. Qed.
Lemma inverse_of : forall A B : Mat 4 4, A ** B = identity4 -> minv A = B.
Proof.
  intros A B E.
  assert (N : det 4 A <> 0).
  { intros Z. pose proof (det_product A B) as P. rewrite E, Z in P. revert P. unfold identity4.
    reduce_matrices. intros. lra. }
  now rewrite <- (identity_right (minv A)), <- E, mmul_associative, (inverse_left A N), identity_left.
Qed.

(* What is not 0 because it is, but for the order of its terms, what D says is not. *)
Ltac nonzero_like D :=
  let Z := fresh in
  intros Z; apply D; match type of Z with ?u = 0 => transitivity u; [ring | exact Z] end.
(* M = A N gives N, of two rows. *)
Lemma inverse_solves : forall A M N : Mat 2 2, det 2 A <> 0 -> M = A ** N -> minv A ** M = N.
Proof.
  intros [[a [b []]] [[c [d []]] []]] M [[e [f []]] [[g [h []]] []]] D ->.
  revert D. reduce_matrices. intros D.
  repeat match goal with |- pair _ _ = pair _ _ => apply f_equal2 | |- tt = tt => reflexivity end;
    field; nonzero_like D.
Qed.
