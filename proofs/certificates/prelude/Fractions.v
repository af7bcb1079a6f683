(* Identities of rational functions, decided by computation.

   An expression becomes a fraction: a polynomial with whole coefficients over a whole number and a product of
   powers of polynomials that are known not to be 0. Squares of cosines become 1 - s s at each product. *)
From Stickslip Require Import Matrices Polynomials.

Inductive expression : Set :=
| Number (z : Z)
| Letter (k : positive)
| Plus (a b : expression)
| Times (a b : expression)
| Minus (a b : expression)
| Opposite (a : expression)
| Inverse (a : expression)
| Over (a b : expression)
| Power (a : expression) (n : nat).

Fixpoint value (l : list R) (e : expression) : R :=
  match e with
  | Number z => IZR z
  | Letter k => nth 0 k l
  | Plus a b => Rplus (value l a) (value l b)
  | Times a b => Rmult (value l a) (value l b)
  | Minus a b => Rminus (value l a) (value l b)
  | Opposite a => Ropp (value l a)
  | Inverse a => Rinv (value l a)
  | Over a b => Rdiv (value l a) (value l b)
  | Power a n => pow (value l a) n
  end.

Record fraction := { over : Polynomial; whole : positive; powers : list nat }.

Fixpoint both (a b : list nat) : list nat :=
  match a, b with
  | x :: a, y :: b => (x + y)%nat :: both a b
  | nil, _ => b
  | _, nil => a
  end.
(* What a lacks of the larger of both. *)
Fixpoint gap (a b : list nat) : list nat :=
  match a, b with
  | x :: a, y :: b => (y - x)%nat :: gap a b
  | nil, _ => b
  | _, nil => nil
  end.
Lemma gaps : forall a b, both a (gap a b) = both b (gap b a).
Proof.
  induction a as [|x a H]; intros [|y b]; simpl; try reflexivity. f_equal; [lia | apply H].
Qed.

Definition times (rules : Rules) (P Q : Polynomial) : Polynomial :=
  match P, Q with
  | Pc _, _ | _, Pc _ => pmul P Q
  | _, _ => reduced (rules_for P Q rules) (pmul P Q)
  end.
Lemma times_ok {rules l} (known : obeyed rules l) P Q : at_ l (times rules P Q) = at_ l P * at_ l Q.
Proof. unfold times. destruct P, Q; rewrite ?reduced_ok by exact (obeyed_for _ _ _ _ known); apply pmul_ok. Qed.

Fixpoint to_power (rules : Rules) (P : Polynomial) (n : nat) : Polynomial :=
  match n with O => pconst 1 | 1%nat => P | S m => times rules P (to_power rules P m) end.
Lemma to_power_ok {rules l} (known : obeyed rules l) P n : at_ l (to_power rules P n) = at_ l P ^ n.
Proof.
  induction n as [|[|n] H]; [reflexivity | simpl; ring |].
  change (at_ l (times rules P (to_power rules P (S n))) = at_ l P * at_ l P ^ S n). now rewrite (times_ok known), H.
Qed.

Fixpoint product (rules : Rules) (ds : list Polynomial) (es : list nat) : Polynomial :=
  match ds, es with
  | d :: ds, e :: es => times rules (to_power rules d e) (product rules ds es)
  | _, _ => pconst 1
  end.
Fixpoint rproduct (l : list R) (ds : list Polynomial) (es : list nat) : R :=
  match ds, es with
  | d :: ds, e :: es => at_ l d ^ e * rproduct l ds es
  | _, _ => 1
  end.
Lemma product_ok {rules l} (known : obeyed rules l) : forall ds es, at_ l (product rules ds es) = rproduct l ds es.
Proof.
  induction ds as [|d ds H]; intros [|e es]; try reflexivity. simpl. now rewrite (times_ok known), (to_power_ok known), H.
Qed.
Lemma rproduct_both l : forall ds a b, rproduct l ds (both a b) = rproduct l ds a * rproduct l ds b.
Proof.
  induction ds as [|d ds H]; intros [|x a] [|y b]; simpl; try ring. rewrite pow_add, H. ring.
Qed.

Fixpoint none_is_zero (l : list R) (ds : list Polynomial) : Prop :=
  match ds with nil => True | d :: ds => at_ l d <> 0 /\ none_is_zero l ds end.
Lemma rproduct_nonzero l : forall ds es, none_is_zero l ds -> rproduct l ds es <> 0.
Proof.
  induction ds as [|d ds H]; intros [|e es]; simpl; try (intros; lra).
  intros [D N]. apply Rmult_integral_contrapositive_currified; [now apply pow_nonzero | now apply H].
Qed.

Definition below (l : list R) (ds : list Polynomial) (f : fraction) : R :=
  IZR (Zpos (whole f)) * rproduct l ds (powers f).
Definition means (l : list R) (ds : list Polynomial) (f : fraction) (x : R) : Prop :=
  at_ l (over f) = x * below l ds f.
Lemma whole_nonzero (p : positive) : IZR (Zpos p) <> 0.
Proof. apply not_0_IZR. discriminate. Qed.
Lemma below_nonzero l ds f : none_is_zero l ds -> below l ds f <> 0.
Proof.
  intros D. apply Rmult_integral_contrapositive_currified; [apply whole_nonzero | now apply rproduct_nonzero].
Qed.

Definition fnumber (z : Z) : fraction := {| over := pconst z; whole := 1; powers := nil |}.
Definition fletter (k : positive) : fraction := {| over := pletter k; whole := 1; powers := nil |}.
Definition fopposite (f : fraction) : fraction :=
  {| over := popp (over f); whole := whole f; powers := powers f |}.
Definition ftimes (rules : Rules) (f g : fraction) : fraction :=
  {| over := times rules (over f) (over g); whole := whole f * whole g; powers := both (powers f) (powers g) |}.
Definition fplus (rules : Rules) (ds : list Polynomial) (f g : fraction) : fraction :=
  let '(_, (a, b)) := Pos.ggcd (whole f) (whole g) in
  let p := gap (powers f) (powers g) in
  {| over := padd (pscale (times rules (over f) (product rules ds p)) (Zpos b))
                  (pscale (times rules (over g) (product rules ds (gap (powers g) (powers f)))) (Zpos a));
     whole := whole f * b; powers := both (powers f) p |}.
Fixpoint fpower (rules : Rules) (f : fraction) (n : nat) : fraction :=
  match n with O => fnumber 1 | 1%nat => f | S m => ftimes rules f (fpower rules f m) end.

Lemma fnumber_ok l ds z : means l ds (fnumber z) (IZR z).
Proof.
  unfold means, below, fnumber, at_, pconst. simpl. destruct ds; simpl; ring.
Qed.
Lemma fletter_ok l ds k : means l ds (fletter k) (nth 0 k l).
Proof. unfold means, below, fletter. simpl. rewrite pletter_ok. destruct ds; simpl; ring. Qed.
Lemma fopposite_ok l ds f x : means l ds f x -> means l ds (fopposite f) (- x).
Proof. unfold means, below, fopposite. simpl. intros F. rewrite popp_ok, F. ring. Qed.
Lemma ftimes_ok {rules l} (known : obeyed rules l) ds f g x y :
  means l ds f x -> means l ds g y -> means l ds (ftimes rules f g) (x * y).
Proof.
  unfold means, below, ftimes. simpl. intros F G. rewrite (times_ok known), F, G, rproduct_both, Pos2Z.inj_mul, mult_IZR.
  ring.
Qed.
Lemma fpower_ok {rules l} (known : obeyed rules l) ds f x n : means l ds f x -> means l ds (fpower rules f n) (x ^ n).
Proof.
  intros F. induction n as [|[|n] H]; [apply fnumber_ok | simpl; now rewrite Rmult_1_r |].
  change (means l ds (ftimes rules f (fpower rules f (S n))) (x * x ^ S n)). now apply ftimes_ok.
Qed.
Lemma fplus_ok {rules l} (known : obeyed rules l) ds f g x y :
  means l ds f x -> means l ds g y -> means l ds (fplus rules ds f g) (x + y).
Proof.
  unfold means, below, fplus. intros F G.
  pose proof (Pos.ggcd_correct_divisors (whole f) (whole g)) as D.
  destruct (Pos.ggcd (whole f) (whole g)) as [c [a b]]. destruct D as [A B]. simpl.
  rewrite padd_ok, !pscale_ok, !(times_ok known), !(product_ok known), F, G.
  assert (W : IZR (Zpos (whole f)) * IZR (Zpos b) = IZR (Zpos (whole g)) * IZR (Zpos a)).
  { rewrite <- !mult_IZR, <- !Pos2Z.inj_mul. do 2 f_equal. rewrite A, B. now rewrite <- !Pos.mul_assoc, (Pos.mul_comm a b). }
  assert (P : rproduct l ds (powers f) * rproduct l ds (gap (powers f) (powers g)) =
              rproduct l ds (powers g) * rproduct l ds (gap (powers g) (powers f))).
  { rewrite <- !rproduct_both. f_equal. apply gaps. }
  rewrite Pos2Z.inj_mul, mult_IZR, rproduct_both.
  transitivity (x * (IZR (Z.pos (whole f)) * IZR (Z.pos b)) *
                (rproduct l ds (powers f) * rproduct l ds (gap (powers f) (powers g))) +
                y * (IZR (Z.pos (whole f)) * IZR (Z.pos b)) *
                (rproduct l ds (powers f) * rproduct l ds (gap (powers f) (powers g)))); [|ring].
  rewrite W at 2. rewrite P at 2. ring.
Qed.

(* N v = u times a product of powers: of a number and of a divisor itself. *)
Fixpoint leading (P : Polynomial) : Z :=
  match P with Pc z => z | Pinj _ P => leading P | PX P _ _ => leading P end.
Fixpoint found (N : Polynomial) (ds : list Polynomial) : option (list nat) :=
  match ds with
  | nil => None
  | d :: ds =>
      if peq (pscale N (leading d)) (pscale d (leading N)) then Some (1%nat :: nil)
      else option_map (cons 0%nat) (found N ds)
  end.
Definition shape (rules : Rules) (ds : list Polynomial) (N : Polynomial) : option (Z * list nat * Z) :=
  match N with
  | Pc u => Some (u, nil, 1%Z)
  | _ =>
      match found N ds with
      | Some es =>
          let d := product rules ds es in
          if peq (pscale N (leading d)) (pscale d (leading N)) then Some (leading N, es, leading d) else None
      | None => None
      end
  end.
Lemma shape_ok {rules l} (known : obeyed rules l) ds N u es v : shape rules ds N = Some (u, es, v) -> at_ l N * IZR v = IZR u * rproduct l ds es.
Proof.
  unfold shape.
  assert (G : match found N ds with
              | Some es =>
                  let d := product rules ds es in
                  if peq (pscale N (leading d)) (pscale d (leading N)) then Some (leading N, es, leading d) else None
              | None => None
              end = Some (u, es, v) -> at_ l N * IZR v = IZR u * rproduct l ds es).
  { destruct (found N ds) as [found_|]; [|discriminate]. cbv zeta.
    destruct peq eqn:E; [|discriminate]. intros S. injection S as <- <- <-.
    pose proof (peq_ok _ _ E l) as F. rewrite !pscale_ok, (product_ok known) in F. rewrite F. ring. }
  destruct N; try exact G.
  intros S. injection S as <- <- <-. unfold at_. simpl. destruct ds; simpl; ring.
Qed.

Definition turned (rules : Rules) (ds : list Polynomial) (f : fraction) (u : Z) (es : list nat) (v : Z) : fraction :=
  {| over := pscale (product rules ds (powers f)) (Zpos (whole f) * v * Z.sgn u);
     whole := Z.to_pos (Z.abs u);
     powers := es |}.
Definition inverted (rules : Rules) (ds : list Polynomial) (f : fraction) : option fraction :=
  match shape rules ds (over f) with
  | Some (u, es, v) =>
      match u, v with
      | Z0, _ | _, Z0 => None
      | _, _ => Some (turned rules ds f u es v)
      end
  | None => None
  end.
Lemma inverted_ok {rules l} (known : obeyed rules l) ds (nonzero : none_is_zero l ds) f g x :
  means l ds f x -> inverted rules ds f = Some g -> x <> 0 /\ means l ds g (/ x).
Proof.
  unfold inverted. intros F.
  destruct (shape rules ds (over f)) as [[[u es] v]|] eqn:S; [|discriminate]. apply (shape_ok known) in S.
  intros E.
  assert (U : IZR u <> 0 /\ IZR v <> 0 /\ Some (turned rules ds f u es v) = Some g).
  { destruct u, v; try discriminate; (split; [apply not_0_IZR; discriminate|]);
      (split; [apply not_0_IZR; discriminate | exact E]). }
  clear E. destruct U as [U [V E]]. injection E as <-.
  assert (N : x <> 0).
  { intros Z. unfold means in F. rewrite F, Z in S. apply (rproduct_nonzero l ds es nonzero).
    apply (Rmult_eq_reg_l (IZR u)); [|exact U]. rewrite <- S. ring. }
  split; [exact N|]. unfold means in *. rewrite F in S. clear F.
  cbv beta iota delta [below turned over whole powers] in *. rewrite pscale_ok, (product_ok known), !mult_IZR.
  assert (A : IZR (Zpos (Z.to_pos (Z.abs u))) = IZR u * IZR (Z.sgn u)).
  { rewrite <- mult_IZR. f_equal. destruct u; [now elim U | simpl; lia | simpl; lia]. }
  rewrite A. apply (Rmult_eq_reg_l x); [|exact N].
  transitivity ((IZR u * rproduct l ds es) * IZR (Z.sgn u)).
  - rewrite <- S. ring.
  - field. exact N.
Qed.

(* Letters that stand for polynomials in others. *)
Definition Table := list (positive * (Polynomial * positive)).
Fixpoint looked_up (table : Table) (k : positive) : fraction :=
  match table with
  | (i, (P, w)) :: table =>
      if Pos.eqb i k then {| over := P; whole := w; powers := nil |} else looked_up table k
  | nil => fletter k
  end.
Fixpoint tabled (l : list R) (table : Table) : Prop :=
  match table with
  | (i, (P, w)) :: table => at_ l P = nth 0 i l * IZR (Zpos w) /\ tabled l table
  | nil => True
  end.
Lemma looked_up_ok l ds k : forall table, tabled l table -> means l ds (looked_up table k) (nth 0 k l).
Proof.
  induction table as [|[i [P w]] table H]; [intros _; apply fletter_ok|]. intros [E T]. simpl.
  destruct (Pos.eqb_spec i k) as [->|_]; [|now apply H].
  unfold means, below. cbv beta iota delta [over whole powers]. rewrite E. destruct ds; simpl; ring.
Qed.

(* Of an expression, or of its inverse, if it is seen not to be 0. *)
Fixpoint fraction_of (rules : Rules) (table : Table) (ds : list Polynomial) (inverse : bool) (e : expression) : option fraction :=
  let finish f := if inverse then inverted rules ds f else Some f in
  let two op a b :=
    match fraction_of rules table ds false a, fraction_of rules table ds false b with Some f, Some g => finish (op f g) | _, _ => None end in
  match e with
  | Number z => finish (fnumber z)
  | Letter k => finish (looked_up table k)
  | Plus a b => two (fplus rules ds) a b
  | Minus a b => two (fun f g => fplus rules ds f (fopposite g)) a b
  | Times a b =>
      match fraction_of rules table ds inverse a, fraction_of rules table ds inverse b with
      | Some f, Some g => Some (ftimes rules f g)
      | _, _ => if inverse then two (ftimes rules) a b else None
      end
  | Opposite a => option_map fopposite (fraction_of rules table ds inverse a)
  | Power a n => option_map (fun f => fpower rules f n) (fraction_of rules table ds inverse a)
  | Inverse a =>
      match fraction_of rules table ds true a with
      | Some f => if inverse then fraction_of rules table ds false a else Some f
      | None => None
      end
  | Over a b =>
      match fraction_of rules table ds inverse a, fraction_of rules table ds true b, fraction_of rules table ds (negb inverse) b with
      | Some f, Some _, Some g => Some (ftimes rules f g)
      | _, _, _ => None
      end
  end.
Lemma fraction_of_ok {rules l} (known : obeyed rules l) {table} (T : tabled l table) ds
    (nonzero : none_is_zero l ds) :
  forall e i f, fraction_of rules table ds i e = Some f ->
  if i then value l e <> 0 /\ means l ds f (/ value l e) else means l ds f (value l e).
Proof.
  assert (finish : forall (i : bool) x f g, means l ds f x -> (if i then inverted rules ds f else Some f) = Some g ->
                   if i then x <> 0 /\ means l ds g (/ x) else means l ds g x).
  { intros [] x f g F E; [now apply (inverted_ok known ds nonzero f) | now injection E as <-]. }
  induction e as [z|k|a A b B|a A b B|a A b B|a A|a A|a A b B|a A n]; intros i f E; simpl in E |- *.
  - now apply (finish i _ (fnumber z)); [apply fnumber_ok|].
  - now apply (finish i _ (looked_up table k)); [apply looked_up_ok|].
  - specialize (A false). specialize (B false). destruct (fraction_of rules table ds false a) as [p|]; [|discriminate].
    destruct (fraction_of rules table ds false b) as [q|]; [|discriminate].
    apply (finish i _ (fplus rules ds p q)); [|exact E]. now apply (fplus_ok known); [apply A | apply B].
  - pose proof (A i) as A1. pose proof (B i) as B1. pose proof (A false) as A2. pose proof (B false) as B2.
    destruct (fraction_of rules table ds i a) as [p|], (fraction_of rules table ds i b) as [q|];
      try (injection E as <-; specialize (A1 p eq_refl); specialize (B1 q eq_refl); destruct i;
        [ destruct A1 as [N A1], B1 as [M B1];
          split; [now apply Rmult_integral_contrapositive_currified|];
          replace (/ (value l a * value l b)) with (/ value l a * / value l b) by (field; now split);
          now apply (ftimes_ok known)
        | now apply (ftimes_ok known) ]);
      (destruct i; [|discriminate]);
      (destruct (fraction_of rules table ds false a) as [p'|]; [|discriminate]);
      (destruct (fraction_of rules table ds false b) as [q'|]; [|discriminate]);
      (apply (inverted_ok known ds nonzero (ftimes rules p' q')); [|exact E]); now apply (ftimes_ok known); [apply A2 | apply B2].
  - specialize (A false). specialize (B false). destruct (fraction_of rules table ds false a) as [p|]; [|discriminate].
    destruct (fraction_of rules table ds false b) as [q|]; [|discriminate].
    apply (finish i _ (fplus rules ds p (fopposite q))); [|exact E].
    apply (fplus_ok known); [now apply A | now apply fopposite_ok; apply B].
  - specialize (A i). destruct (fraction_of rules table ds i a) as [p|]; [|discriminate]. injection E as <-.
    specialize (A p eq_refl). destruct i; [|now apply fopposite_ok].
    destruct A as [N A]. split; [now apply Ropp_neq_0_compat|].
    replace (/ - value l a) with (- / value l a) by (now field). now apply fopposite_ok.
  - pose proof (A true) as A1. pose proof (A false) as A2. destruct (fraction_of rules table ds true a) as [p|]; [|discriminate].
    destruct (A1 p eq_refl) as [N M]. destruct i; [|now injection E as <-].
    split; [now apply Rinv_neq_0_compat|]. replace (/ / value l a) with (value l a) by (now field). now apply A2.
  - specialize (A i). pose proof (B true) as B1. pose proof (B (negb i)) as B2.
    destruct (fraction_of rules table ds i a) as [p|]; [|discriminate]. destruct (fraction_of rules table ds true b) as [r|]; [|discriminate].
    destruct (fraction_of rules table ds (negb i) b) as [q|]; [|discriminate]. injection E as <-.
    specialize (A p eq_refl). destruct (B1 r eq_refl) as [N _]. specialize (B2 q eq_refl).
    unfold Rdiv. destruct i; simpl in B2.
    + destruct A as [M A]. split; [now apply Rmult_integral_contrapositive_currified; [|apply Rinv_neq_0_compat]|].
      replace (/ (value l a * / value l b)) with (/ value l a * value l b) by (field; now split).
      now apply (ftimes_ok known).
    + now apply (ftimes_ok known).
  - specialize (A i). destruct (fraction_of rules table ds i a) as [p|]; [|discriminate]. injection E as <-.
    specialize (A p eq_refl). destruct i; [|now apply (fpower_ok known)].
    destruct A as [N A]. split; [now apply pow_nonzero|].
    rewrite Rinv_pow by exact N. now apply (fpower_ok known).
Qed.

Fixpoint where_equal (l : list R) (gs : list (positive * expression)) (C : Prop) : Prop :=
  match gs with nil => C | (k, e) :: gs => nth 0 k l = value l e -> where_equal l gs C end.
Fixpoint on_circles (l : list R) (cs : list (positive * positive)) (C : Prop) : Prop :=
  match cs with
  | nil => C
  | (c, s) :: cs => nth 0 c l * nth 0 c l = 1 - nth 0 s l * nth 0 s l -> on_circles l cs C
  end.
Fixpoint where_nonzero (l : list R) (es : list expression) (C : Prop) : Prop :=
  match es with nil => C | e :: es => value l e <> 0 -> where_nonzero l es C end.

Fixpoint equal_all (l : list R) (gs : list (positive * expression)) : Prop :=
  match gs with nil => True | (k, e) :: gs => nth 0 k l = value l e /\ equal_all l gs end.
Fixpoint nonzero_all (l : list R) (es : list expression) : Prop :=
  match es with nil => True | e :: es => value l e <> 0 /\ nonzero_all l es end.

(* The value of a letter may speak of letters before it. *)
Fixpoint table_of (rules : Rules) (gs : list (positive * expression)) (table : Table) : Table :=
  match gs with
  | nil => table
  | (k, e) :: gs =>
      table_of rules gs
        match fraction_of rules table nil false e with
        | Some {| over := P; whole := w; powers := nil |} => (k, (P, w)) :: table
        | _ => table
        end
  end.
Lemma table_of_ok {rules l} (known : obeyed rules l) : forall gs table,
  equal_all l gs -> tabled l table -> tabled l (table_of rules gs table).
Proof.
  induction gs as [|[k e] gs H]; [trivial|]. intros table [E G] T. simpl. apply (H _ G).
  destruct (fraction_of rules table nil false e) as [[P w [|]]|] eqn:F; try exact T.
  apply (fraction_of_ok known T nil Logic.I e false) in F. simpl in F. unfold means, below in F.
  cbv beta iota delta [over whole powers rproduct] in F. split; [rewrite E, F; ring | exact T].
Qed.

Fixpoint collected (rules : Rules) (table : Table) (es : list expression) (ds : list Polynomial) :
    list Polynomial :=
  match es with
  | nil => ds
  | e :: es =>
      collected rules table es
        match fraction_of rules table ds false e with
        | Some f => match shape rules ds (over f) with Some _ => ds | None => ds ++ over f :: nil end
        | None => ds
        end
  end.
Lemma none_is_zero_app l ds P : none_is_zero l ds -> at_ l P <> 0 -> none_is_zero l (ds ++ P :: nil).
Proof. induction ds as [|d ds H]; simpl; [now split|]. intros [D N] Z. split; [exact D | now apply H]. Qed.
Lemma collected_ok {rules l} (known : obeyed rules l) {table} (T : tabled l table) : forall es ds,
  nonzero_all l es -> none_is_zero l ds -> none_is_zero l (collected rules table es ds).
Proof.
  induction es as [|e es H]; intros ds E D; [exact D|]. destruct E as [N E]. simpl. apply (H _ E).
  destruct (fraction_of rules table ds false e) as [f|] eqn:F; [|exact D].
  destruct (shape rules ds (over f)) as [_|]; [exact D|]. apply none_is_zero_app; [exact D|].
  apply (fraction_of_ok known T ds D e false) in F. simpl in F. unfold means in F. rewrite F.
  apply Rmult_integral_contrapositive_currified; [exact N | now apply below_nonzero].
Qed.

(* What a test shows where letters are what gs say, the pairs cs lie on circles, and no es is zero. *)
Definition tested (gs : list (positive * expression)) (cs : list (positive * positive)) (es : list expression)
    (test : Rules -> Table -> list Polynomial -> bool) : bool :=
  let rules := rules_of cs in
  let table := table_of rules gs nil in
  test rules table (collected rules table es (collected rules table es nil)).
Lemma tested_ok l test (C : Prop) gs cs es
  (sound : forall rules table ds,
    obeyed rules l -> tabled l table -> none_is_zero l ds -> test rules table ds = true -> C) :
  tested gs cs es test = true -> where_equal l gs (on_circles l cs (where_nonzero l es C)).
Proof.
  intros I.
  assert (S : equal_all l gs -> circles l cs -> nonzero_all l es -> C).
  { intros G K E. apply rules_ok in K. pose proof (table_of_ok K gs nil G Logic.I) as T.
    exact (sound _ _ _ K T (collected_ok K T es _ E (collected_ok K T es nil E Logic.I)) I). }
  clear I sound test.
  assert (W : equal_all l gs -> circles l cs -> where_nonzero l es C).
  { intros G K. specialize (S G K). clear G K.
    induction es as [|e es H]; [exact (S Logic.I)|]. intros N. apply H. intros M. apply S. now split. }
  clear S. revert W. generalize (where_nonzero l es C). clear C. intros C S.
  assert (W : equal_all l gs -> on_circles l cs C).
  { intros G. specialize (S G). clear G.
    induction cs as [|[c s] cs H]; [exact (S Logic.I)|]. intros K. apply H. intros M. apply S. now split. }
  clear S. induction gs as [|[k e] gs H]; [exact (W Logic.I)|]. intros G. apply H. intros M. apply W. now split.
Qed.

Definition same (a b : expression) (rules : Rules) (table : Table) (ds : list Polynomial) : bool :=
  match fraction_of rules table ds false (Minus a b) with
  | Some f => peq (over f) (pconst 0)
  | None => false
  end.
Lemma same_ok l a b rules table ds : obeyed rules l -> tabled l table -> none_is_zero l ds ->
  same a b rules table ds = true -> value l a = value l b.
Proof.
  unfold same. intros C T D I. destruct (fraction_of _ table ds false (Minus a b)) as [f|] eqn:F; [|discriminate].
  apply (fraction_of_ok C T ds D (Minus a b) false) in F. simpl in F. unfold means in F.
  apply (peq_ok _ _) with (l := l) in I. rewrite F in I. unfold at_, pconst in I. simpl in I.
  apply Rminus_diag_uniq. apply (Rmult_eq_reg_r (below l ds f)); [|exact (below_nonzero l ds f D)].
  rewrite I. ring.
Qed.
Fixpoint same_all {A : Type} (alike : A -> A -> Rules -> Table -> list Polynomial -> bool) (n : nat) :
    Vec A n -> Vec A n -> Rules -> Table -> list Polynomial -> bool :=
  match n with
  | O => fun _ _ _ _ _ => true
  | S m => fun v w rules table ds =>
      if alike (fst v) (fst w) rules table ds then same_all alike m (snd v) (snd w) rules table ds else false
  end.
Lemma same_all_ok {A B : Type} alike (f : A -> B) rules table ds :
  (forall a b, alike a b rules table ds = true -> f a = f b) ->
  forall n v w, same_all alike n v w rules table ds = true -> vmap f n v = vmap f n w.
Proof.
  intros K. induction n as [|n H]; intros v w; simpl; [reflexivity|].
  destruct (alike (fst v) (fst w) rules table ds) eqn:E; [|discriminate]. intros J.
  f_equal; [now apply K | now apply H].
Qed.

Definition identical gs cs es (a b : expression) : bool := tested gs cs es (same a b).
Lemma identical_ok l gs cs es a b : identical gs cs es a b = true ->
  where_equal l gs (on_circles l cs (where_nonzero l es (value l a = value l b))).
Proof. apply tested_ok. intros rules table ds. apply same_ok. Qed.
(* Matrices of expressions. *)
Definition identical_m gs cs es (r c : nat) (a b : Vec (Vec expression c) r) : bool :=
  tested gs cs es (same_all (same_all same c) r a b).
Lemma identical_m_ok l gs cs es r c a b : identical_m gs cs es r c a b = true ->
  where_equal l gs (on_circles l cs (where_nonzero l es
    (vmap (vmap (value l) c) r a = vmap (vmap (value l) c) r b))).
Proof.
  apply tested_ok. intros rules table ds C T D. apply same_all_ok. intros v w. apply same_all_ok. intros x y.
  now apply same_ok.
Qed.
