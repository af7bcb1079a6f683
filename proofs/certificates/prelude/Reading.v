(* Terms of numbers, read as expressions in one pass: to abstract one constant after the other, as Coq's tactics do,
   types the whole term each time. What comes out is a proposal, which Coq's kernel compares with what was read. *)
From Coq Require Import Reals.
From Ltac2 Require Import Ltac2.
Set Default Proof Mode "Classic".

Ltac2 applied (f : constr) (xs : constr list) : constr := Constr.Unsafe.make (Constr.Unsafe.App f (Array.of_list xs)).
(* What a function is called with; its arguments. *)
Ltac2 parts (t : constr) : constr array :=
  match Constr.Unsafe.kind t with Constr.Unsafe.App _ xs => xs | _ => Array.empty () end.
Ltac2 part (t : constr) (i : int) : constr := Array.get (parts t) i.

(* Of what stands above a goal: names, what they are, which are numbers, whether it is something that is known. *)
Ltac2 name h := let (x, _, _) := h in x.
Ltac2 says h := let (_, _, t) := h in t.
Ltac2 numbers_among hyps := List.map name (List.filter (fun h => Constr.equal (says h) constr:(R)) hyps).
Ltac2 is_said h := Constr.equal (Constr.type (says h)) constr:(Prop).

(* A constant, what becomes of it, and how many of its arguments are numbers, the first ones. *)
Ltac2 Type word := { said : constr; meant : constr; numbers : int }.
Ltac2 word (said : constr) (meant : constr) (numbers : int) : word := { said := said; meant := meant; numbers := numbers }.
Ltac2 rec meaning (words : word list) (c : constr) : word option :=
  match words with
  | [] => None
  | w :: words => if Constr.equal (w.(said)) c then Some w else meaning words c
  end.

(* What is no word is a letter: those found so far, the last one first. *)
Ltac2 Type letters := { mutable count : int; mutable found : constr list; letter : int -> constr }.
Ltac2 letter_for (letters : letters) (t : constr) : constr :=
  let rec place xs k :=
    match xs with
    | [] => letters.(found) := t :: letters.(found);
        letters.(count) := Int.add (letters.(count)) 1;
        letters.(count)
    | x :: xs => if Constr.equal x t then k else place xs (Int.sub k 1)
    end in
  letters.(letter) (place (letters.(found)) (letters.(count))).
Ltac2 rec reading (words : word list) (letters : letters) (t : constr) : constr :=
  match Constr.Unsafe.kind t with
  | Constr.Unsafe.App f xs =>
      match meaning words f with
      | Some w =>
          let ys := Array.copy xs in
          let rec go i :=
            if Int.equal i (w.(numbers)) then ()
            else (Array.set ys i (reading words letters (Array.get xs i)); go (Int.add i 1)) in
          go 0;
          Constr.Unsafe.make (Constr.Unsafe.App (w.(meant)) ys)
      | None => letter_for letters t
      end
  | Constr.Unsafe.Constant _ _ =>
      match meaning words t with Some w => w.(meant) | None => letter_for letters t end
  | Constr.Unsafe.Var _ => t
  | Constr.Unsafe.Rel _ => t
  | _ => letter_for letters t
  end.
(* Variables are left as they are, and become expressions all at once. *)
Ltac2 with_variables (names : ident list) (values : constr list) (t : constr) : constr :=
  Constr.Unsafe.substnl values 0 (Constr.Unsafe.closenl names 1 t).

Ltac2 rec other_type (from : constr) (to : constr) (t : constr) : constr :=
  match Constr.Unsafe.kind t with
  | Constr.Unsafe.App f xs => Constr.Unsafe.make (Constr.Unsafe.App f (Array.map (other_type from to) xs))
  | _ => if Constr.equal t from then to else t
  end.
(* Numbers in tuples and lists. *)
Ltac2 rec each_number (read : constr -> constr) (type : constr -> constr) (t : constr) : constr :=
  let rest types :=
    Constr.Unsafe.make (Constr.Unsafe.App
      (match Constr.Unsafe.kind t with Constr.Unsafe.App f _ => f | _ => t end)
      (Array.mapi (fun i x => if Int.lt i types then type x else each_number read type x) (parts t))) in
  match! t with
  | pair _ _ => rest 2
  | cons _ _ => rest 1
  | nil => rest 1
  | tt => t
  | _ => read t
  end.

Ltac2 rec listed (type : constr) (xs : constr list) : constr :=
  match xs with
  | [] => applied constr:(@nil) [type]
  | x :: xs => applied constr:(@cons) [type; x; listed type xs]
  end.
Ltac2 rec positive (k : int) : constr :=
  if Int.equal k 1 then constr:(xH)
  else
    let half := Int.div k 2 in
    applied (if Int.equal (Int.add half half) k then constr:(xO) else constr:(xI)) [positive half].

(* A proof that the test is true: it is. *)
Ltac2 passed (test : constr) : constr :=
  match Constr.Unsafe.kind constr:(@eq_refl bool true <: true = true) with
  | Constr.Unsafe.Cast proof by_machine _ =>
      Constr.Unsafe.make (Constr.Unsafe.Cast proof by_machine (applied constr:(@eq bool) [test; constr:(true)]))
  | _ => Control.throw Not_found
  end.
