(* Identities of rational functions, decided by computation.

   An expression becomes a fraction: a polynomial with whole coefficients over a whole number and a product of
   powers of polynomials that are known not to be 0. Squares of cosines become 1 - s s at each product. *)
From Stickslip Require Import Matrices.
From Coq Require Import ZArith Lia List Ring_polynom Ring_theory RealField BinList Bool.
Import ListNotations.

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

(* ---- polynomials: those of the tactic ring, over Z *)

Definition Polynomial := Pol Z.
Definition pconst (z : Z) : Polynomial := Pc z.
Definition padd : Polynomial -> Polynomial -> Polynomial := Padd 0%Z Z.add Zeq_bool.
Definition pmul : Polynomial -> Polynomial -> Polynomial := Pmul 0%Z 1%Z Z.add Z.mul Zeq_bool.
Definition pscale : Polynomial -> Z -> Polynomial := PmulC 0%Z 1%Z Z.mul Zeq_bool.
Definition popp : Polynomial -> Polynomial := Popp Z.opp.
Definition peq : Polynomial -> Polynomial -> bool := Peq Zeq_bool.
Definition pletter (k : positive) : Polynomial := mk_X 0%Z 1%Z k.
Definition at_ (l : list R) (P : Polynomial) : R := Pphi 0 Rplus Rmult IZR l P.

Lemma reals_set : Setoid.Setoid_Theory R (@eq R).
Proof. exact (Eqsth R). Qed.
Lemma reals_ext : ring_eq_ext Rplus Rmult Ropp (@eq R).
Proof. exact (Eq_ext Rplus Rmult Ropp). Qed.
Lemma reals_ring : almost_ring_theory 0 1 Rplus Rmult Rminus Ropp (@eq R).
Proof. exact (Rth_ARth reals_set reals_ext RTheory). Qed.
Lemma whole_numbers : ring_morph 0 1 Rplus Rmult Rminus Ropp (@eq R) 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool IZR.
Proof.
  constructor; try reflexivity.
  - exact plus_IZR.
  - exact minus_IZR.
  - exact mult_IZR.
  - exact opp_IZR.
  - intros x y E. now rewrite (Zeq_bool_eq _ _ E).
Qed.

Lemma padd_ok P Q l : at_ l (padd P Q) = at_ l P + at_ l Q.
Proof. exact (Padd_ok reals_set reals_ext reals_ring whole_numbers Q P l). Qed.
Lemma pmul_ok P Q l : at_ l (pmul P Q) = at_ l P * at_ l Q.
Proof. exact (Pmul_ok reals_set reals_ext reals_ring whole_numbers P Q l). Qed.
Lemma pscale_ok P c l : at_ l (pscale P c) = at_ l P * IZR c.
Proof. exact (PmulC_ok reals_set reals_ext reals_ring whole_numbers c P l). Qed.
Lemma popp_ok P l : at_ l (popp P) = - at_ l P.
Proof. exact (Popp_ok reals_set reals_ext reals_ring whole_numbers P l). Qed.
Lemma peq_ok P Q : peq P Q = true -> forall l, at_ l P = at_ l Q.
Proof. exact (Peq_ok reals_set reals_ext whole_numbers P Q). Qed.
Lemma pletter_ok k l : at_ l (pletter k) = nth 0 k l.
Proof. symmetry. exact (mkX_ok reals_set reals_ext reals_ring whole_numbers k l). Qed.

(* ---- cos cos is 1 - sin sin *)

Fixpoint circles (l : list R) (cs : list (positive * positive)) : Prop :=
  match cs with
  | nil => True
  | (c, s) :: rest => nth 0 c l * nth 0 c l = 1 + -1 * (nth 0 s l * nth 0 s l) /\ circles l rest
  end.
Definition rule (c s : positive) : PExpr Z * PExpr Z :=
  (PEmul (PEX Z c) (PEX Z c), PEadd (PEc 1%Z) (PEmul (PEc (-1)%Z) (PEmul (PEX Z s) (PEX Z s)))).
Definition Rules := list (Z * Mon * Polynomial).
Definition rules_of (cs : list (positive * positive)) : Rules :=
  mk_monpol_list 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool Z.quotrem (map (fun '(c, s) => rule c s) cs).
Definition obeyed (rules : Rules) (l : list R) : Prop := MPcond 0 1 Rplus Rmult (@eq R) IZR rules l.

Lemma whole_division : div_theory (@eq R) Z.add Z.mul IZR Z.quotrem.
Proof. constructor. intros a b. pose proof (Z.quotrem_eq a b). destruct (Z.quotrem a b). rewrite H. f_equal. lia. Qed.
Lemma rules_ok cs l : circles l cs -> obeyed (rules_of cs) l.
Proof.
  intros C.
  apply (interp_PElist_ok reals_set reals_ext reals_ring whole_numbers R_power_theory whole_division l).
  induction cs as [|[c s] [|d cs] H]; [exact I| |].
  - destruct C as [C _]. simpl. exact C.
  - destruct C as [C D]. split; [simpl; exact C | exact (H D)].
Qed.
Definition reduced (rules : Rules) (P : Polynomial) : Polynomial :=
  PNSubstL 0%Z 1%Z Z.add Z.mul Zeq_bool Z.quotrem P rules 50 50.
Lemma reduced_ok rules P l : obeyed rules l -> at_ l (reduced rules P) = at_ l P.
Proof.
  intros O. symmetry.
  exact (PNSubstL_ok reals_set reals_ext reals_ring whole_numbers whole_division 50 50 rules P l O).
Qed.

(* ---- fractions *)

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
  | _, _ => reduced rules (pmul P Q)
  end.
Lemma times_ok {rules l} (known : obeyed rules l) P Q : at_ l (times rules P Q) = at_ l P * at_ l Q.
Proof. unfold times. destruct P, Q; rewrite ?reduced_ok by exact known; apply pmul_ok. Qed.

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

(* Of an expression, or of its inverse, if it is seen not to be 0. *)
Fixpoint fraction_of (rules : Rules) (ds : list Polynomial) (inverse : bool) (e : expression) : option fraction :=
  let finish f := if inverse then inverted rules ds f else Some f in
  let two op a b :=
    match fraction_of rules ds false a, fraction_of rules ds false b with Some f, Some g => finish (op f g) | _, _ => None end in
  match e with
  | Number z => finish (fnumber z)
  | Letter k => finish (fletter k)
  | Plus a b => two (fplus rules ds) a b
  | Minus a b => two (fun f g => fplus rules ds f (fopposite g)) a b
  | Times a b =>
      match fraction_of rules ds inverse a, fraction_of rules ds inverse b with
      | Some f, Some g => Some (ftimes rules f g)
      | _, _ => if inverse then two (ftimes rules) a b else None
      end
  | Opposite a => option_map fopposite (fraction_of rules ds inverse a)
  | Power a n => option_map (fun f => fpower rules f n) (fraction_of rules ds inverse a)
  | Inverse a =>
      match fraction_of rules ds true a with
      | Some f => if inverse then fraction_of rules ds false a else Some f
      | None => None
      end
  | Over a b =>
      match fraction_of rules ds inverse a, fraction_of rules ds true b, fraction_of rules ds (negb inverse) b with
      | Some f, Some _, Some g => Some (ftimes rules f g)
      | _, _, _ => None
      end
  end.
Lemma fraction_of_ok {rules l} (known : obeyed rules l) ds (nonzero : none_is_zero l ds) :
  forall e i f, fraction_of rules ds i e = Some f ->
  if i then value l e <> 0 /\ means l ds f (/ value l e) else means l ds f (value l e).
Proof.
  assert (finish : forall (i : bool) x f g, means l ds f x -> (if i then inverted rules ds f else Some f) = Some g ->
                   if i then x <> 0 /\ means l ds g (/ x) else means l ds g x).
  { intros [] x f g F E; [now apply (inverted_ok known ds nonzero f) | now injection E as <-]. }
  induction e as [z|k|a A b B|a A b B|a A b B|a A|a A|a A b B|a A n]; intros i f E; simpl in E |- *.
  - now apply (finish i _ (fnumber z)); [apply fnumber_ok|].
  - now apply (finish i _ (fletter k)); [apply fletter_ok|].
  - specialize (A false). specialize (B false). destruct (fraction_of rules ds false a) as [p|]; [|discriminate].
    destruct (fraction_of rules ds false b) as [q|]; [|discriminate].
    apply (finish i _ (fplus rules ds p q)); [|exact E]. now apply (fplus_ok known); [apply A | apply B].
  - pose proof (A i) as A1. pose proof (B i) as B1. pose proof (A false) as A2. pose proof (B false) as B2.
    destruct (fraction_of rules ds i a) as [p|], (fraction_of rules ds i b) as [q|];
      try (injection E as <-; specialize (A1 p eq_refl); specialize (B1 q eq_refl); destruct i;
        [ destruct A1 as [N A1], B1 as [M B1];
          split; [now apply Rmult_integral_contrapositive_currified|];
          replace (/ (value l a * value l b)) with (/ value l a * / value l b) by (field; now split);
          now apply (ftimes_ok known)
        | now apply (ftimes_ok known) ]);
      (destruct i; [|discriminate]);
      (destruct (fraction_of rules ds false a) as [p'|]; [|discriminate]);
      (destruct (fraction_of rules ds false b) as [q'|]; [|discriminate]);
      (apply (inverted_ok known ds nonzero (ftimes rules p' q')); [|exact E]); now apply (ftimes_ok known); [apply A2 | apply B2].
  - specialize (A false). specialize (B false). destruct (fraction_of rules ds false a) as [p|]; [|discriminate].
    destruct (fraction_of rules ds false b) as [q|]; [|discriminate].
    apply (finish i _ (fplus rules ds p (fopposite q))); [|exact E].
    apply (fplus_ok known); [now apply A | now apply fopposite_ok; apply B].
  - specialize (A i). destruct (fraction_of rules ds i a) as [p|]; [|discriminate]. injection E as <-.
    specialize (A p eq_refl). destruct i; [|now apply fopposite_ok].
    destruct A as [N A]. split; [now apply Ropp_neq_0_compat|].
    replace (/ - value l a) with (- / value l a) by (now field). now apply fopposite_ok.
  - pose proof (A true) as A1. pose proof (A false) as A2. destruct (fraction_of rules ds true a) as [p|]; [|discriminate].
    destruct (A1 p eq_refl) as [N M]. destruct i; [|now injection E as <-].
    split; [now apply Rinv_neq_0_compat|]. replace (/ / value l a) with (value l a) by (now field). now apply A2.
  - specialize (A i). pose proof (B true) as B1. pose proof (B (negb i)) as B2.
    destruct (fraction_of rules ds i a) as [p|]; [|discriminate]. destruct (fraction_of rules ds true b) as [r|]; [|discriminate].
    destruct (fraction_of rules ds (negb i) b) as [q|]; [|discriminate]. injection E as <-.
    specialize (A p eq_refl). destruct (B1 r eq_refl) as [N _]. specialize (B2 q eq_refl).
    unfold Rdiv. destruct i; simpl in B2.
    + destruct A as [M A]. split; [now apply Rmult_integral_contrapositive_currified; [|apply Rinv_neq_0_compat]|].
      replace (/ (value l a * / value l b)) with (/ value l a * value l b) by (field; now split).
      now apply (ftimes_ok known).
    + now apply (ftimes_ok known).
  - specialize (A i). destruct (fraction_of rules ds i a) as [p|]; [|discriminate]. injection E as <-.
    specialize (A p eq_refl). destruct i; [|now apply (fpower_ok known)].
    destruct A as [N A]. split; [now apply pow_nonzero|].
    rewrite Rinv_pow by exact N. now apply (fpower_ok known).
Qed.

Fixpoint nonzero_all (l : list R) (es : list expression) : Prop :=
  match es with nil => True | e :: es => value l e <> 0 /\ nonzero_all l es end.
Fixpoint collected (rules : Rules) (es : list expression) (ds : list Polynomial) : list Polynomial :=
  match es with
  | nil => ds
  | e :: es =>
      collected rules es
        match fraction_of rules ds false e with
        | Some f => match shape rules ds (over f) with Some _ => ds | None => ds ++ over f :: nil end
        | None => ds
        end
  end.
Lemma none_is_zero_app l ds P : none_is_zero l ds -> at_ l P <> 0 -> none_is_zero l (ds ++ P :: nil).
Proof. induction ds as [|d ds H]; simpl; [now split|]. intros [D N] Z. split; [exact D | now apply H]. Qed.
Lemma collected_ok rules l : obeyed rules l -> forall es ds,
  nonzero_all l es -> none_is_zero l ds -> none_is_zero l (collected rules es ds).
Proof.
  intros O. induction es as [|e es H]; intros ds E D; [exact D|]. destruct E as [N E]. simpl. apply (H _ E).
  destruct (fraction_of rules ds false e) as [f|] eqn:F; [|exact D].
  destruct (shape rules ds (over f)) as [_|]; [exact D|]. apply none_is_zero_app; [exact D|].
  apply (fraction_of_ok O ds D e false) in F. simpl in F. unfold means in F. rewrite F.
  apply Rmult_integral_contrapositive_currified; [exact N | now apply below_nonzero].
Qed.

Fixpoint where_nonzero (l : list R) (es : list expression) (C : Prop) : Prop :=
  match es with nil => C | e :: es => value l e <> 0 -> where_nonzero l es C end.
Fixpoint on_circles (l : list R) (cs : list (positive * positive)) (C : Prop) : Prop :=
  match cs with
  | nil => C
  | (c, s) :: cs => nth 0 c l * nth 0 c l = 1 - nth 0 s l * nth 0 s l -> on_circles l cs C
  end.
Definition identical (cs : list (positive * positive)) (es : list expression) (a b : expression) : bool :=
  let rules := rules_of cs in
  let ds := collected rules es (collected rules es nil) in
  match fraction_of rules ds false (Minus a b) with
  | Some f => peq (over f) (pconst 0)
  | None => false
  end.
Lemma identical_ok l cs es a b : identical cs es a b = true ->
  on_circles l cs (where_nonzero l es (value l a = value l b)).
Proof.
  intros I.
  assert (S : circles l cs -> nonzero_all l es -> value l a = value l b).
  { revert I. unfold identical. cbv zeta. intros I C E. apply rules_ok in C.
    assert (D : none_is_zero l (collected (rules_of cs) es (collected (rules_of cs) es nil))).
    { apply collected_ok; [exact C | exact E | apply collected_ok; [exact C | exact E | exact Logic.I]]. }
    revert I D. generalize (collected (rules_of cs) es (collected (rules_of cs) es nil)). intros ds I D.
    destruct (fraction_of _ ds false (Minus a b)) as [f|] eqn:F; [|discriminate].
    apply (fraction_of_ok C ds D (Minus a b) false) in F. simpl in F. unfold means in F.
    apply (peq_ok _ _) with (l := l) in I. rewrite F in I. unfold at_, pconst in I. simpl in I.
    apply Rminus_diag_uniq. apply (Rmult_eq_reg_r (below l ds f)); [|exact (below_nonzero l ds f D)].
    rewrite I. ring. }
  clear I. revert S. generalize (value l a = value l b). intros C S.
  assert (W : circles l cs -> where_nonzero l es C).
  { intros K. specialize (S K). clear K.
    induction es as [|e es H]; [exact (S Logic.I)|]. intros N. apply H. intros M. apply S. now split. }
  clear S. induction cs as [|[c s] cs H]; [exact (W Logic.I)|].
  intros K. apply H. intros M. apply W. now split.
Qed.

(* ---- an equation of numbers as one of expressions *)

Ltac abstracted xs t :=
  lazymatch xs with
  | nil => t
  | cons ?x ?rest =>
      let u := eval pattern x in t in
      lazymatch u with ?f _ => abstracted rest f end
  end.
Ltac applied_to_letters xs k t :=
  lazymatch xs with
  | nil => t
  | cons _ ?rest => let t := applied_to_letters rest (Pos.succ k) t in constr:(t (Letter k))
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
      let t := constr:(f expression Plus Times Minus Over Opposite Inverse Number Power) in
      let t := applied_to_letters xs 1%positive t in
      eval cbv beta delta [Pos.succ] iota in t
  end.
Ltac circles_in G xs :=
  lazymatch G with
  | ?c * _ = _ + _ * (?s * _) -> ?rest =>
      let i := place c xs 1%positive in
      let j := place s xs 1%positive in
      let cs := circles_in rest xs in
      constr:(cons (i, j) cs)
  | _ => constr:(@nil (positive * positive))
  end.
(* a, b and d, … of d <> 0 -> … -> a = b. *)
Ltac numbers_in G ds :=
  lazymatch G with
  | _ = _ + _ * _ -> ?rest => numbers_in rest ds
  | ?d <> 0 -> ?rest => numbers_in rest constr:(cons d ds)
  | ?a = ?b => constr:(cons a (cons b ds))
  end.
Ltac reversed xs ys :=
  lazymatch xs with cons ?x ?rest => reversed rest constr:(cons x ys) | nil => ys end.
Ltac by_fractions :=
  let xs := numbers_in_context (@nil R) in
  repeat match goal with N : _ <> 0 |- _ => revert N end;
  repeat match goal with K : ?c * ?c = 1 - ?s * ?s |- _ => revert K end;
  lazymatch goal with
  | |- ?G =>
      let cs := circles_in G xs in
      let ns := numbers_in G (@nil R) in
      let es := expressions xs ns in
      lazymatch es with
      | cons ?a (cons ?b ?hs) =>
          let hs := reversed hs (@nil expression) in
          let answer := eval vm_compute in (identical cs hs a b) in
          lazymatch answer with
          | true => vm_cast_no_check (identical_ok xs cs hs a b (@eq_refl bool true <: identical cs hs a b = true))
          end
      end
  end.
