(* Derivatives, continuity on closed intervals, finite sets, and what follows from them. *)
From Stickslip Require Export Algebra.
From Coquelicot Require Export Coquelicot.
From Coq Require Import FunctionalExtensionality.
Open Scope R_scope.

(* ---- what is said *)

(* f is differentiable at p, and f'(p) = v; of a matrix, entry by entry. *)
Definition derivative (f : R -> R) (p v : R) : Prop := is_derive f p v.
Definition derivative_m {r c : nat} (f : R -> Mat r c) (p : R) (v : Mat r c) : Prop :=
  forall i j, (i < r)%nat -> (j < c)%nat -> derivative (fun t => ent i j (f t)) p (ent i j v).

(* f, restricted to the closed interval [a, b], is continuous. *)
Definition continuous_on (f : R -> R) (a b : R) : Prop :=
  forall t, a <= t <= b -> forall eps, 0 < eps ->
    exists delta, 0 < delta /\ forall s, a <= s <= b -> Rabs (s + -1 * t) < delta -> Rabs (f s + -1 * f t) < eps.
Definition continuous_on_m {r c : nat} (f : R -> Mat r c) (a b : R) : Prop :=
  forall i j, (i < r)%nat -> (j < c)%nat -> continuous_on (fun t => ent i j (f t)) a b.

(* Finitely many numbers have the property. *)
Definition finite (A : R -> Prop) : Prop := exists l : list R, forall t, A t -> In t l.

(* Every complex zero of c0 + c1 z + ... + cn z^n, the coefficients a column, is inside the unit circle. *)
Fixpoint polynomial (n : nat) : Mat n 1 -> C -> C :=
  match n with O => fun _ _ => RtoC 0 | S m => fun c z => Cplus (RtoC (fst (fst c))) (Cmult z (polynomial m (snd c) z)) end.
Definition inside_unit_circle {n : nat} (c : Mat n 1) : Prop :=
  forall z : C, polynomial n c z = RtoC 0 -> Cmod z < 1.

(* ---- matrices by entries *)

Lemma vnth_const : forall c j, vnth 0 c j (vconst 0 c) = 0.
Proof. induction c; intros []; simpl; auto. Qed.
Lemma vequal_entries : forall c (a b : Vec R c), (forall j, (j < c)%nat -> vnth 0 c j a = vnth 0 c j b) -> a = b.
Proof.
  induction c; simpl; intros [] [] E; [reflexivity|]. f_equal.
  - apply (E 0%nat). lia.
  - apply IHc. intros j L. apply (E (S j)). lia.
Qed.
Lemma mequal_entries : forall r c (A B : Mat r c),
  (forall i j, (i < r)%nat -> (j < c)%nat -> ent i j A = ent i j B) -> A = B.
Proof.
  unfold ent, Mat. induction r; simpl; intros c [] [] E; [reflexivity|]. f_equal.
  - apply vequal_entries. intros j L. apply (E 0%nat j); [lia | exact L].
  - apply IHr. intros i j L M. apply (E (S i) j); [lia | exact M].
Qed.
(* A function with values in columns of four is four functions. *)
Lemma four_functions : forall X : R -> Mat 4 1, exists x1 x2 x3 x4 : R -> R,
  X = fun t => mat 4 1 ⟦⟦x1 t⟧, ⟦x2 t⟧, ⟦x3 t⟧, ⟦x4 t⟧⟧.
Proof.
  intros X.
  exists (fun t => ent 0 0 (X t)), (fun t => ent 1 0 (X t)), (fun t => ent 2 0 (X t)), (fun t => ent 3 0 (X t)).
  apply functional_extensionality. intros t. destruct (X t) as [[? []] [[? []] [[? []] [[? []] []]]]].
  reflexivity.
Qed.

(* ---- derivatives of sums, products, … *)

Lemma d_value : forall f p u v, derivative f p u -> u = v -> derivative f p v.
Proof. intros. now subst. Qed.
Lemma d_const : forall k p, derivative (fun _ => k) p 0.
Proof. intros. apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule)). Qed.
Lemma d_id : forall p, derivative (fun t => t) p 1.
Proof. intros. apply (is_derive_id (K := R_AbsRing)). Qed.
Lemma d_plus : forall f g p u v, derivative f p u -> derivative g p v ->
  derivative (fun t => f t + g t) p (u + v).
Proof. intros. now apply (is_derive_plus (K := R_AbsRing) (V := R_NormedModule)). Qed.
Lemma d_mult : forall f g p u v, derivative f p u -> derivative g p v ->
  derivative (fun t => f t * g t) p (u * g p + f p * v).
Proof. intros. apply (is_derive_mult (K := R_AbsRing)); auto. intros; apply Rmult_comm. Qed.
Lemma d_comp : forall f u p w du, derivative f (u p) w -> derivative u p du ->
  derivative (fun t => f (u t)) p (w * du).
Proof.
  intros. rewrite Rmult_comm. now apply (is_derive_comp (K := R_AbsRing) (V := R_NormedModule)).
Qed.
Lemma d_inv : forall f p u, derivative f p u -> f p <> 0 -> derivative (fun t => / f t) p ((-1) * u * / f p * / f p).
Proof.
  intros f p u D N. eapply d_value; [apply (is_derive_inv f p u D N)|]. field. exact N.
Qed.
Lemma d_cos : forall f p u, derivative f p u -> derivative (fun t => cos (f t)) p ((-1) * sin (f p) * u).
Proof.
  intros. apply (d_comp cos f); [|assumption]. eapply d_value; [apply is_derive_cos|]. ring.
Qed.
Lemma d_sin : forall f p u, derivative f p u -> derivative (fun t => sin (f t)) p (cos (f p) * u).
Proof. intros. apply (d_comp sin f); [apply is_derive_sin|assumption]. Qed.
Lemma d_exp : forall f p u, derivative f p u -> derivative (fun t => exp (f t)) p (exp (f p) * u).
Proof. intros. apply (d_comp exp f); [apply is_derive_exp|assumption]. Qed.
Lemma d_pow : forall f n p u, derivative f p u -> derivative (fun t => f t ^ n) p (INR n * u * f p ^ pred n).
Proof. intros. now apply is_derive_pow. Qed.

Ltac derive :=
  match goal with
  | D : derivative ?f ?p _ |- derivative ?f ?p _ => exact D
  | |- derivative (fun t => t) _ _ => apply d_id
  | |- derivative (fun t => ?k) _ _ => apply (d_const k)
  | |- derivative (fun t => @?f t + @?g t) _ _ => eapply (d_plus f g); [derive | derive]
  | |- derivative (fun t => @?f t * @?g t) _ _ => eapply (d_mult f g); [derive | derive]
  | |- derivative (fun t => cos (@?f t)) _ _ => eapply (d_cos f); derive
  | |- derivative (fun t => sin (@?f t)) _ _ => eapply (d_sin f); derive
  | |- derivative (fun t => exp (@?f t)) _ _ => eapply (d_exp f); derive
  | |- derivative (fun t => / @?f t) _ _ => eapply (d_inv f); [derive | cbv beta; nonzero]
  | |- derivative (fun t => @?f t ^ ?n) _ _ => eapply (d_pow f n); derive
  | D : forall j, derivative (?z j) ?p _ |- derivative (fun t => ?z ?k t) ?p _ => exact (D k)
  | |- derivative (fun t => ?x (@?u t)) _ _ => eapply (d_comp x u); [cbv beta; eassumption | derive]
  | _ => eassumption
  end.

(* The entries of what is known and of what is to be shown. *)
Ltac premise_entry P i j :=
  let Q := fresh in
  assert (Q := P i j); reduce_matrices_in Q;
  specialize (Q ltac:(repeat constructor) ltac:(repeat constructor)).

(* ---- the mean value theorem, for functions continuous on a closed interval only *)

Definition clamp (a b t : R) : R := Rmax a (Rmin b t).
Lemma clamp_within : forall a b t, a <= b -> a <= clamp a b t <= b.
Proof. intros. unfold clamp, Rmax, Rmin. repeat destruct Rle_dec; lra. Qed.
Lemma clamp_same : forall a b t, a <= t <= b -> clamp a b t = t.
Proof. intros. unfold clamp, Rmax, Rmin. repeat destruct Rle_dec; lra. Qed.
Lemma clamp_near : forall a b s t, Rabs (clamp a b s + -1 * clamp a b t) <= Rabs (s + -1 * t).
Proof.
  intros. unfold clamp, Rmax, Rmin, Rabs. repeat destruct Rle_dec; repeat destruct Rcase_abs; lra.
Qed.

Lemma clamp_continuous : forall f a b, a <= b -> continuous_on f a b ->
  forall t, continuity_pt (fun s => f (clamp a b s)) t.
Proof.
  intros f a b L C t eps P. destruct (C _ (clamp_within a b t L) eps P) as [delta [D N]].
  exists delta. split; [exact D|]. intros s [_ E]. unfold dist in *; simpl in *; unfold R_dist in *.
  replace (Rminus (f (clamp a b s)) (f (clamp a b t))) with (f (clamp a b s) + -1 * f (clamp a b t)) by ring.
  apply N; [now apply clamp_within|]. eapply Rle_lt_trans; [apply clamp_near|].
  replace (s + -1 * t) with (Rminus s t) by ring. exact E.
Qed.

Lemma clamp_derivative : forall f a b p v, a < p -> p < b -> derivative f p v ->
  derivative (fun s => f (clamp a b s)) p v.
Proof.
  intros f a b p v A B D. apply (is_derive_ext_loc f); [|exact D].
  assert (0 < Rmin (p + -1 * a) (b + -1 * p)) as P by (apply Rmin_glb_lt; lra).
  exists (mkposreal _ P). intros s E. rewrite clamp_same; [reflexivity|].
  unfold ball in E; simpl in E; unfold AbsRing_ball, abs, minus, plus, opp in E; simpl in E.
  pose proof (Rmin_l (p + -1 * a) (b + -1 * p)). pose proof (Rmin_r (p + -1 * a) (b + -1 * p)).
  unfold Rabs in E. destruct Rcase_abs in E; lra.
Qed.

Lemma mean_value : forall (f v : R -> R) a b, a < b -> continuous_on f a b ->
  (forall t, a < t < b -> derivative f t (v t)) ->
  exists c, a < c < b /\ f b + -1 * f a = v c * (b + -1 * a).
Proof.
  intros f v a b L C D.
  pose (g := fun s => f (clamp a b s)).
  assert (Dg : forall c, a < c < b -> derivative g c (v c)).
  { intros c [A B]. apply clamp_derivative; auto. }
  assert (P : forall c, a < c < b -> derivable_pt g c).
  { intros c I. exists (v c). apply is_derive_Reals. now apply Dg. }
  destruct (MVT g id a b P (fun c _ => derivable_pt_id c) L) as [c [I E]].
  - intros c _. apply clamp_continuous; [lra | exact C].
  - intros c _. apply derivable_continuous_pt, derivable_pt_id.
  - exists c. split; [exact I|].
    rewrite (derive_pt_eq_0 id c 1 _ (derivable_pt_lim_id c)) in E.
    rewrite (derive_pt_eq_0 g c (v c)) in E by (apply is_derive_Reals; now apply Dg).
    unfold g, id in E. rewrite !clamp_same in E by lra. lra.
Qed.

Lemma intermediate_value : forall (f : R -> R) a b, continuous_on f a b -> f a < 0 -> 0 < f b -> a < b ->
  exists c, a < c < b /\ f c = 0.
Proof.
  intros f a b C A B L.
  destruct (IVT (fun s => f (clamp a b s)) a b) as [c [I Z]].
  - intros t. apply clamp_continuous; [lra | exact C].
  - exact L.
  - rewrite clamp_same by lra. exact A.
  - rewrite clamp_same by lra. exact B.
  - rewrite clamp_same in Z by exact I. exists c. split; [|exact Z].
    assert (a <> c) by (intros ->; lra). assert (c <> b) by (intros ->; lra). lra.
Qed.

Lemma continuous_within : forall f a b c d, continuous_on f a b -> a <= c -> d <= b -> continuous_on f c d.
Proof.
  intros f a b c d C A B t I eps P. destruct (C t) with (eps := eps) as [delta [D N]]; [lra | exact P |].
  exists delta. split; [exact D|]. intros s J. apply N. lra.
Qed.
Lemma continuous_within_m : forall r k (f : R -> Mat r k) a b c d,
  continuous_on_m f a b -> a <= c -> d <= b -> continuous_on_m f c d.
Proof. intros r k f a b c d C A B i j I J. apply continuous_within with a b; auto. Qed.

(* Not decreasing, but perhaps at finitely many times: not smaller at the end. *)
Lemma monotone_list : forall (f : R -> R) (l : list R) a b, a <= b -> continuous_on f a b ->
  (forall t, a < t < b -> ~ In t l -> exists v, derivative f t v /\ 0 <= v) -> f a <= f b.
Proof.
  intros f l. induction l as [|x l IH]; intros a b L C D.
  - destruct (Req_dec a b) as [->|N]; [lra|].
    assert (exists v, forall t, a < t < b -> derivative f t (v t) /\ 0 <= v t) as [v V].
    { exists (fun t => Derive f t). intros t I. destruct (D t I) as [w [W P]]; [auto|].
      rewrite (is_derive_unique f t w W). auto. }
    destruct (mean_value f v a b) as [c [I E]]; [lra | exact C | apply V |].
    destruct (V c I) as [_ P].
    assert (0 <= v c * (b + -1 * a)) by (apply Rmult_le_pos; lra). lra.
  - destruct (Rlt_dec a x) as [A|A]; [destruct (Rlt_dec x b) as [B|B]|].
    + apply Rle_trans with (f x); apply IH; try lra.
      * apply continuous_within with a b; auto; lra.
      * intros t I N. apply D; [lra|]. intros [E|E]; [lra | auto].
      * apply continuous_within with a b; auto; lra.
      * intros t I N. apply D; [lra|]. intros [E|E]; [lra | auto].
    + apply IH; auto. intros t I N. apply D; [exact I|]. intros [E|E]; [lra | auto].
    + apply IH; auto. intros t I N. apply D; [exact I|]. intros [E|E]; [lra | auto].
Qed.

Lemma monotone : forall (f : R -> R) a b, continuous_on f a b ->
  finite (fun t => a < t < b /\ ~ (exists v, derivative f t v /\ 0 <= v)) -> a <= b -> f a <= f b.
Proof.
  intros f a b C [l F] L. apply (monotone_list f l); auto.
  intros t I N. apply NNPP. intros M. apply N, F. auto.
Qed.

Lemma c_opp : forall f a b, continuous_on f a b -> continuous_on (fun t => (-1) * f t) a b.
Proof.
  intros f a b C t I eps P. destruct (C t I eps P) as [delta [D N]]. exists delta. split; [exact D|].
  intros s J E. specialize (N s J E).
  replace ((-1) * f s + -1 * ((-1) * f t)) with (Ropp (f s + -1 * f t)) by ring. now rewrite Rabs_Ropp.
Qed.

Lemma constant_list : forall (f : R -> R) (l : list R) a b, continuous_on f a b ->
  (forall t, a < t < b -> ~ In t l -> derivative f t 0) -> forall t, a <= t <= b -> f t = f a.
Proof.
  intros f l a b C D t I.
  assert (C' : continuous_on f a t) by (apply continuous_within with a b; auto; lra).
  apply Rle_antisym.
  - cut ((-1) * f a <= (-1) * f t); [lra|].
    apply (monotone_list (fun s => (-1) * f s) l); [lra | now apply c_opp|].
    intros s J N. exists 0. split; [|lra]. eapply d_value.
    + apply (d_mult (fun _ => -1) f s 0 0); [apply d_const | apply D; [lra | exact N]].
    + ring.
  - apply (monotone_list f l); [lra | exact C'|].
    intros s J N. exists 0. split; [apply D; [lra | exact N] | lra].
Qed.

Lemma constant : forall (f : R -> R) a b, continuous_on f a b ->
  (forall t, a < t < b -> derivative f t 0) -> forall t, a <= t <= b -> f t = f a.
Proof. intros f a b C D. apply (constant_list f nil); auto. Qed.
Lemma constant_finite : forall (f : R -> R) a b, continuous_on f a b ->
  finite (fun t => a < t < b /\ ~ derivative f t 0) -> forall t, a <= t <= b -> f t = f a.
Proof.
  intros f a b C [l F]. apply (constant_list f l); auto.
  intros t I N. apply NNPP. intros M. apply N, F. auto.
Qed.

Lemma entry_of_zero : forall r c i j, ent i j (mzero r c) = 0.
Proof.
  unfold ent, mzero. induction r; intros c i j; simpl; [apply vnth_const|].
  destruct i; [apply vnth_const | apply IHr].
Qed.
Lemma constant_m : forall r c (f : R -> Mat r c) a b, continuous_on_m f a b ->
  (forall t, a < t < b -> derivative_m f t (mzero r c)) -> forall t, a <= t <= b -> f t = f a.
Proof.
  intros r c f a b C D t I. apply mequal_entries. intros i j L M.
  apply (constant (fun s => ent i j (f s)) a b); auto.
  intros s J. specialize (D s J i j L M). now rewrite entry_of_zero in D.
Qed.
Lemma finite_sub : forall A B : R -> Prop, finite A -> (forall t, B t -> A t) -> finite B.
Proof. intros A B [l F] I. exists l. auto. Qed.
Lemma constant_finite_m : forall r c (f : R -> Mat r c) a b, continuous_on_m f a b ->
  finite (fun t => a < t < b /\ ~ derivative_m f t (mzero r c)) -> forall t, a <= t <= b -> f t = f a.
Proof.
  intros r c f a b C F t I. apply mequal_entries. intros i j L M.
  apply (constant_finite (fun s => ent i j (f s)) a b); auto.
  apply (finite_sub _ _ F). intros s [J N]. split; [exact J|]. intros D. apply N.
  specialize (D i j L M). now rewrite entry_of_zero in D.
Qed.

(* ---- finite sets *)

Lemma finite_part : forall A B : R -> Prop, finite A -> (forall t, B t -> A t) -> finite B.
Proof. exact finite_sub. Qed.
Lemma finite_union : forall A B : R -> Prop, finite A -> finite B -> finite (fun t => A t \/ B t).
Proof. intros A B [l F] [m G]. exists (l ++ m). intros t [H|H]; apply in_or_app; auto. Qed.
Lemma finite_shift : forall (A : R -> Prop) c, finite A -> finite (fun t => A (t + c)).
Proof.
  intros A c [l F]. exists (map (fun s => s + -1 * c) l). intros t H. apply in_map_iff.
  exists (t + c). split; [ring | auto].
Qed.

(* ---- one derivative, and that of a function that agrees *)

Lemma unique_derivative : forall f p v w, derivative f p v -> derivative f p w -> v = w.
Proof. intros f p v w V W. now rewrite <- (is_derive_unique f p v V), <- (is_derive_unique f p w W). Qed.
Lemma unique_derivative_m : forall r c (f : R -> Mat r c) p v w,
  derivative_m f p v -> derivative_m f p w -> v = w.
Proof.
  intros r c f p v w V W. apply mequal_entries. intros i j L M.
  apply (unique_derivative (fun t => ent i j (f t)) p); auto.
Qed.
Lemma same_derivative : forall (f g : R -> R) p v a b, derivative f p v ->
  (forall t, a < t < b -> f t = g t) -> a < p -> p < b -> derivative g p v.
Proof.
  intros f g p v a b D E A B. apply (is_derive_ext_loc f); [|exact D].
  assert (0 < Rmin (p + -1 * a) (b + -1 * p)) as P by (apply Rmin_glb_lt; lra).
  exists (mkposreal _ P). intros s I. apply E.
  unfold ball in I; simpl in I; unfold AbsRing_ball, abs, minus, plus, opp in I; simpl in I.
  pose proof (Rmin_l (p + -1 * a) (b + -1 * p)). pose proof (Rmin_r (p + -1 * a) (b + -1 * p)).
  unfold Rabs in I. destruct Rcase_abs in I; lra.
Qed.
Lemma same_derivative_m : forall r c (f g : R -> Mat r c) p v a b, derivative_m f p v ->
  (forall t, a < t < b -> f t = g t) -> a < p -> p < b -> derivative_m g p v.
Proof.
  intros r c f g p v a b D E A B i j L M. apply (same_derivative (fun t => ent i j (f t)) _ p _ a b); auto.
  intros t I. now rewrite E.
Qed.

(* ---- continuity of sums, products, … *)

Lemma continuous_of_clamp : forall f a b, a <= b ->
  (forall t, continuity_pt (fun s => f (clamp a b s)) t) -> continuous_on f a b.
Proof.
  intros f a b L C t I eps P. destruct (C t eps P) as [delta [D N]]. exists delta. split; [exact D|].
  intros s J E. unfold dist in *; simpl in *; unfold R_dist in *.
  destruct (Req_dec t s) as [->|M]; [replace (f s + -1 * f s) with 0 by ring; now rewrite Rabs_R0|].
  specialize (N s). rewrite !clamp_same in N by assumption.
  replace (f s + -1 * f t) with (Rminus (f s) (f t)) by ring. apply N. split.
  - split; [exact Logic.I | exact M].
  - replace (Rminus s t) with (s + -1 * t) by ring. exact E.
Qed.
Lemma c_empty : forall f a b, b < a -> continuous_on f a b.
Proof. intros f a b L t I. lra. Qed.

Ltac by_clamp a b :=
  destruct (Rle_lt_dec a b); [apply continuous_of_clamp; [assumption|]; intros ? | now apply c_empty].

Lemma c_const : forall k a b, continuous_on (fun _ => k) a b.
Proof. intros. by_clamp a b. apply continuity_pt_const. intros ? ?. reflexivity. Qed.
Lemma c_id : forall a b, continuous_on (fun t => t) a b.
Proof.
  intros a b t I eps P. exists eps. auto.
Qed.
Lemma c_plus : forall f g a b, continuous_on f a b -> continuous_on g a b ->
  continuous_on (fun t => f t + g t) a b.
Proof.
  intros f g a b C D. by_clamp a b.
  apply (continuity_pt_plus (fun s => f (clamp a b s)) (fun s => g (clamp a b s))); now apply clamp_continuous.
Qed.
Lemma c_mult : forall f g a b, continuous_on f a b -> continuous_on g a b ->
  continuous_on (fun t => f t * g t) a b.
Proof.
  intros f g a b C D. by_clamp a b.
  apply (continuity_pt_mult (fun s => f (clamp a b s)) (fun s => g (clamp a b s))); now apply clamp_continuous.
Qed.
Lemma c_inv : forall f a b, continuous_on f a b -> (forall t, a <= t <= b -> f t <> 0) ->
  continuous_on (fun t => / f t) a b.
Proof.
  intros f a b C N. by_clamp a b.
  apply (continuity_pt_inv (fun s => f (clamp a b s))); [now apply clamp_continuous|].
  apply N. now apply clamp_within.
Qed.
Lemma c_comp : forall g f a b c d, continuous_on g c d -> continuous_on f a b ->
  (forall t, a <= t <= b -> c <= f t <= d) -> continuous_on (fun t => g (f t)) a b.
Proof.
  intros g f a b c d C D W t I eps P. destruct (C (f t) (W t I) eps P) as [delta [E N]].
  destruct (D t I delta E) as [small [F M]]. exists small. split; [exact F|]. intros s J L. apply N; auto.
Qed.
Lemma c_continuity : forall g f a b, (forall x, continuity_pt g x) -> continuous_on f a b ->
  continuous_on (fun t => g (f t)) a b.
Proof.
  intros g f a b C D. by_clamp a b.
  apply (continuity_pt_comp (fun s => f (clamp a b s)) g); [now apply clamp_continuous | apply C].
Qed.
Lemma c_cos : forall f a b, continuous_on f a b -> continuous_on (fun t => cos (f t)) a b.
Proof. intros. apply c_continuity; [apply continuity_cos | assumption]. Qed.
Lemma c_sin : forall f a b, continuous_on f a b -> continuous_on (fun t => sin (f t)) a b.
Proof. intros. apply c_continuity; [apply continuity_sin | assumption]. Qed.
Lemma c_exp : forall f a b, continuous_on f a b -> continuous_on (fun t => exp (f t)) a b.
Proof. intros. apply c_continuity; [apply derivable_continuous, derivable_exp | assumption]. Qed.
Lemma c_pow : forall f n a b, continuous_on f a b -> continuous_on (fun t => f t ^ n) a b.
Proof.
  intros f n a b C. induction n; [exact (c_const 1 a b)|]. exact (c_mult f (fun t => f t ^ n) a b C IHn).
Qed.

Ltac continuous :=
  match goal with
  | |- continuous_on (fun t => t) _ _ => apply c_id
  | |- continuous_on (fun t => ?k) _ _ => apply (c_const k)
  | |- continuous_on (fun t => @?f t + @?g t) _ _ => apply (c_plus f g); [continuous | continuous]
  | |- continuous_on (fun t => @?f t * @?g t) _ _ => apply (c_mult f g); [continuous | continuous]
  | |- continuous_on (fun t => cos (@?f t)) _ _ => apply (c_cos f); continuous
  | |- continuous_on (fun t => sin (@?f t)) _ _ => apply (c_sin f); continuous
  | |- continuous_on (fun t => exp (@?f t)) _ _ => apply (c_exp f); continuous
  | |- continuous_on (fun t => / @?f t) _ _ => apply (c_inv f); [continuous | cbv beta; intros; nonzero]
  | |- continuous_on (fun t => @?f t ^ ?n) _ _ => apply (c_pow f n); continuous
  | _ => eassumption
  | |- continuous_on (fun t => ?x (@?u t)) _ _ =>
      eapply (c_comp x u); [eassumption | continuous | cbv beta; first [eassumption | auto]]
  end.

(* ---- what certificates say *)

Ltac by_derivative := eapply d_value; [derive | cbv beta; cbn [INR pred]; first [ring | split_factors; field; nonzero]].

(* What is said of all entries, entry by entry. *)
Ltac each_index :=
  let i := fresh in
  let j := fresh in
  let I := fresh in
  let J := fresh in
  intros i j I J;
  repeat match goal with
         | H : (_ < 0)%nat |- _ => exfalso; inversion H
         | H : (?k < _)%nat |- _ =>
             is_var k; destruct k as [|k]; [clear H | apply PeanoNat.Nat.succ_lt_mono in H]
         end.

(* Functions made of others. *)
Lemma piecewise : forall (A : Type) (f g : R -> A) (c : R),
  exists X : R -> A, forall t : R, (t < c -> X t = f t) /\ (c <= t -> X t = g t).
Proof.
  intros A f g c. exists (fun t => if Rlt_dec t c then f t else g t). intros t.
  destruct (Rlt_dec t c) as [L|L]; split; intros H; auto; exfalso; lra.
Qed.
Lemma periodic : forall (A : Type) (f : R -> A) (p : R), 0 < p ->
  exists X : R -> A, (forall t : R, 0 <= t < p -> X t = f t) /\ (forall t : R, X (t + p) = X t).
Proof.
  intros A f p P. pose (turns := fun t => Int_part (Rdiv t p)).
  assert (turned : forall t n, IZR n * p <= t < (IZR n + 1) * p -> turns t = n).
  { intros t n [L U]. assert (E : t = Rdiv t p * p) by (unfold Rdiv; field; lra).
    rewrite E in L, U. apply Rmult_le_reg_r in L; [|exact P]. apply Rmult_lt_reg_r in U; [|exact P].
    unfold turns, Int_part. rewrite <- (tech_up (Rdiv t p) (n + 1)); [lia | |]; rewrite plus_IZR; lra. }
  assert (between : forall t, IZR (turns t) * p <= t < (IZR (turns t) + 1) * p).
  { intros t. unfold turns. destruct (base_Int_part (Rdiv t p)) as [L U].
    assert (E : t = Rdiv t p * p) by (unfold Rdiv; field; lra).
    split; [rewrite E at 2; apply Rmult_le_compat_r; lra | rewrite E at 1; apply Rmult_lt_compat_r; lra]. }
  exists (fun t => f (t + -1 * (IZR (turns t) * p))). split.
  - intros t I. rewrite (turned t 0%Z) by lra. f_equal. lra.
  - intros t. specialize (between t). rewrite (turned (t + p) (turns t + 1)%Z); rewrite plus_IZR; [f_equal; lra | lra].
Qed.
Lemma same_continuity : forall (f g : R -> R) a b, continuous_on f a b ->
  (forall t, a <= t <= b -> f t = g t) -> continuous_on g a b.
Proof.
  intros f g a b C E t I eps P. destruct (C t I eps P) as [delta [D N]]. exists delta. split; [exact D|].
  intros s J. rewrite <- (E s J), <- (E t I). exact (N s J).
Qed.
Lemma same_continuity_m : forall r k (f g : R -> Mat r k) a b, continuous_on_m f a b ->
  (forall t, a <= t <= b -> f t = g t) -> continuous_on_m g a b.
Proof.
  intros r k f g a b C E i j I J. apply same_continuity with (fun t => ent i j (f t)); [now apply C|].
  intros t T. now rewrite (E t T).
Qed.
Lemma continuous_union : forall f a b c, continuous_on f a b -> continuous_on f b c -> continuous_on f a c.
Proof.
  intros f a b c A B t I eps P. destruct (Rtotal_order t b) as [L|[E|L]].
  - destruct (A t) with (eps := eps) as [d [D N]]; [lra | exact P |].
    exists (Rmin d (b + -1 * t)). split; [apply Rmin_pos; lra|]. intros s J E.
    pose proof (Rmin_l d (b + -1 * t)). pose proof (Rmin_r d (b + -1 * t)).
    apply N; [|lra]. assert (F : Rabs (s + -1 * t) < b + -1 * t) by lra. apply Rabs_def2 in F. lra.
  - subst t. destruct (A b) with (eps := eps) as [d [D N]]; [lra | exact P |].
    destruct (B b) with (eps := eps) as [d' [D' N']]; [lra | exact P |].
    exists (Rmin d d'). split; [now apply Rmin_pos|]. intros s J E.
    pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
    destruct (Rle_dec s b); [apply N | apply N']; lra.
  - destruct (B t) with (eps := eps) as [d [D N]]; [lra | exact P |].
    exists (Rmin d (t + -1 * b)). split; [apply Rmin_pos; lra|]. intros s J E.
    pose proof (Rmin_l d (t + -1 * b)). pose proof (Rmin_r d (t + -1 * b)).
    apply N; [|lra]. assert (F : Rabs (s + -1 * t) < t + -1 * b) by lra. apply Rabs_def2 in F. lra.
Qed.
Lemma continuous_union_m : forall r k (f : R -> Mat r k) a b c,
  continuous_on_m f a b -> continuous_on_m f b c -> continuous_on_m f a c.
Proof. intros r k f a b c A B i j I J. apply continuous_union with b; auto. Qed.
Lemma finite_point : forall a : R, finite (fun t => t = a).
Proof. intros a. exists (a :: nil)%list. intros t E. left. now symmetry. Qed.
