(* What the steps of a certificate are made of: sums of multiples, signs of products, cos and sin of sums. *)
From Stickslip Require Export Matrices Sentences.
From Stickslip Require Fractions.
From Stickslip Require Import Reading.
From Ltac2 Require Import Ltac2.
Set Default Proof Mode "Classic".

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

(* A part of what `proof` shows: after so many others, the first or all that is left, and so on within that. Each part is
   named once, where a projection for each that comes before would name all that comes after it. *)
Ltac2 opened_both (said : constr) : constr := match! said with _ /\ _ => said | _ => Std.eval_hnf said end.
Ltac2 rec part_shown (path : constr) (proof : constr) (said : constr) : constr :=
  match! path with
  | nil => proof
  | (?skipped, ?first) :: ?path =>
      let rec after n said before :=
        match! n with
        | O => (List.rev before, said)
        | S ?n => let both := opened_both said in after n (part both 1) (part both 0 :: before)
        end in
      let (before, rest) := after skipped said [] in
      let proof :=
        match before with [] => proof | _ => applied constr:(said_after) [listed constr:(Prop) before; rest; proof] end in
      if Constr.equal first constr:(Datatypes.true) then
        let rest := opened_both rest in
        part_shown path (applied constr:(@proj1) [part rest 0; part rest 1; proof]) (part rest 0)
      else part_shown path proof rest
  end.
Ltac exact_part path proof :=
  let f := ltac2:(path proof |-
    let proof := Option.get (Ltac1.to_constr proof) in
    Std.exact_no_check (part_shown (Option.get (Ltac1.to_constr path)) proof (Constr.type proof))) in
  f constr:(path) constr:(proof).

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

(* By `E : argument = sum of phases`, what cos and sin of the argument are. *)
Ltac expand_circle E C S :=
  match type of E with
  | ?x = ?y =>
      let a := angle_of y in
      pose proof (cos_is a x E) as C; pose proof (sin_is a x E) as S; cbv beta iota delta [cos_of sin_of] in C, S
  end.

(* The same of exp, where a quarter and a turn are numbers as all others. *)
Fixpoint exp_of (a : angle) : R :=
  match a with
  | Phase x => exp x
  | Nothing => 1
  | Quarter => exp (PI / 2)
  | Turn => exp (2 * PI)
  | Back a => / exp_of a
  | Sum a b => exp_of a * exp_of b
  end.
Lemma exp_is : forall a x, x = size a -> exp x = exp_of a.
Proof.
  intros a x ->. induction a as [x| | | |a A|a A b B]; simpl; try reflexivity.
  - exact exp_0.
  - now rewrite exp_Ropp, A.
  - now rewrite exp_plus, A, B.
Qed.
Lemma exp_differs : forall x, exp x <> 0.
Proof. intros x E. pose proof (exp_pos x). lra. Qed.
(* By `E : argument = sum of phases`, what exp of the argument is. *)
Ltac expand_exponential E X :=
  match type of E with
  | ?x = ?y => let a := angle_of y in pose proof (exp_is a x E) as X; cbv beta iota delta [exp_of] in X
  end.

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
Ltac2 forget () := Std.clear (List.map name (List.filter is_said (Control.hyps ()))).
Ltac forget := ltac2:(Control.enter forget).
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

(* Of what is read and what is said, the former is to be computed. *)
Strategy expand
  [Fractions.value BinList.nth BinList.jump Fractions.where_equal Fractions.on_circles Fractions.where_nonzero vmap].

(* What stands above the goal and is of use: values of letters, cosines and sines on circles, what is not 0. *)
Ltac2 value_in (said : constr) : (constr * constr) list :=
  match! said with
  | cos _ = ?e => [(part said 1, e)]
  | sin _ = ?e => [(part said 1, e)]
  | @eq R ?x ?e => match Constr.Unsafe.kind x with Constr.Unsafe.Var _ => [(x, e)] | _ => [] end
  | _ => []
  end.
Ltac2 circle_in (said : constr) : (constr * constr) list :=
  match! said with
  | ?c * ?d = 1 + -1 * (?s * _) => if Constr.equal c d then [(c, s)] else []
  | _ => []
  end.
Ltac2 nonzero_in (said : constr) : (constr * constr) list := match! said with ?d <> 0 => [(d, d)] | _ => [] end.
Ltac2 decided_by_fractions () :=
  let hyps := Control.hyps () in
  let r := constr:(R) in
  let e := constr:(Fractions.expression) in
  let words := [
    word constr:(Rmult) constr:(Fractions.Times) 2; word constr:(Rplus) constr:(Fractions.Plus) 2;
    word constr:(IZR) constr:(Fractions.Number) 0; word constr:(Rinv) constr:(Fractions.Inverse) 1;
    word constr:(pow) constr:(Fractions.Power) 1; word constr:(Ropp) constr:(Fractions.Opposite) 1;
    word constr:(Rminus) constr:(Fractions.Minus) 2; word constr:(Rdiv) constr:(Fractions.Over) 2] in
  let variables := numbers_among hyps in
  let letter k := applied constr:(Fractions.Letter) [positive k] in
  let values := List.mapi (fun k _ => letter (Int.add k 1)) variables in
  let letters := { count := List.length variables; found := List.rev (List.map Control.hyp variables); letter := letter } in
  let read t := with_variables variables values (reading words letters t) in
  let place t := part (read t) 0 in
  let those find :=
    List.flat_map (fun h => List.map (fun u => let (a, b) := u in (Control.hyp (name h), a, b)) (find (says h))) hyps in
  let known := those value_in in
  let circles := those circle_in in
  let nonzeros := those nonzero_in in
  let pair_of a b x y := applied constr:(@pair) [a; b; x; y] in
  let p := constr:(BinNums.positive) in
  let gs := listed constr:((BinNums.positive * Fractions.expression)%type)
    (List.map (fun u => let (_, c, v) := u in pair_of p e (place c) (read v)) known) in
  let cs := listed constr:((BinNums.positive * BinNums.positive)%type)
    (List.map (fun u => let (_, c, s) := u in pair_of p p (place c) (place s)) circles) in
  let es := listed e (List.map (fun u => let (_, d, _) := u in read d) nonzeros) in
  let goal := Control.goal () in
  let type := part goal 0 in
  let a := each_number read (other_type r e) (part goal 1) in
  let b := each_number read (other_type r e) (part goal 2) in
  let decided test lemma sizes :=
    let what := List.append [gs; cs; es] (List.append sizes [a; b]) in
    let uses := List.map (fun u => let (h, _, _) := u in h) (List.append known (List.append circles nonzeros)) in
    let xs := listed r (List.rev (letters.(found))) in
    Std.exact_no_check
      (applied lemma (List.append (xs :: what) (passed (applied test what) :: uses))) in
  if Constr.equal type r then decided constr:(Fractions.identical) constr:(Fractions.identical_ok) []
  else
    decided constr:(Fractions.identical_m) constr:(Fractions.identical_m_ok) [part type 1; part (part type 0) 1].
Ltac by_fractions := ltac2:(Control.enter decided_by_fractions).

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
