(* Real matrices, as large as they need to be and no larger: equal when their entries are.

   A matrix of r rows and c columns is a tuple of r rows, a row a tuple of c numbers; the tuples end with tt.
   A matrix of one row and one column is always written as a number. *)
From Coq Require Export Reals Classical Lra Lia List.
Open Scope R_scope.

(* Theorems in one bundle, whatever they say: what all of them rest on is asked once. *)
Inductive proved : Prop := no_more | and_also {A : Prop} (a : A) (others : proved).

Fixpoint Vec (A : Type) (n : nat) : Type :=
  match n with O => unit | S m => (A * Vec A m)%type end.
Definition Mat (r c : nat) : Type := Vec (Vec R c) r.

Fixpoint vmap {A B : Type} (f : A -> B) (n : nat) : Vec A n -> Vec B n :=
  match n with
  | O => fun _ => tt
  | S m => fun v => (f (fst v), vmap f m (snd v))
  end.
Fixpoint vmap2 {A B C : Type} (f : A -> B -> C) (n : nat) : Vec A n -> Vec B n -> Vec C n :=
  match n with
  | O => fun _ _ => tt
  | S m => fun v w => (f (fst v) (fst w), vmap2 f m (snd v) (snd w))
  end.
(* (f 0, f 1, …, f (n - 1)) *)
Fixpoint vtab {A : Type} (n : nat) (f : nat -> A) : Vec A n :=
  match n with
  | O => tt
  | S m => (f O, vtab m (fun k => f (S k)))
  end.
(* The k-th, from 0; `other` beyond the end. *)
Fixpoint vnth {A : Type} (other : A) (n : nat) (k : nat) : Vec A n -> A :=
  match n with
  | O => fun _ => other
  | S m => fun v => match k with O => fst v | S j => vnth other m j (snd v) end
  end.
Fixpoint vconst {A : Type} (a : A) (n : nat) : Vec A n :=
  match n with O => tt | S m => (a, vconst a m) end.
(* All but the k-th. *)
Fixpoint vdrop {A : Type} (n : nat) (k : nat) : Vec A (S n) -> Vec A n :=
  match n with
  | O => fun _ => tt
  | S m => fun v => match k with O => snd v | S j => (fst v, vdrop m j (snd v)) end
  end.

Definition mzero (r c : nat) : Mat r c := vconst (vconst 0 c) r.
Definition ent {r c : nat} (i j : nat) (A : Mat r c) : R := vnth 0 c j (vnth (vconst 0 c) r i A).
Definition mplus {r c : nat} (A B : Mat r c) : Mat r c := vmap2 (vmap2 Rplus c) r A B.
Definition mscal {r c : nat} (s : R) (A : Mat r c) : Mat r c := vmap (vmap (Rmult s) c) r A.
(* A row times a matrix. *)
Fixpoint rowmul {c : nat} (k : nat) : Vec R k -> Mat k c -> Vec R c :=
  match k with
  | O => fun _ _ => vconst 0 c
  | S m => fun a B => vmap2 Rplus c (vmap (Rmult (fst a)) c (fst B)) (rowmul m (snd a) (snd B))
  end.
Definition mmul {r k c : nat} (A : Mat r k) (B : Mat k c) : Mat r c := vmap (fun a => rowmul k a B) r A.
(* A row times a column: a number. *)
Definition dot {k : nat} (A : Mat 1 k) (B : Mat k 1) : R := ent 0 0 (mmul A B).

Definition sgn (k : nat) : R := if Nat.even k then 1 else -1.
(* The determinant, by the first row. *)
Fixpoint vsum (n : nat) : Vec R n -> R :=
  match n with O => fun _ => 0 | S m => fun v => fst v + vsum m (snd v) end.
Fixpoint det (n : nat) : Mat n n -> R :=
  match n with
  | O => fun _ => 1
  | S m => fun A =>
      vsum (S m) (vtab (S m) (fun k => sgn k * (vnth 0 (S m) k (fst A) * det m (vmap (vdrop m k) m (snd A)))))
  end.
(* The inverse by cofactors: where the determinant is 0, some matrix of which nothing is said. *)
Definition minv {n : nat} : Mat n n -> Mat n n :=
  match n with
  | O => fun A => A
  | S m => fun A =>
      vtab (S m) (fun i => vtab (S m) (fun j =>
        sgn (i + j) * (det m (vmap (vdrop m i) m (vdrop m j A)) * / det (S m) A)))
  end.

(* A matrix written out. *)
Definition mat (r c : nat) (rows : Vec (Vec R c) r) : Mat r c := rows.

Notation "⟦ x , .. , y ⟧" := (pair x .. (pair y tt) ..) (at level 0, x at level 99, y at level 99) : R_scope.
Notation "A +m B" := (mplus A B) (at level 50, left associativity) : R_scope.
Notation "s *m A" := (mscal s A) (at level 40, left associativity) : R_scope.
Notation "A ** B" := (mmul A B) (at level 40, left associativity) : R_scope.
(* A - B is A + (-1) B, of numbers too, and a / b is a times the inverse of b. *)
Notation "A -m B" := (mplus A (mscal (-1) B)) (at level 50, left associativity) : R_scope.
Notation "a - b" := (Rplus a (Rmult (-1) b)) : R_scope.
Notation "a / b" := (Rmult a (Rinv b)) : R_scope.

Ltac reduce_matrices :=
  cbv beta iota zeta delta
    [Mat mat vmap vmap2 vtab vnth vconst vdrop mzero ent mplus mscal rowmul mmul dot sgn vsum det minv fst snd
     Nat.even Nat.add negb].
Ltac reduced_matrices t :=
  eval cbv beta iota zeta delta
    [Mat mat vmap vmap2 vtab vnth vconst vdrop mzero ent mplus mscal rowmul mmul dot sgn vsum det minv fst snd
     Nat.even Nat.add negb] in t.
Ltac reduce_matrices_in Q :=
  cbv beta iota zeta delta
    [Mat mat vmap vmap2 vtab vnth vconst vdrop mzero ent mplus mscal rowmul mmul dot sgn vsum det minv fst snd
     Nat.even Nat.add negb] in Q.

(* ---- what a difference says *)

Lemma vmap2_plus_zero : forall c (a : Vec R c), vmap2 Rplus c a (vmap (Rmult (-1)) c a) = vconst 0 c.
Proof.
  induction c; intros a; simpl; [now destruct a|]. rewrite IHc. f_equal. ring.
Qed.
Lemma mdifference : forall r c (A : Mat r c), mplus A (mscal (-1) A) = mzero r c.
Proof.
  unfold mplus, mscal, mzero, Mat. induction r; intros c A; simpl; [now destruct A|].
  rewrite vmap2_plus_zero, IHr. reflexivity.
Qed.
Lemma vequal : forall c (a b : Vec R c), vmap2 Rplus c a (vmap (Rmult (-1)) c b) = vconst 0 c -> a = b.
Proof.
  induction c; simpl; intros [] []; [reflexivity|]. intros E. injection E as E1 E2. simpl in *.
  f_equal; [lra | now apply IHc].
Qed.
Lemma mequal : forall r c (A B : Mat r c), mplus A (mscal (-1) B) = mzero r c -> A = B.
Proof.
  unfold mplus, mscal, mzero, Mat. induction r; simpl; intros c [] []; [reflexivity|]. intros E.
  injection E as E1 E2. simpl in *. f_equal; [now apply vequal | now apply IHr].
Qed.
Lemma mdiffer : forall r c (A B : Mat r c), A = B -> mplus A (mscal (-1) B) = mzero r c.
Proof. intros r c A B E. rewrite E. apply mdifference. Qed.
Lemma rdiffer : forall a b : R, a = b -> a + -1 * b = 0.
Proof. intros; lra. Qed.
Lemma requal : forall a b : R, a + -1 * b = 0 -> a = b.
Proof. intros; lra. Qed.

Lemma vscal_zero : forall s c, vmap (Rmult s) c (vconst 0 c) = vconst 0 c.
Proof. induction c; simpl; [reflexivity|]. rewrite IHc. f_equal. ring. Qed.
Lemma mscal_zero : forall r c s, mscal s (mzero r c) = mzero r c.
Proof.
  unfold mscal, mzero, Mat. induction r; intros c s; simpl; [reflexivity|]. now rewrite IHr, vscal_zero.
Qed.
Lemma vzero_scal : forall c (a : Vec R c), vmap (Rmult 0) c a = vconst 0 c.
Proof. induction c; intros []; simpl; [reflexivity|]. rewrite IHc. f_equal. ring. Qed.
Lemma mzero_scal : forall r c (A : Mat r c), mscal 0 A = mzero r c.
Proof.
  unfold mscal, mzero, Mat. induction r; intros c []; simpl; [reflexivity|]. now rewrite IHr, vzero_scal.
Qed.
Lemma vplus_zero : forall c (a : Vec R c), vmap2 Rplus c a (vconst 0 c) = a.
Proof. induction c; intros []; simpl; [reflexivity|]. rewrite IHc. f_equal. ring. Qed.
Lemma mplus_zero : forall r c (A : Mat r c), mplus A (mzero r c) = A.
Proof.
  unfold mplus, mzero, Mat. induction r; intros c []; simpl; [reflexivity|]. now rewrite IHr, vplus_zero.
Qed.
Lemma rowmul_zero : forall k c (a : Vec R k), rowmul k a (mzero k c) = vconst 0 c.
Proof.
  induction k; intros c []; simpl; [reflexivity|]. unfold mzero in IHk. rewrite IHk, vscal_zero.
  apply vplus_zero.
Qed.
Lemma mmul_zero : forall r k c (A : Mat r k), mmul A (mzero k c) = mzero r c.
Proof.
  unfold mmul, Mat. induction r; intros k c []; simpl; [reflexivity|]. rewrite rowmul_zero.
  rewrite IHr. reflexivity.
Qed.
Lemma zero_rowmul : forall k c (B : Mat k c), rowmul k (vconst 0 k) B = vconst 0 c.
Proof.
  induction k; intros c []; simpl; [reflexivity|]. rewrite IHk, vzero_scal. apply vplus_zero.
Qed.
Lemma zero_mmul : forall r k c (B : Mat k c), mmul (mzero r k) B = mzero r c.
Proof.
  unfold mmul, mzero, Mat. induction r; intros k c B; simpl; [reflexivity|].
  now rewrite zero_rowmul, IHr.
Qed.
Lemma dot_zero : forall k (A : Mat 1 k), dot A (mzero k 1) = 0.
Proof. intros. unfold dot. now rewrite mmul_zero. Qed.
Lemma zero_dot : forall k (B : Mat k 1), dot (mzero 1 k) B = 0.
Proof. intros. unfold dot. now rewrite zero_mmul. Qed.
Lemma rplus_zero : forall a : R, a + 0 = a.
Proof. intros; ring. Qed.
Lemma rmult_zero : forall a : R, a * 0 = 0.
Proof. intros; ring. Qed.
Lemma zero_rmult : forall a : R, 0 * a = 0.
Proof. intros; ring. Qed.

(* A sum of multiples of zero is zero. *)
Ltac vanish :=
  rewrite ?mscal_zero, ?mzero_scal, ?mmul_zero, ?zero_mmul, ?dot_zero, ?zero_dot, ?rmult_zero, ?zero_rmult;
  repeat (first [rewrite mplus_zero | rewrite rplus_zero | rewrite mscal_zero | rewrite mzero_scal
                | rewrite mmul_zero | rewrite zero_mmul | rewrite dot_zero | rewrite zero_dot
                | rewrite rmult_zero | rewrite zero_rmult]);
  try reflexivity.

(* A right inverse is the inverse. *)
