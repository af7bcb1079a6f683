(* Truth tables: classical logic of sentences. A sentence over letters is decided letter by letter, each where it
   is met first_letter, with what it says after that made short. *)
From Coq Require Import Classical List PeanoNat.

Inductive sentence : Set :=
  Letter (n : nat) | Yes | No | Both (a b : sentence) | Either (a b : sentence) | Then (a b : sentence).
Fixpoint says (l : list Prop) (s : sentence) : Prop :=
  match s with
  | Letter n => nth n l False
  | Yes => True
  | No => False
  | Both a b => says l a /\ says l b
  | Either a b => says l a \/ says l b
  | Then a b => says l a -> says l b
  end.
Definition short_both (a b : sentence) : sentence :=
  match a, b with Yes, _ => b | _, Yes => a | No, _ | _, No => No | _, _ => Both a b end.
Definition short_either (a b : sentence) : sentence :=
  match a, b with No, _ => b | _, No => a | Yes, _ | _, Yes => Yes | _, _ => Either a b end.
Definition short_then (a b : sentence) : sentence :=
  match a, b with Yes, _ => b | No, _ | _, Yes => Yes | _, _ => Then a b end.
(* With a value for a letter. *)
Fixpoint valued (n : nat) (v : sentence) (s : sentence) : sentence :=
  match s with
  | Letter m => if Nat.eqb m n then v else s
  | Both a b => short_both (valued n v a) (valued n v b)
  | Either a b => short_either (valued n v a) (valued n v b)
  | Then a b => short_then (valued n v a) (valued n v b)
  | _ => s
  end.
Fixpoint first_letter (s : sentence) : nat :=
  match s with
  | Letter n => n
  | Both a b | Either a b | Then a b => first_letter a
  | _ => O
  end.
(* Whether it holds whatever its letters are, of which there are so many. *)
Fixpoint certain (letters : nat) (s : sentence) : bool :=
  match s, letters with
  | Yes, _ => true
  | No, _ | _, O => false
  | _, S fewer =>
      if certain fewer (valued (first_letter s) Yes s) then certain fewer (valued (first_letter s) No s) else false
  end.

Lemma says_valued : forall l n v s, (nth n l False <-> says l v) -> (says l (valued n v s) <-> says l s).
Proof.
  intros l n v s E. induction s as [m| | |a A b B|a A b B|a A b B]; simpl; try tauto.
  - destruct (Nat.eqb_spec m n) as [->|]; simpl; tauto.
  - rewrite <- A, <- B. destruct (valued n v a), (valued n v b); simpl; tauto.
  - rewrite <- A, <- B. destruct (valued n v a), (valued n v b); simpl; tauto.
  - rewrite <- A, <- B. destruct (valued n v a), (valued n v b); simpl; tauto.
Qed.
Lemma truth_table : forall l letters s, certain letters s = true -> says l s.
Proof.
  intros l letters. induction letters as [|fewer I]; intros s C.
  - destruct s; simpl in C; try discriminate. exact Logic.I.
  - assert (C' : s = Yes \/ certain fewer (valued (first_letter s) Yes s) = true /\
                            certain fewer (valued (first_letter s) No s) = true).
    { destruct s; [right | now left | discriminate | right | right | right]; simpl certain in C;
        match type of C with (if ?c then _ else _) = true => destruct c eqn:D; [now split | discriminate] end. }
    destruct C' as [->|[Y N]]; [exact Logic.I|]. apply I in Y, N.
    destruct (classic (nth (first_letter s) l False)) as [H|H].
    + apply (says_valued l (first_letter s) Yes s) in Y; [exact Y | simpl; tauto].
    + apply (says_valued l (first_letter s) No s) in N; [exact N | simpl; tauto].
Qed.

(* Of what is said in many parts, what comes after some of them. *)
Fixpoint said_before (parts : list Prop) (rest : Prop) : Prop :=
  match parts with nil => rest | A :: parts => A /\ said_before parts rest end.
Lemma said_after : forall parts rest, said_before parts rest -> rest.
Proof. induction parts as [|A parts H]; intros rest; [trivial|]. intros [_ W]. now apply H. Qed.
