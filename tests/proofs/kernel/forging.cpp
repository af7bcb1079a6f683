// Attempts to make a Theorem without a rule. With FORGE the compiler must refuse each line that ends in a
// remark "error:", for the reason given there (forging.cmake looks); without, the file compiles.
#include <bit>
#include <memory>
#include <type_traits>

#include "proofs/kernel/theorem.hpp"

using namespace stickslip::proofs::kernel;

static_assert(!std::is_default_constructible_v<Theorem>);
static_assert(!std::is_aggregate_v<Theorem>);
static_assert(!std::is_trivially_copyable_v<Theorem>);
static_assert(!std::is_polymorphic_v<Theorem> && std::is_final_v<Theorem>);
static_assert(!std::is_constructible_v<Theorem, Formula>);
static_assert(!std::is_constructible_v<Theorem, Sequent>);
static_assert(!std::is_constructible_v<Theorem, Formulas, Formula>);
static_assert(!std::is_constructible_v<Theorem, Step, Formulas, Formula>);
static_assert(!std::is_constructible_v<Theorem, Step>);
static_assert(!std::is_constructible_v<Theorem, Theorem, Formula>);
static_assert(!std::is_convertible_v<Sequent, Theorem>);
static_assert(!std::is_constructible_v<Theorem, std::shared_ptr<Sequent>>);
static_assert(!std::is_constructible_v<Theorem, std::nullptr_t>);
static_assert(!std::is_default_constructible_v<Term> && !std::is_default_constructible_v<Definition>);
static_assert(!std::is_constructible_v<Term, double> && !std::is_constructible_v<Term, bool>);
static_assert(!std::is_constructible_v<Term, const char *>);
// What a moved-from object would be: a copy is made instead.
static_assert(!std::is_nothrow_move_constructible_v<Term> || std::is_nothrow_copy_constructible_v<Term>);

const Formula claimed = any({});

#ifdef FORGE
// clang-format off
const Theorem by_constructor(Step{.rule = "oracle"}, {}, claimed);           // error: private
const Theorem by_step(Step{.rule = "oracle"}, claimed);                      // error: private
const Theorem of_nothing;                                                    // error: no matching
const Theorem of_sequent = Sequent{{}, claimed};                             // error: conver|no viable
const Theorem by_braces = {Step{.rule = "oracle"}, Formulas{}, claimed};     // error: private
struct Derived : Theorem {};                                                 // error: final
template <class T>
struct Reader {
  static T forge() { return T(Step{.rule = "oracle"}, Formulas{}, claimed); }  // error: private
};
const Theorem by_template = Reader<Theorem>::forge();
void empty(Theorem& theorem) { theorem.hypotheses().clear(); }               // error: qualifiers|const
void assign(Theorem& theorem) { theorem.conclusion() = claimed; }            // error: qualifiers|const|no match
void reassign(Theorem& theorem) { theorem.sequent().hypotheses = {}; }       // error: qualifiers|const|no match
void replace(Theorem& theorem) { theorem.data_ = nullptr; }                  // error: private
Theorem Theorem::oracle(const Formula& formula) { return assume(formula); }  // error: declar
struct Layout { void* pointers[2]; };
const Theorem by_bits = std::bit_cast<Theorem>(Layout{});                    // error: no matching|bit_cast
const Theorem::Data data{{{}, claimed}, nullptr};                            // error: private
const Definition undefined;                                                  // error: no matching
const Term of_null{std::shared_ptr<const Node>()};                           // error: private|no matching
namespace stickslip::proofs::kernel {
struct Node { static Term forge(); };                                        // error: redefinition
struct Before { bool operator()(const Term&, const Term&) const; };          // error: redefinition
}
void change(Number& number) { number.value().get_den() = 0; }                // error: qualifiers|const|no match
const Number floating = 0.1;                                                 // error: deleted|conversion|ambiguous
#endif
