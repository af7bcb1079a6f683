(* What the steps of a certificate are made of: sums of multiples, signs of products, cos and sin of sums. *)
From Stickslip Require Export Matrices Sentences.
From Stickslip Require Fractions.

(* ---- logic *)

Lemma trichotomy : forall a b : R,
  (a < b \/ a = b \/ b < a) /\ ~ (a < b /\ a = b) /\ ~ (a < b /\ b < a) /\ ~ (a = b /\ b < a) /\
  ((a <= b -> a < b \/ a = b) /\ (a < b \/ a = b -> a <= b)) /\
  ((b <= a -> a = b \/ b < a) /\ (a = b \/ b < a -> b <= a)).
Proof. intros. repeat split; lra. Qed.

Lemma zero_product : forall a b : R, a * b = 0 -> a = 0 \/ b = 0.
Proof. exact Rmult_integral. Qed.

Lemma sine_is_positive : forall x, 0 < x < PI -> 0 < sin x.
Proof. intros x []. now apply sin_gt_0. Qed.

Lemma square_root : forall a, 0 <= a -> exists x, 0 <= x /\ x ^ 2 = a.
Proof.
  intros a L. exists (sqrt a). split; [apply sqrt_pos|]. now rewrite <- Rsqr_pow2, Rsqr_sqrt.
Qed.

(* ---- sums of multiples *)

Lemma by_difference : forall a b T : R, a + -1 * b = T -> T = 0 -> a = b.
Proof. intros; lra. Qed.
Lemma by_difference_m : forall r c (A B T : Mat r c),
  mplus A (mscal (-1) B) = T -> T = mzero r c -> A = B.
Proof. intros r c A B T E Z. apply mequal. now rewrite E. Qed.
Lemma by_less : forall a b T : R, b + -1 * a = T -> 0 < T -> a < b.
Proof. intros; lra. Qed.
Lemma by_at_most : forall a b T : R, b + -1 * a = T -> 0 <= T -> a <= b.
Proof. intros; lra. Qed.
Lemma less_gap : forall a b : R, a < b -> 0 < b + -1 * a.
Proof. intros; lra. Qed.
Lemma at_most_gap : forall a b : R, a <= b -> 0 <= b + -1 * a.
Proof. intros; lra. Qed.

Lemma zero_plus : forall a b : R, a = 0 -> b = 0 -> a + b = 0.
Proof. intros; lra. Qed.
Lemma zero_mplus : forall r c (A B : Mat r c), A = mzero r c -> B = mzero r c -> mplus A B = mzero r c.
Proof. intros r c A B -> ->. apply mplus_zero. Qed.

(* A product of what is positive and of squares. *)
Ltac positive_product :=
  first
    [ assumption
    | match goal with
      | |- 0 < _ * _ => apply Rmult_lt_0_compat; positive_product
      | |- 0 <= _ * _ => apply Rmult_le_pos; positive_product
      | |- 0 <= _ ^ 2 => apply pow2_ge_0
      | |- 0 < 1 ^ 2 => lra
      | |- 0 <= _ => apply Rlt_le; assumption
      | |- _ => lra
      end ].
(* A sum of such products, and of zeros. *)
Ltac positive_sum :=
  first
    [ positive_product
    | match goal with
      | |- 0 <= _ + _ => apply Rplus_le_le_0_compat; positive_sum
      | |- 0 < _ + _ =>
          first [ apply Rplus_lt_le_0_compat; positive_sum | apply Rplus_le_lt_0_compat; positive_sum ]
      end ].

(* ---- cos and sin *)

Lemma circle : forall x, cos x * cos x = 1 - sin x * sin x.
Proof. intros. pose proof (sin2_cos2 x). unfold Rsqr in *. lra. Qed.

Lemma cos_quarter : cos (PI / 2) = 0.
Proof. exact cos_PI2. Qed.
Lemma sin_quarter : sin (PI / 2) = 1.
Proof. exact sin_PI2. Qed.

(* A sum of phases, with their cos and sin. *)
Inductive angle : Type := Phase (x : R) | Nothing | Quarter | Turn | Back (a : angle) | Sum (a b : angle).
Fixpoint size (a : angle) : R :=
  match a with
  | Phase x => x
  | Nothing => 0
  | Quarter => PI / 2
  | Turn => 2 * PI
  | Back a => - size a
  | Sum a b => size a + size b
  end.
Fixpoint cos_of (a : angle) : R :=
  match a with
  | Phase x => cos x
  | Quarter => 0
  | Nothing | Turn => 1
  | Back a => cos_of a
  | Sum a Turn | Sum a (Back Turn) => cos_of a
  | Sum a b => cos_of a * cos_of b - sin_of a * sin_of b
  end
with sin_of (a : angle) : R :=
  match a with
  | Phase x => sin x
  | Quarter => 1
  | Nothing | Turn => 0
  | Back a => - sin_of a
  | Sum a Turn | Sum a (Back Turn) => sin_of a
  | Sum a b => sin_of a * cos_of b + cos_of a * sin_of b
  end.
Lemma circle_of : forall a, cos (size a) = cos_of a /\ sin (size a) = sin_of a.
Proof.
  induction a as [x| | | |a [A B]|a [A B] b [C D]].
  - now split.
  - split; [apply cos_0 | apply sin_0].
  - split; [apply cos_PI2 | apply sin_PI2].
  - split; [apply cos_2PI | apply sin_2PI].
  - simpl. now rewrite cos_neg, sin_neg, A, B.
  - assert (E : cos (size (Sum a b)) = cos_of a * cos_of b - sin_of a * sin_of b /\
                sin (size (Sum a b)) = sin_of a * cos_of b + cos_of a * sin_of b).
    { simpl size. rewrite cos_plus, sin_plus, A, B, C, D. split; ring. }
    destruct E as [E F]. rewrite E, F. clear.
    destruct b as [x| | | |b|b1 b2]; try (split; reflexivity); [simpl; split; ring|].
    destruct b; try (split; reflexivity). simpl. split; ring.
Qed.
Lemma cos_is : forall a x, x = size a -> cos x = cos_of a.
Proof. intros a x ->. apply circle_of. Qed.
Lemma sin_is : forall a x, x = size a -> sin x = sin_of a.
Proof. intros a x ->. apply circle_of. Qed.
Ltac angle_of x :=
  lazymatch x with
  | ?a + ?b => let a := angle_of a in let b := angle_of b in constr:(Sum a b)
  | - ?a => let a := angle_of a in constr:(Back a)
  | 0 => Nothing
  | PI / 2 => Quarter
  | 2 * PI => Turn
  | _ => constr:(Phase x)
  end.

(* By `E : argument = sum of phases`, what cos and sin of the argument are: not computed before the argument's
   own are letters, for it may be a phase. *)
Ltac expand_circle E C S :=
  match type of E with
  | ?x = ?y => let a := angle_of y in pose proof (cos_is a x E) as C; pose proof (sin_is a x E) as S
  end.
Ltac intro_letters := repeat match goal with |- ?c = _ -> _ => is_var c; intros ? end.

Lemma zero_of_sine : forall x, sin x = 0 -> exists k : Z, x = (IZR k + 0) * PI.
Proof. intros x Z. destruct (sin_eq_0_0 x Z) as [k E]. exists k. rewrite E. ring. Qed.
Lemma zero_of_cosine : forall x, cos x = 0 -> exists k : Z, x = (IZR k + / 2) * PI.
Proof. intros x Z. destruct (cos_eq_0_0 x Z) as [k E]. exists k. rewrite E. unfold Rdiv. ring. Qed.
Lemma between_turns : forall m n o k x : R, x = (k + o) * PI -> m * PI < x -> x < n * PI -> m < k + o < n.
Proof.
  intros m n o k x -> L U. pose proof PI_RGT_0. split; apply (Rmult_lt_reg_r PI); assumption.
Qed.

(* ---- entries, and what divides *)

(* What is so of every matrix that is written out. Taken apart by cases, a matrix has the goal typed anew for each
   of its entries; this does it once. *)
Fixpoint every_row (c : nat) : (Vec R c -> Prop) -> Prop :=
  match c with O => fun P => P tt | S n => fun P => forall x : R, every_row n (fun v => P (x, v)) end.
Fixpoint every_matrix (r c : nat) : (Mat r c -> Prop) -> Prop :=
  match r with
  | O => fun P => P tt
  | S n => fun P => every_row c (fun v => every_matrix n c (fun A => P (v, A)))
  end.
Lemma of_every_row : forall c (P : Vec R c -> Prop), every_row c P -> forall v, P v.
Proof.
  induction c as [|c I]; intros P E; [now intros []|]. intros [x v]. exact (I (fun v => P (x, v)) (E x) v).
Qed.
Lemma of_every_matrix : forall r c (P : Mat r c -> Prop), every_matrix r c P -> forall A, P A.
Proof.
  induction r as [|r I]; intros c P E; [now intros []|]. intros [v A].
  exact (I c (fun A => P (v, A)) (of_every_row c _ E v) A).
Qed.
Ltac by_entries :=
  lazymatch goal with
  | |- forall A : Mat ?r ?c, @?P A =>
      refine (of_every_matrix r c P _); cbv beta iota delta [every_matrix every_row]
  end.

(* What is known beside the goal is not needed. *)
Ltac forget :=
  repeat match goal with H : ?P |- _ => lazymatch type of P with Prop => clear H end end.
Lemma factor_left : forall a b : R, a * b <> 0 -> a <> 0.
Proof. intros a b N E. apply N. rewrite E. ring. Qed.
Lemma factor_right : forall a b : R, a * b <> 0 -> b <> 0.
Proof. intros a b N E. apply N. rewrite E. ring. Qed.
Lemma base_of_power : forall (a : R) n, a ^ S n <> 0 -> a <> 0.
Proof. intros a n N E. apply N. rewrite E. simpl. ring. Qed.

Ltac split_factors :=
  repeat match goal with
         | N : ?a * ?b <> 0 |- _ =>
             pose proof (factor_left a b N); pose proof (factor_right a b N); clear N
         | N : ?a ^ S _ <> 0 |- _ => apply base_of_power in N
         end.

(* ---- an equation of numbers as one of expressions *)

(* Many at once: the result is typed anew each time. *)
Ltac abstracted xs t :=
  lazymatch xs with
  | nil => t
  | cons ?a (cons ?b (cons ?c (cons ?d (cons ?e (cons ?f (cons ?g (cons ?h (cons ?i (cons ?j (cons ?k (cons ?l ?rest))))))))))) =>
      let u := eval pattern l, k, j, i, h, g, f, e, d, c, b, a in t in
      lazymatch u with ?v _ _ _ _ _ _ _ _ _ _ _ _ => abstracted rest v end
  | cons ?a (cons ?b (cons ?c (cons ?d ?rest))) =>
      let u := eval pattern d, c, b, a in t in
      lazymatch u with ?v _ _ _ _ => abstracted rest v end
  | cons ?a ?rest =>
      let u := eval pattern a in t in
      lazymatch u with ?v _ => abstracted rest v end
  end.
Ltac applied_to_letters xs k t :=
  lazymatch xs with
  | nil => t
  | cons _ ?rest => let t := applied_to_letters rest (Pos.succ k) t in constr:(t (Fractions.Letter k))
  end.
Ltac place x xs k :=
  lazymatch xs with
  | cons x _ => eval cbv in k
  | cons _ ?rest => place x rest (Pos.succ k)
  end.
Ltac numbers_in_context xs :=
  match goal with
  | x : R |- _ =>
      lazymatch xs with
      | context [cons x _] => fail
      | _ => numbers_in_context (cons x xs)
      end
  | _ => xs
  end.
(* The expressions of a list of numbers. *)
Ltac expressions xs t :=
  let t := abstracted xs t in
  let u := eval pattern R, Rplus, Rmult, Rminus, Rdiv, Ropp, Rinv, IZR, pow in t in
  lazymatch u with
  | ?f _ _ _ _ _ _ _ _ _ =>
      let t := constr:(f Fractions.expression Fractions.Plus Fractions.Times Fractions.Minus Fractions.Over
                     Fractions.Opposite Fractions.Inverse Fractions.Number Fractions.Power) in
      let t := applied_to_letters xs 1%positive t in
      eval cbv beta delta [Pos.succ] iota in t
  end.
(* Of c = e -> … -> c c = 1 - s s -> … -> d <> 0 -> … -> a = b: the letters c, the pairs (c, s), the e, and a, b,
   and the d, the last one first. *)
Ltac letters_in G xs :=
  lazymatch G with
  | ?c * _ = _ -> _ => constr:(@nil positive)
  | ?c = _ -> ?rest =>
      let i := place c xs 1%positive in
      let is := letters_in rest xs in
      constr:(cons i is)
  | _ => constr:(@nil positive)
  end.
Ltac circles_in G xs :=
  lazymatch G with
  | ?c * _ = _ + _ * (?s * _) -> ?rest =>
      let i := place c xs 1%positive in
      let j := place s xs 1%positive in
      let cs := circles_in rest xs in
      constr:(cons (i, j) cs)
  | _ = _ -> ?rest => circles_in rest xs
  | _ => constr:(@nil (positive * positive))
  end.
Ltac values_in G :=
  lazymatch G with
  | _ * _ = _ -> _ => constr:(@nil R)
  | _ = ?e -> ?rest => let es := values_in rest in constr:(cons e es)
  | _ => constr:(@nil R)
  end.
Ltac numbers_in G ds :=
  lazymatch G with
  | _ = _ -> ?rest => numbers_in rest ds
  | ?d <> 0 -> ?rest => numbers_in rest constr:(cons d ds)
  | ?a = ?b => constr:(((a, b), ds))
  end.
Ltac type_of_equation G := lazymatch G with _ -> ?G => type_of_equation G | @eq ?T _ _ => T end.
(* Of what is read and what is said, the former is to be computed. *)
Strategy expand
  [Fractions.value BinList.nth BinList.jump Fractions.where_equal Fractions.on_circles Fractions.where_nonzero vmap].
Ltac by_fractions :=
  let xs := numbers_in_context (@nil R) in
  repeat match goal with N : _ <> 0 |- _ => revert N end;
  repeat match goal with K : ?c * ?c = 1 - ?s * ?s |- _ => revert K end;
  repeat match goal with E : ?c = _ |- _ => is_var c; revert E end;
  lazymatch goal with
  | |- ?G =>
      let is := letters_in G xs in
      let cs := circles_in G xs in
      let vs := values_in G in
      let ns := numbers_in G (@nil R) in
      let read := expressions xs (pair vs ns) in
      lazymatch read with
      | pair ?vs (pair (pair ?a ?b) ?es) =>
          let gs := eval cbv in (combine is vs) in
          let es := eval cbv in (rev es) in
          let by_test test lemma :=
            cut (test = true); [exact_no_check lemma | vm_cast_no_check (@eq_refl bool true)] in
          lazymatch type_of_equation G with
          | R => by_test (Fractions.identical gs cs es a b) (Fractions.identical_ok xs gs cs es a b)
          | Vec (Vec R ?c) ?r =>
              by_test (Fractions.identical_m gs cs es r c a b) (Fractions.identical_m_ok xs gs cs es r c a b)
          end
      end
  end.

(* c <> 0, or several such, because something that is known not to be 0 is a multiple of c, or has it as its
   numerator. *)
Ltac nonzero_at n :=
  repeat match goal with |- _ /\ _ => split end;
  first
    [ assumption
    | exact PI_neq0
    | lra
    | apply Rmult_integral_contrapositive_currified; nonzero_at n
    | apply pow_nonzero; nonzero_at n
    | apply Rinv_neq_0_compat; nonzero_at n
    | match n with
      | S ?m =>
          match goal with
          | N : ?d <> 0 |- ?c <> 0 =>
              let E := fresh in
              intro E; apply N; clear N;
              first [ lra | solve [rewrite E; ring] | solve [field_simplify_eq; [lra | nonzero_at m]]
                    | solve [field_simplify_eq; [nra | nonzero_at m]] ]
          end
      end ].
Ltac nonzero := nonzero_at 3%nat.

(* An equation between angles. *)
Ltac angle := first [reflexivity | ring | split_factors; field; nonzero].
(* One definition or function applied to arguments that are equal. *)
Ltac same_atom := f_equal; angle.
