(* Expressions as programs, which compute each of their parts once: what interval arithmetic runs. As that library's
   own do; there, a part is looked for among all parts before it, which takes several times as long as to enclose the
   expression. *)
From Coq Require Import Reals List Lia FMapPositive.
From Interval.Eval Require Import Tree Prog.
Open Scope R_scope.

(* A number that the program starts with, or the k-th that it computes; what it computes of such. *)
Inductive place := Given (i : positive) | Computed (k : positive).
Inductive step := One (o : unary_op) (p : place) | Two (o : binary_op) (p q : place).

Definition same_place (p q : place) : bool :=
  match p, q with
  | Given i, Given j | Computed i, Computed j => Pos.eqb i j
  | _, _ => false
  end.
Lemma same_place_ok p q : same_place p q = true -> p = q.
Proof. destruct p, q; try discriminate; intros E; apply Pos.eqb_eq in E; now subst. Qed.
Definition same_step (s t : step) : bool :=
  match s, t with
  | One o p, One o' q => if same_place p q then internal_unary_op_beq o o' else false
  | Two o p q, Two o' p' q' =>
      if same_place p p' then if same_place q q' then internal_binary_op_beq o o' else false else false
  | _, _ => false
  end.
Lemma same_step_ok s t : same_step s t = true -> s = t.
Proof.
  destruct s as [o p|o p q], t as [o' p'|o' p' q']; try discriminate; simpl;
    destruct (same_place p p') eqn:E; try discriminate; apply same_place_ok in E as <-.
  - intros O. apply internal_unary_op_dec_bl in O. now subst.
  - destruct (same_place q q') eqn:F; try discriminate. apply same_place_ok in F as <-.
    intros O. apply internal_binary_op_dec_bl in O. now subst.
Qed.

(* Where a step is looked up. *)
Fixpoint joined (p q : positive) : positive :=
  match p with xH => xI q | xO p => xO (xO (joined p q)) | xI p => xO (xI (joined p q)) end.
Definition place_key (p : place) : positive := match p with Given i => xO i | Computed k => xI k end.
Definition step_key (s : step) : positive :=
  match s with
  | One o p =>
      let n := match o with Neg => 1 | Abs => 2 | Inv => 3 | Sqr => 4 | Cos => 5 | Sin => 6 | PowerInt (Zpos n) => 7 + n | _ => 7 end%positive in
      xO (joined (place_key p) n)
  | Two o p q =>
      let k := joined (place_key p) (place_key q) in
      xI match o with Add => xO (xO k) | Sub => xO (xI k) | Mul => xI (xO k) | Div => xI (xI k) end
  end.

Record program := {
  count : nat; next : positive;  (* one more than count *)
  code : list term;              (* the last one first *)
  known : PositiveMap.t (step * positive) }.
Definition no_program : program := {| count := O; next := xH; code := nil; known := PositiveMap.empty _ |}.

Definition back (n : nat) (p : place) : nat :=
  match p with Given i => (n + pred (Pos.to_nat i))%nat | Computed k => (n - Pos.to_nat k)%nat end.
Definition term_of (n : nat) (s : step) : term :=
  match s with One o p => Unary o (back n p) | Two o p q => Binary o (back n p) (back n q) end.
Definition stepped (P : program) (s : step) : program * place :=
  let key := step_key s in
  let new tt :=
    ({| count := S (count P); next := Pos.succ (next P); code := term_of (count P) s :: code P;
        known := PositiveMap.add key (s, next P) (known P) |}, Computed (next P)) in
  match PositiveMap.find key (known P) with
  | Some (t, k) => if same_step s t then (P, Computed k) else new tt
  | None => new tt
  end.

(* A part without variables is a constant; those of the list are given after the variables. *)
Inductive part := Constant | At (p : place).
Fixpoint same_expression (a b : expr) : bool :=
  match a, b with
  | Evar i, Evar j => Nat.eqb i j
  | Econst c, Econst d => internal_nullary_op_beq c d
  | Eunary o a, Eunary o' a' => if internal_unary_op_beq o o' then same_expression a a' else false
  | Ebinary o a b, Ebinary o' a' b' =>
      if internal_binary_op_beq o o' then if same_expression a a' then same_expression b b' else false else false
  | _, _ => false
  end.
Lemma same_expression_ok : forall a b, same_expression a b = true -> a = b.
Proof.
  induction a as [i|c|o a A|o a A b B]; intros [j|d|o' a'|o' a' b']; try discriminate; simpl.
  - intros E. apply Nat.eqb_eq in E. now subst.
  - intros E. apply internal_nullary_op_dec_bl in E. now subst.
  - destruct internal_unary_op_beq eqn:O; try discriminate. apply internal_unary_op_dec_bl in O as <-.
    intros E. now rewrite (A _ E).
  - destruct internal_binary_op_beq eqn:O; try discriminate. apply internal_binary_op_dec_bl in O as <-.
    destruct same_expression eqn:E; try discriminate. rewrite (A _ E). intros F. now rewrite (B _ F).
Qed.
Fixpoint constant_at (cs : list expr) (i : positive) (e : expr) : option place :=
  match cs with
  | nil => None
  | c :: cs => if same_expression c e then Some (Given i) else constant_at cs (Pos.succ i) e
  end.
Definition place_of_part (cs : list expr) (first : positive) (e : expr) (p : part) : option place :=
  match p with Constant => constant_at cs first e | At p => Some p end.
(* A product of equals is a square, which has tighter bounds. *)
Definition one_of_two (o : binary_op) (p q : place) : step :=
  match o with Mul => if same_place p q then One Sqr p else Two o p q | _ => Two o p q end.
Fixpoint programmed (cs : list expr) (vars : nat) (first : positive) (P : program) (e : expr) : option (program * part) :=
  match e with
  | Evar i => if Nat.ltb i vars then Some (P, At (Given (Pos.of_succ_nat i))) else None
  | Econst _ => Some (P, Constant)
  | Eunary o a =>
      match programmed cs vars first P a with
      | Some (P, At p) => let '(P, q) := stepped P (One o p) in Some (P, At q)
      | other => other
      end
  | Ebinary o a b =>
      match programmed cs vars first P a with
      | Some (P, p) =>
          match programmed cs vars first P b with
          | Some (P, q) =>
              match p, q with
              | Constant, Constant => Some (P, Constant)
              | _, _ =>
                  match place_of_part cs first a p, place_of_part cs first b q with
                  | Some p, Some q => let '(P, r) := stepped P (one_of_two o p q) in Some (P, At r)
                  | _, _ => None
                  end
              end
          | None => None
          end
      | None => None
      end
  end.
(* The constants of an expression, each once; None for one that is a constant itself. *)
Fixpoint constants (e : expr) (cs : list expr) : option (list expr) :=
  let add e cs := if existsb (same_expression e) cs then cs else e :: cs in
  match e with
  | Evar _ => Some cs
  | Econst _ => None
  | Eunary _ a => constants a cs
  | Ebinary _ a b =>
      match constants a cs with
      | Some cs => match constants b cs with Some cs => Some cs | None => Some (add b cs) end
      | None => match constants b cs with Some cs => Some (add a cs) | None => None end
      end
  end.
Definition program_of (e : expr) (vars : nat) : option (list term * list expr) :=
  match constants e nil with
  | None => Some (Forward vars :: nil, e :: nil)
  | Some cs =>
      match programmed cs vars (Pos.of_succ_nat vars) no_program e with
      | Some (P, At p) => Some (rev (Forward (back (count P) p) :: code P), cs)
      | _ => None
      end
  end.

Section Right.
Variables (cs : list expr) (vars : list R).
Let l := vars ++ map (fun c => eval c nil) cs.
(* At the place, of what is given and of what was computed, the last first, stands x. *)
Definition stands (rs : list R) (p : place) (x : R) : Prop :=
  match p with
  | Given i => nth (pred (Pos.to_nat i)) l 0 = x
  | Computed k => (Pos.to_nat k <= length rs)%nat /\ nth (length rs - Pos.to_nat k) rs 0 = x
  end.
Definition says (rs : list R) (s : step) (x : R) : Prop :=
  match s with
  | One o p => exists y, stands rs p y /\ x = unary_real o y
  | Two o p q => exists y z, stands rs p y /\ stands rs q z /\ x = binary_real o y z
  end.
Lemma stands_later r rs p x : stands rs p x -> stands (r :: rs) p x.
Proof.
  destruct p as [i|k]; [easy|]. intros [L E]. cbn [stands length]. split; [lia|].
  replace (S (length rs) - Pos.to_nat k)%nat with (S (length rs - Pos.to_nat k)) by lia. exact E.
Qed.
Lemma says_later r rs s x : says rs s x -> says (r :: rs) s x.
Proof.
  destruct s as [o p|o p q]; simpl.
  - intros (y & Y & E). exists y. auto using stands_later.
  - intros (y & z & Y & Z & E). exists y, z. auto using stands_later.
Qed.
Lemma nth_back rs p x : stands rs p x -> nth (back (length rs) p) (rs ++ l) 0 = x.
Proof.
  destruct p as [i|k]; simpl.
  - intros E. rewrite app_nth2 by lia. now replace (length rs + pred (Pos.to_nat i) - length rs)%nat with (pred (Pos.to_nat i)) by lia.
  - intros [L E]. pose proof (Pos2Nat.is_pos k). now rewrite app_nth1 by lia.
Qed.
Definition runs (P : program) (rs : list R) : Prop :=
  count P = length rs /\ Pos.to_nat (next P) = S (length rs) /\ eval_real (rev (code P)) l = rs ++ l /\
  forall key s k, PositiveMap.find key (known P) = Some (s, k) -> exists x, says rs s x /\ stands rs (Computed k) x.
Lemma runs_no_program : runs no_program nil.
Proof.
  repeat split. intros key s k. simpl. rewrite PositiveMap.gempty. discriminate.
Qed.
(* Further steps, from which all that stands stays. *)
Definition goes_on (P : program) (rs : list R) (Q : program) (p : place) (x : R) : Prop :=
  exists ts, runs Q (ts ++ rs) /\ stands (ts ++ rs) p x.
Lemma stepped_ok P rs s x Q p : runs P rs -> says rs s x -> stepped P s = (Q, p) -> goes_on P rs Q p x.
Proof.
  intros (C & N & E & K) S. unfold stepped.
  assert (new : ({| count := Datatypes.S (count P); next := Pos.succ (next P); code := term_of (count P) s :: code P;
        known := PositiveMap.add (step_key s) (s, next P) (known P) |}, Computed (next P)) = (Q, p) -> goes_on P rs Q p x).
  { intros I. injection I as <- <-. exists (x :: nil). simpl app.
    assert (T : stands (x :: rs) (Computed (next P)) x).
    { simpl. rewrite N. split; [lia|]. now rewrite Nat.sub_diag. }
    split; [|exact T]. unfold runs. cbn [count next code known]. split; [simpl; lia|]. split; [rewrite Pos2Nat.inj_succ; simpl; lia|]. split.
    - simpl rev. unfold eval_real, eval_generic in *. rewrite fold_left_app, E. simpl fold_left. unfold eval_generic_body at 1.
      rewrite C. cbv zeta. destruct s as [o q|o q q']; simpl term_of; cbv iota beta.
      + destruct S as (y & Y & ->). rewrite (nth_back _ _ _ Y). reflexivity.
      + destruct S as (y & z & Y & Z & ->). rewrite (nth_back _ _ _ Y), (nth_back _ _ _ Z). reflexivity.
    - intros key t k. destruct (PositiveMap.E.eq_dec key (step_key s)) as [->|D].
      + rewrite PositiveMap.gss. intros I. injection I as <- <-. exists x. split; [now apply says_later | exact T].
      + rewrite PositiveMap.gso by exact D. intros F. destruct (K _ _ _ F) as (y & Y & Z). exists y.
        split; [now apply says_later | now apply stands_later]. }
  cbv zeta. destruct (PositiveMap.find (step_key s) (known P)) as [[t k]|] eqn:F; [|exact new].
  destruct (same_step s t) eqn:D; [|exact new]. apply same_step_ok in D as <-.
  intros I. injection I as <- <-. exists nil. split; [exact (conj C (conj N (conj E K)))|].
  destruct (K _ _ _ F) as (y & Y & Z). replace x with y; [exact Z|]. clear - Y S.
  assert (same : forall p u v, stands rs p u -> stands rs p v -> u = v).
  { intros [i|i] u v; simpl; [congruence | intros [_ A] [_ B]; congruence]. }
  destruct s as [o p|o p q]; simpl in *.
  - destruct Y as (u & U & ->), S as (v & V & ->). now rewrite (same _ _ _ U V).
  - destruct Y as (u & u' & U & U' & ->), S as (v & v' & V & V' & ->). now rewrite (same _ _ _ U V), (same _ _ _ U' V').
Qed.
Lemma constant_at_ok e : forall ds before p, map (fun c => eval c nil) cs = before ++ map (fun c => eval c nil) ds ->
  constant_at ds (Pos.of_succ_nat (length vars + length before)) e = Some p -> forall rs, stands rs p (eval e nil).
Proof.
  induction ds as [|c ds H]; [discriminate|]. intros before p E. simpl.
  destruct (same_expression c e) eqn:S.
  - apply same_expression_ok in S as ->. intros I rs. injection I as <-. simpl.
    rewrite SuccNat2Pos.id_succ. simpl pred. unfold l. rewrite app_nth2 by lia.
    replace (length vars + length before - length vars)%nat with (length before + 0)%nat by lia.
    rewrite E, app_nth2_plus. reflexivity.
  - intros I. apply (H (before ++ eval c nil :: nil)).
    + rewrite E, <- app_assoc. reflexivity.
    + rewrite app_length. simpl. rewrite Nat.add_1_r, Nat.add_succ_r. simpl. exact I.
Qed.
Lemma programmed_ok : forall e P rs Q r, runs P rs -> programmed cs (length vars) (Pos.of_succ_nat (length vars)) P e = Some (Q, r) ->
  exists ts, runs Q (ts ++ rs) /\
    match r with Constant => forall k, eval e k = eval e nil | At p => stands (ts ++ rs) p (eval e vars) end.
Proof.
  induction e as [i|c|o a A|o a A b B]; intros P rs Q r G E; simpl in E.
  - destruct (Nat.ltb_spec i (length vars)) as [L|_]; [|discriminate]. injection E as <- <-. exists nil.
    split; [exact G|]. simpl. rewrite SuccNat2Pos.id_succ. simpl pred. unfold l. now rewrite app_nth1.
  - injection E as <- <-. exists nil. split; [exact G|]. reflexivity.
  - destruct (programmed cs _ _ P a) as [[P1 [|p]]|] eqn:EA; try discriminate.
    + injection E as <- <-. destruct (A _ _ _ _ G EA) as (ts & G1 & C). exists ts. split; [exact G1|].
      intros k. simpl. now rewrite C.
    + destruct (A _ _ _ _ G EA) as (ts & G1 & S). destruct (stepped P1 (One o p)) as [P2 q] eqn:T. injection E as <- <-.
      destruct (stepped_ok _ _ (One o p) (unary_real o (eval a vars)) _ _ G1 ltac:(simpl; eauto) T) as (us & G2 & U).
      exists (us ++ ts). rewrite <- app_assoc. split; [exact G2 | exact U].
  - destruct (programmed cs _ _ P a) as [[P1 p]|] eqn:EA; [|discriminate].
    destruct (programmed cs _ _ P1 b) as [[P2 q]|] eqn:EB; [|discriminate].
    destruct (A _ _ _ _ G EA) as (ts & G1 & SA). destruct (B _ _ _ _ G1 EB) as (us & G2 & SB).
    rewrite app_assoc in *.
    assert (later : forall vs p x, stands (ts ++ rs) p x -> stands ((vs ++ ts) ++ rs) p x).
    { clear. intros vs p x S. rewrite <- app_assoc. induction vs as [|v vs H]; [exact S | simpl; now apply stands_later]. }
    assert (step : match place_of_part cs (Pos.of_succ_nat (length vars)) a p, place_of_part cs (Pos.of_succ_nat (length vars)) b q with
                  | Some p, Some q => let '(P, r) := stepped P2 (one_of_two o p q) in Some (P, At r)
                  | _, _ => None
                  end = Some (Q, r) ->
            exists ts, runs Q (ts ++ rs) /\ match r with Constant => forall k, eval (Ebinary o a b) k = eval (Ebinary o a b) nil | At p => stands (ts ++ rs) p (eval (Ebinary o a b) vars) end).
    { assert (placed : forall e r p, match r with Constant => forall k, eval e k = eval e nil | At p => stands ((us ++ ts) ++ rs) p (eval e vars) end ->
                place_of_part cs (Pos.of_succ_nat (length vars)) e r = Some p -> stands ((us ++ ts) ++ rs) p (eval e vars)).
      { intros e' [|p'] p''; simpl.
        - intros C I. rewrite C. apply (constant_at_ok _ cs nil); [reflexivity | now rewrite Nat.add_0_r].
        - intros C I. now injection I as <-. }
      destruct (place_of_part _ _ a p) as [p'|] eqn:PA; [|discriminate].
      destruct (place_of_part _ _ b q) as [q'|] eqn:PB; [|discriminate].
      apply placed in PA; [|destruct p; [exact SA | now apply later]]. apply placed in PB; [|exact SB].
      destruct (stepped P2 (one_of_two o p' q')) as [P3 r'] eqn:T. intros I. injection I as <- <-.
      assert (says ((us ++ ts) ++ rs) (one_of_two o p' q') (binary_real o (eval a vars) (eval b vars))).
      { unfold one_of_two. destruct o; simpl; eauto.
        destruct (same_place p' q') eqn:D; [|simpl; eauto]. apply same_place_ok in D as <-. simpl.
        exists (eval a vars). split; [exact PA|]. replace (eval b vars) with (eval a vars); [reflexivity|].
        destruct p' as [i|i]; simpl in *; [congruence | destruct PA, PB; congruence]. }
      destruct (stepped_ok _ _ _ _ _ _ G2 H T) as (vs & G3 & V). exists (vs ++ us ++ ts). rewrite <- app_assoc.
      split; [exact G3 | exact V]. }
    destruct p as [|p]; [destruct q as [|q]|]; [|exact (step E) | exact (step E)].
    injection E as <- <-. exists (us ++ ts). split; [exact G2|]. intros k. simpl. now rewrite SA, SB.
Qed.
End Right.
Lemma program_of_ok e vars prog cs : program_of e (length vars) = Some (prog, cs) ->
  eval_real' prog vars cs = eval e vars.
Proof.
  unfold program_of. destruct (constants e nil) as [ds|] eqn:D.
  - destruct (programmed ds _ _ no_program e) as [[P [|p]]|] eqn:E; try discriminate. intros I. injection I as <- <-.
    destruct (programmed_ok ds vars e _ _ _ _ (runs_no_program ds vars) E) as (ts & (C & _ & R & _) & S).
    rewrite app_nil_r in *. unfold eval_real'. simpl rev. unfold eval_real, eval_generic in *.
    rewrite fold_left_app. unfold eval_real, eval_generic in R. rewrite R. simpl. rewrite C.
    exact (nth_back ds vars _ _ _ S).
  - intros I. injection I as <- <-. unfold eval_real', eval_real, eval_generic. simpl.
    rewrite app_nth2, Nat.sub_diag by lia. simpl.
    assert (Q : forall e cs, constants e cs = None -> forall k, eval e k = eval e nil).
    { clear. induction e as [i|c|o a A|o a A b B]; intros cs E k; simpl in E |- *; try discriminate; [reflexivity| |].
      - now rewrite (A _ E).
      - destruct (constants a cs) eqn:EA; [destruct (constants b l); discriminate|].
        destruct (constants b cs) eqn:EB; [discriminate|]. now rewrite (A _ EA), (B _ EB). }
    symmetry. exact (Q _ _ D vars).
Qed.
