(* Signs of expressions between given bounds, in interval arithmetic on whole numbers: no axiom but those of
   the real numbers. *)
From Stickslip Require Export Algebra.
From Stickslip Require Import Programs.
From Interval.Float Require Import Basic Specific_ops Specific_stdz.
From Interval.Interval Require Import Float_full.
From Interval.Eval Require Import Tree Prog Reify.
From Interval.Tactics Require Import Interval_helper.

(* Not by the tactics of that library, which take several times as long to read an expression as to enclose it,
   and to load. *)
Module Enclosures.
Module BinaryIntegers := SpecificFloat StdZRadix2.
Module Intervals := FloatIntervalFull BinaryIntegers.
Module Helper := IntervalTacticAux Intervals.

(* What is assumed of a variable. *)
Inductive bound (A : Type) : Type :=
  At_most (a : A) | Below (a : A) | At_least (a : A) | Above (a : A) | Between (a b : A).
Arguments At_most {A}.
Arguments Below {A}.
Arguments At_least {A}.
Arguments Above {A}.
Arguments Between {A}.
Definition hypothesis (h : bound expr) : hyp :=
  match h with
  | At_most a => Hle true true a
  | Below a => Hle true false a
  | At_least a => Hge true true a
  | Above a => Hge true false a
  | Between a b => Hlele true true a b
  end.
Definition assuming (hs : list (list (bound expr))) (l : list R) (G : Prop) : Prop :=
  eval_hyps (map (map hypothesis) hs) l G.

Definition plus (a b : expr) := Ebinary Add a b.
Definition times (a b : expr) := Ebinary Mul a b.
Definition minus (a b : expr) := Ebinary Sub a b.
Definition over (a b : expr) := Ebinary Div a b.
Definition opposite (a : expr) := Eunary Neg a.
Definition inverse (a : expr) := Eunary Inv a.
Definition number (z : Z) := Econst (Int z).
Definition to_power (a : expr) (n : nat) := Eunary (PowerInt (Z.of_nat n)) a.
Definition cosine (a : expr) := Eunary Cos a.
Definition sine (a : expr) := Eunary Sin a.
Definition modulus (a : expr) := Eunary Abs a.

(* Differences and quotients, which have tighter bounds, or are computed sooner. *)
Definition tidy_plus (a b : expr) : expr :=
  match b with
  | Ebinary Mul (Econst (Int (-1))) b => Ebinary Sub a b
  | _ => Ebinary Add a b
  end.
Definition tidy_times (a b : expr) : expr :=
  match b with Eunary Inv b => Ebinary Div a b | _ => Ebinary Mul a b end.
Fixpoint tidy (e : expr) : expr :=
  match e with
  | Ebinary Add a b => tidy_plus (tidy a) (tidy b)
  | Ebinary Mul a b => tidy_times (tidy a) (tidy b)
  | Ebinary o a b => Ebinary o (tidy a) (tidy b)
  | Eunary o a => Eunary o (tidy a)
  | _ => e
  end.
Lemma tidy_plus_ok : forall l a b, eval (tidy_plus a b) l = eval a l + eval b l.
Proof.
  intros l a b. destruct b as [|?|?|o b1 b2]; try reflexivity. destruct o; try reflexivity.
  destruct b1 as [|n|?|?]; try reflexivity. destruct n as [z| |]; try reflexivity.
  destruct z as [| |p]; try reflexivity. destruct p; try reflexivity. simpl. ring.
Qed.
Lemma tidy_times_ok : forall l a b, eval (tidy_times a b) l = eval a l * eval b l.
Proof.
  intros l a b. destruct b as [|?|o b|?]; try reflexivity. now destruct o.
Qed.
Lemma tidy_ok : forall l e, eval (tidy e) l = eval e l.
Proof.
  induction e as [| |o a A|o a A b B]; try reflexivity; [simpl; now rewrite A|].
  destruct o; simpl; rewrite ?tidy_plus_ok, ?tidy_times_ok, A, B; reflexivity.
Qed.

(* How precise, how often the variables with these places are halved, and what is to be shown of the expression. *)
Definition enclosed (prec : Z) (depth : nat) (halved : list nat) (hs : list (list (bound expr))) (e : expr)
    (g : gol) : bool :=
  match program_of (tidy e) (length hs) with
  | Some (prog, consts) => Helper.eval_bisect prec depth halved (map (map hypothesis) hs) prog consts g
  | None => false
  end.
Lemma assuming_weaker : forall (G H : Prop), (G -> H) -> forall hs l, assuming hs l G -> assuming hs l H.
Proof.
  intros G H I hs. unfold assuming. induction hs as [|h hs J]; intros [|x l]; simpl; try easy.
  induction h as [|b h K]; simpl; [apply J|]. intros E F. exact (K (E F)).
Qed.
Lemma as_long : forall (G : Prop) hs l, (length hs = length l -> assuming hs l G) -> assuming hs l G.
Proof.
  unfold assuming. induction hs as [|h hs J]; intros [|x l] E; simpl in *; try easy; [now apply E|].
  assert (F : length hs = length l -> eval_hyps_aux (map hypothesis h) x (eval_hyps (map (map hypothesis) hs) l G))
    by (intros L; apply E; now rewrite L).
  clear E. induction h as [|b h K]; simpl in *; [now apply J|]. intros B. apply K. intros L. now apply F.
Qed.
Lemma enclosed_ok : forall prec depth halved hs l e g,
  enclosed prec depth halved hs e g = true -> assuming hs l (eval_goal g (eval e l)).
Proof.
  intros prec depth halved hs l e g E. apply as_long. intros L. unfold enclosed in E. rewrite L in E.
  destruct (program_of (tidy e) (length l)) as [[prog consts]|] eqn:X; [|discriminate].
  rewrite <- tidy_ok, <- (program_of_ok _ _ _ _ X). now apply (Helper.eval_bisect_correct prec depth halved).
Qed.

Definition is_less prec depth halved hs a b :=
  enclosed prec depth halved hs (plus a (times (number (-1)) b)) (Glt (number 0)).
Definition is_at_most prec depth halved hs a b :=
  enclosed prec depth halved hs (plus a (times (number (-1)) b)) (Gle true (number 0)).
Definition is_other prec depth halved hs a b :=
  enclosed prec depth halved hs (plus a (times (number (-1)) b)) (Gne true (number 0)).
Definition is_short prec depth halved hs a b := enclosed prec depth halved hs a (Gabsle true b).
Lemma less_enclosed : forall prec depth halved hs l a b,
  is_less prec depth halved hs a b = true -> assuming hs l (eval a l < eval b l).
Proof.
  intros prec depth halved hs l a b E. apply (enclosed_ok _ _ _ _ l) in E. revert E. apply assuming_weaker.
  simpl. lra.
Qed.
Lemma at_most_enclosed : forall prec depth halved hs l a b,
  is_at_most prec depth halved hs a b = true -> assuming hs l (eval a l <= eval b l).
Proof.
  intros prec depth halved hs l a b E. apply (enclosed_ok _ _ _ _ l) in E. revert E. apply assuming_weaker.
  simpl. lra.
Qed.
Lemma other_enclosed : forall prec depth halved hs l a b,
  is_other prec depth halved hs a b = true -> assuming hs l (eval a l <> eval b l).
Proof.
  intros prec depth halved hs l a b E. apply (enclosed_ok _ _ _ _ l) in E. revert E. apply assuming_weaker.
  simpl. lra.
Qed.
Lemma short_enclosed : forall prec depth halved hs l a b,
  is_short prec depth halved hs a b = true -> assuming hs l (Rabs (eval a l) <= eval b nil).
Proof. intros prec depth halved hs l a b E. exact (enclosed_ok _ _ _ _ l _ _ E). Qed.

(* Between two numbers. *)
Definition is_between prec depth halved hs a (b : expr * expr) :=
  enclosed prec depth halved hs a (Glele (fst b) (snd b)).
Definition is_inside prec depth halved hs a (b : expr * expr) :=
  (enclosed prec depth halved hs a (Ggt (fst b)) && enclosed prec depth halved hs a (Glt (snd b)))%bool.
Lemma assuming_both : forall (G H : Prop) hs l,
  assuming hs l G -> assuming hs l H -> assuming hs l (G /\ H).
Proof.
  intros G H hs. unfold assuming. induction hs as [|h hs I]; intros [|x l]; simpl; try easy.
  induction h as [|b h K]; simpl; [apply I|]. intros A B E. exact (K (A E) (B E)).
Qed.
Lemma between_enclosed : forall prec depth halved hs l a b,
  is_between prec depth halved hs a b = true ->
  assuming hs l (eval (fst b) nil <= eval a l <= eval (snd b) nil).
Proof. intros prec depth halved hs l a b E. exact (enclosed_ok _ _ _ _ l _ _ E). Qed.
Lemma inside_enclosed : forall prec depth halved hs l a b,
  is_inside prec depth halved hs a b = true ->
  assuming hs l (eval (fst b) nil < eval a l < eval (snd b) nil).
Proof.
  intros prec depth halved hs l a b E. apply andb_prop in E as [E F].
  apply assuming_both; [exact (enclosed_ok _ _ _ _ l _ _ E) | exact (enclosed_ok _ _ _ _ l _ _ F)].
Qed.

(* Of what is read and what is said, the former is to be computed. *)
Strategy expand
  [eval nullary_real unary_real binary_real powerRZ eval_hyps eval_hyps_aux eval_hyp hypothesis assuming plus times
   minus over opposite inverse number to_power cosine sine modulus].

(* The bounds of variables by numbers, before what is to be shown, variable by variable; nothing else is known. *)
Ltac closed c :=
  tryif match goal with x : R |- _ => lazymatch c with context [x] => idtac end end then fail else idtac.
Ltac revert_bounds x :=
  repeat match goal with
         | H : x <= ?c |- _ => closed c; revert H
         | H : x < ?c |- _ => closed c; revert H
         | H : ?c <= x |- _ => closed c; revert H
         | H : ?c < x |- _ => closed c; revert H
         | H : ?c <= x <= ?d |- _ => closed c; closed d; revert H
         end.
Ltac revert_all_bounds xs :=
  lazymatch xs with nil => idtac | cons ?x ?xs => revert_all_bounds xs; revert_bounds x end.
Ltac bounds_in G xs :=
  lazymatch xs with
  | nil =>
      lazymatch G with
      | ?c <= ?a /\ _ <= ?d => constr:((@nil (list (bound R)), (a, (c, d))))
      | ?c < ?a /\ _ < ?d => constr:((@nil (list (bound R)), (a, (c, d))))
      | Rabs ?a <= ?b => constr:((@nil (list (bound R)), (a, b)))
      | ?a <= ?b => constr:((@nil (list (bound R)), (a, b)))
      | ?a < ?b => constr:((@nil (list (bound R)), (a, b)))
      | ?a = ?b -> False => constr:((@nil (list (bound R)), (a, b)))
      | ?a <> ?b => constr:((@nil (list (bound R)), (a, b)))
      end
  | cons ?x ?rest =>
      let more G b :=
        let t := bounds_in G xs in
        lazymatch t with pair (cons ?h ?hs) ?c => constr:((cons (cons b h) hs, c)) end in
      lazymatch G with
      | x <= ?c -> ?G => more G constr:(At_most c)
      | x < ?c -> ?G => more G constr:(Below c)
      | ?c <= x -> ?G => more G constr:(At_least c)
      | ?c < x -> ?G => more G constr:(Above c)
      | ?c <= x <= ?d -> ?G => more G constr:(Between c d)
      | _ =>
          let t := bounds_in G rest in
          lazymatch t with pair ?hs ?c => constr:((cons (@nil (bound R)) hs, c)) end
      end
  end.
Ltac applied_to_places xs k t :=
  lazymatch xs with
  | nil => t
  | cons _ ?rest => let t := applied_to_places rest (S k) t in constr:(t (Evar k))
  end.
(* A term of numbers as one of expressions. *)
Ltac read t :=
  let t := eval pattern R, Rplus, Rmult, Rminus, Rdiv, Ropp, Rinv, IZR, pow, cos, sin, PI, Rabs in t in
  lazymatch t with
  | ?f _ _ _ _ _ _ _ _ _ _ _ _ _ =>
      let t := constr:(f expr plus times minus over opposite inverse number to_power cosine sine (Econst Pi) modulus) in
      eval cbv beta in t
  end.
(* A function of several numbers. *)
Ltac of_variables t k :=
  lazymatch type of t with
  | expr -> _ => let t := constr:(t (Evar k)) in let t := eval cbv beta in t in of_variables t (S k)
  | _ => t
  end.
Ltac function_read t := let t := read t in of_variables t O.
Ltac place_of x xs k := lazymatch xs with cons x _ => k | cons _ ?rest => place_of x rest (S k) end.
(* Hands on the variables, and what is read. *)
Ltac with_expressions go :=
  let xs := numbers_in_context (@nil R) in
  revert_all_bounds xs; forget;
  lazymatch goal with
  | |- ?G =>
      let t := bounds_in G xs in
      let t := abstracted xs t in
      let t := read t in
      let t := applied_to_places xs O t in
      let t := eval cbv beta in t in
      lazymatch t with pair ?hs (pair ?a ?b) => go xs hs a b end
  end.
(* The same of a number that was read before: E says that it is the value of an expression. *)
Ltac with_known_expression E go :=
  lazymatch type of E with
  | ?t = eval ?e ?xs =>
      revert_all_bounds xs; forget;
      lazymatch goal with
      | |- ?G =>
          let u := eval pattern t in G in
          lazymatch u with
          | ?P _ =>
              refine (eq_ind_r P _ E); cbv beta;
              lazymatch goal with
              | |- ?G =>
                  let t := bounds_in G xs in
                  let t := eval pattern (eval e xs) in t in
                  lazymatch t with
                  | ?f _ =>
                      let f := read f in
                      let t := eval cbv beta in (f e) in
                      lazymatch t with pair ?hs (pair ?a ?b) => go xs hs a b end
                  end
              end
          end
      end
  end.
Ltac conclusion G :=
  lazymatch G with
  | (?a = ?b -> False) => G
  | _ -> ?G => conclusion G
  | _ => G
  end.
Ltac by_test prec depth halved xs hs a b :=
  let G := lazymatch goal with |- ?G => conclusion G end in
  let found lemma test :=
    abstract (cut (test prec depth halved hs a b = true);
              [exact_no_check (lemma prec depth halved hs xs a b) | vm_cast_no_check (@eq_refl bool true)]) in
  lazymatch G with
  | _ <= _ /\ _ <= _ => found between_enclosed is_between
  | _ < _ /\ _ < _ => found inside_enclosed is_inside
  | Rabs _ <= _ => found short_enclosed is_short
  | _ <= _ => found at_most_enclosed is_at_most
  | _ < _ => found less_enclosed is_less
  | _ => found other_enclosed is_other
  end.
End Enclosures.

Lemma by_distance : forall c w x : R, Rabs (x + -1 * c) <= w -> c + -1 * w <= x <= c + w.
Proof. intros c w x L. unfold Rabs in L. destruct (Rcase_abs _); lra. Qed.

Ltac enclosed xs hs a b :=
  first [Enclosures.by_test 60%Z O (@nil nat) xs hs a b | Enclosures.by_test 128%Z O (@nil nat) xs hs a b].
(* The same where a variable has a wide range: in parts of it, of which a few do mostly. *)
Ltac enclosed_along x xs hs a b :=
  let k := Enclosures.place_of x xs O in
  first [ Enclosures.by_test 30%Z 4%nat (cons k nil) xs hs a b
        | Enclosures.by_test 40%Z 12%nat (cons k nil) xs hs a b ].
Ltac by_enclosure := Enclosures.with_expressions enclosed.
Ltac by_enclosure_along x := Enclosures.with_expressions ltac:(enclosed_along x).
(* A function of several numbers as an expression. *)
Ltac number_read f := let f := reduced_matrices f in let t := Enclosures.function_read f in exact t.
Ltac by_known_enclosure E := Enclosures.with_known_expression E enclosed.
Ltac by_known_enclosure_along E x := Enclosures.with_known_expression E ltac:(enclosed_along x).
