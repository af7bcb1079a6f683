(* Signs of expressions between given bounds, in interval arithmetic on whole numbers: no axiom but those of
   the real numbers. *)
From Stickslip Require Export Algebra.
From Stickslip Require Import Programs Reading.
From Interval.Float Require Import Basic Specific_ops Specific_stdz.
From Interval.Interval Require Import Float_full.
From Interval.Eval Require Import Tree Prog Reify.
From Interval.Tactics Require Import Interval_helper.
From Ltac2 Require Import Ltac2.
Set Default Proof Mode "Classic".

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
Definition exponential (a : expr) := Eunary Exp a.
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
   minus over opposite inverse number to_power cosine sine exponential modulus].

Ltac2 words () := [
  word constr:(Rmult) constr:(times) 2; word constr:(Rplus) constr:(plus) 2; word constr:(IZR) constr:(number) 0;
  word constr:(Rinv) constr:(inverse) 1; word constr:(cos) constr:(cosine) 1; word constr:(sin) constr:(sine) 1;
  word constr:(PI) constr:(Econst Pi) 0; word constr:(pow) constr:(to_power) 1; word constr:(Ropp) constr:(opposite) 1;
  word constr:(Rminus) constr:(minus) 2; word constr:(Rdiv) constr:(over) 2; word constr:(Rabs) constr:(modulus) 1;
  word constr:(exp) constr:(exponential) 1].
Ltac2 no_letters () := { count := 0; found := []; letter := fun _ => Control.zero Not_found }.
Ltac2 rec natural (k : int) : constr := if Int.equal k 0 then constr:(O) else applied constr:(S) [natural (Int.sub k 1)].
Ltac2 places (xs : 'a list) : constr list := List.mapi (fun k _ => applied constr:(Evar) [natural k]) xs.
(* Numbers, and functions of several numbers, of which there are `depth`. *)
Ltac2 rec read_function (depth : int) (t : constr) : constr :=
  match Constr.Unsafe.kind t with
  | Constr.Unsafe.Lambda _ t => read_function (Int.add depth 1) t
  | _ =>
      let read t := reading (words ()) (no_letters ()) t in
      Constr.Unsafe.substnl (List.rev (places (List.init depth (fun _ => ())))) 0
        (each_number read (other_type constr:(R) constr:(expr)) t)
  end.
Ltac read_exactly t := let f := ltac2:(t |- Std.exact_no_check (read_function 0 (Option.get (Ltac1.to_constr t)))) in f t.

(* Whether the tests pass: what stands in goal and hypotheses, which bound variables by numbers, is read; a number that
   is `eval e xs` has been. *)
Ltac2 rec each (f : constr -> 'a) (xs : constr) : 'a list :=
  match! xs with
  | nil => []
  | ?x :: ?xs => f x :: each f xs
  end.
Ltac2 variable (x : constr) : ident :=
  match Constr.Unsafe.kind x with Constr.Unsafe.Var x => x | _ => Control.zero Not_found end.
Ltac2 by_tests (order : ident list) (tests : (constr * constr) list) (halved : constr) : unit :=
  let hyps := Control.hyps () in
  let e := constr:(expr) in
  let values := places order in
  let read t :=
    match! t with
    | eval ?e _ => e
    | _ => with_variables order values (reading (words ()) (no_letters ()) t)
    end in
  let is_closed t := Constr.equal t (Constr.Unsafe.closenl order 1 t) in
  let bound_of x h :=
    let is_x t := match Constr.Unsafe.kind t with Constr.Unsafe.Var y => Ident.equal x y | _ => false end in
    let of_one bound t u :=
      if is_x t then if is_closed u then Some (name h, applied bound [e; read u]) else None else None in
    match! (says h) with
    | ?c <= ?y /\ ?z <= ?d =>
        if is_x y then
          if is_closed c then if is_closed d then Some (name h, applied constr:(@Between) [e; read c; read d]) else None
          else None
        else None
    | ?a <= ?b =>
        match of_one constr:(@At_most) a b with Some r => Some r | None => of_one constr:(@At_least) b a end
    | ?a < ?b => match of_one constr:(@Below) a b with Some r => Some r | None => of_one constr:(@Above) b a end
    | _ => None
    end in
  let said := List.filter is_said hyps in
  let bounds :=
    List.map (fun x => List.flat_map (fun h => match bound_of x h with Some r => [r] | None => [] end) said) order in
  let uses := List.map (fun r => let (x, _) := r in x) (List.flatten bounds) in
  let bound := applied constr:(bound) [e] in
  let hs := listed (applied constr:(list) [bound])
    (List.map (fun rs => listed bound (List.map (fun r => let (_, b) := r in b) rs)) bounds) in
  let xs := listed constr:(R) (List.map Control.hyp order) in
  Std.clear (List.filter (fun x => if List.mem Ident.equal x uses then false else true) (List.map name said));
  let known := List.map Control.hyp uses in
  let tested test lemma a b :=
    let rec tried tests :=
      match tests with
      | [] => Control.zero Not_found
      | one :: tests =>
          let (prec, depth) := one in
          let proof := applied lemma (List.append [prec; depth; halved; hs; xs; a; b]
            (passed (applied test [prec; depth; halved; hs; a; b]) :: known)) in
          Control.plus
            (fun () => let f := ltac1:(t |- abstract (exact_no_check t)) in f (Ltac1.of_constr proof))
            (fun _ => tried tests)
      end in
    Control.once (fun () => tried tests) in
  let two a b := applied constr:(@pair) [e; e; read a; read b] in
  match! goal with
  | [|- ?c <= ?a /\ _ <= ?d] => tested constr:(is_between) constr:(between_enclosed) (read a) (two c d)
  | [|- ?c < ?a /\ _ < ?d] => tested constr:(is_inside) constr:(inside_enclosed) (read a) (two c d)
  | [|- Rabs ?a <= ?b] => tested constr:(is_short) constr:(short_enclosed) (read a) (read b)
  | [|- ?a <= ?b] => tested constr:(is_at_most) constr:(at_most_enclosed) (read a) (read b)
  | [|- ?a < ?b] => tested constr:(is_less) constr:(less_enclosed) (read a) (read b)
  | [|- ?a = ?b -> False] => tested constr:(is_other) constr:(other_enclosed) (read a) (read b)
  | [|- ?a <> ?b] => tested constr:(is_other) constr:(other_enclosed) (read a) (read b)
  end.
(* A precision that mostly does, and a larger one. Where a variable has a wide range: in parts of it, of which a few do
   mostly. *)
Ltac2 enclosed (order : ident list) : unit :=
  by_tests order [(constr:(60%Z), constr:(O)); (constr:(128%Z), constr:(O))] constr:(@nil nat).
Ltac2 enclosed_along (x : constr) (order : ident list) : unit :=
  let rec place xs k :=
    match xs with
    | [] => Control.zero Not_found
    | y :: xs => if Ident.equal (variable x) y then k else place xs (Int.add k 1)
    end in
  by_tests order [(constr:(30%Z), constr:(4%nat)); (constr:(40%Z), constr:(12%nat))]
    (listed constr:(nat) [natural (place order 0)]).
Ltac2 any_order () : ident list := numbers_among (Control.hyps ()).
(* E says of a number of which expression it is the value. *)
Ltac2 order_of (known : constr) : ident list :=
  match! (Constr.type known) with _ = eval _ ?xs => each variable xs end.
Ltac known_to_be E :=
  lazymatch type of E with
  | ?t = _ =>
      lazymatch goal with
      | |- ?G => let u := eval pattern t in G in lazymatch u with ?P _ => refine (eq_ind_r P _ E); cbv beta end
      end
  end.
End Enclosures.

Lemma by_distance : forall c w x : R, Rabs (x + -1 * c) <= w -> c + -1 * w <= x <= c + w.
Proof. intros c w x L. unfold Rabs in L. destruct (Rcase_abs _); lra. Qed.

Ltac by_enclosure := ltac2:(Control.enter (fun () => Enclosures.enclosed (Enclosures.any_order ()))).
Ltac by_enclosure_along x :=
  let f := ltac2:(x |- Enclosures.enclosed_along (Option.get (Ltac1.to_constr x)) (Enclosures.any_order ())) in
  f constr:(x).
(* A function of several numbers as an expression. *)
Ltac number_read f := let f := reduced_matrices f in Enclosures.read_exactly f.
Ltac by_known_enclosure E :=
  Enclosures.known_to_be E;
  let f := ltac2:(known |- Enclosures.enclosed (Enclosures.order_of (Option.get (Ltac1.to_constr known)))) in
  f constr:(E).
Ltac by_known_enclosure_along E x :=
  Enclosures.known_to_be E;
  let f := ltac2:(known x |- Enclosures.enclosed_along (Option.get (Ltac1.to_constr x))
    (Enclosures.order_of (Option.get (Ltac1.to_constr known)))) in
  f constr:(E) constr:(x).
