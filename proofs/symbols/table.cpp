#include "proofs/symbols/table.hpp"

#include <atomic>

#include "core/error.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::symbols {

namespace {

using namespace vocabulary;

struct Name {
  std::string name;
  Shape shape;
  bool of_time;
  Name(const Term& symbol) : name(symbol.name()), shape(symbol.shape()), of_time(false) {}  // NOLINT
  Name(const Function& function)                                                            // NOLINT
      : name(function.name), shape(function.shape), of_time(true) {}
};
using Names = std::vector<Name>;

// Symbols that differ in their index alone, and so can be misprinted for each other.
struct Row {
  Names names;
  std::string defined_in = {}, formula_in = {};
  std::vector<Term> values = {};  // what each is
  std::vector<Names> letters =
      {};  // other rows: a misprint may take the k-th symbol of each for the k-th of this
  std::vector<Term> rates_of = {};  // of what each is the rate
  bool durations = false;
  std::vector<Term> means = {};  // what the kernel takes each for, a function at the time t
  bool motions = false;
};

// The upper half of a state, and the lower.
Term upper(const Term& state) {
  return block(1, {I2, zero(2, 2)}) * state;
}
Term lower(const Term& state) {
  return block(1, {zero(2, 2), I2}) * state;
}

Function of_time(const char * name) {
  return {name, {}};
}

// Of these there is no more to say than name and shape.
const Names& plain_names() {
  static const Names all = [] {
    Names names{chi, eta, V, omega, p, phi, pi(), t, s, t1, tau2, E, I2, I4};
    for (const char * name : {"cos", "sin", "exp", "sqrt", "abs", "sign", "Rtilde"}) {
      names.push_back(Function{name, {}});
    }
    for (const char * name :
         {"m1", "m2",  "k1",     "k2",     "ttilde",    "Omega",    "ptilde", "omegatilde", "Ftilde",
          "v0", "v2",  "x1",     "x2",     "xdot2",     "xddot1",   "xddot2", "u",          "s0",
          "c0", "z1",  "z2",     "z1B",    "z2B",       "z1C",      "z2C",    "delta",      "epsilon",
          "g",  "rho", "delta1", "delta2", "deltadot1", "deltadot2"}) {
      names.push_back(scalar(name));
    }
    return names;
  }();
  return all;
}

const std::vector<Row>& rows() {
  const Term zdot1C = scalar("zdot1C"), zdot2C = scalar("zdot2C");
  const Term phiB = scalar("phiB"), phiC = scalar("phiC"), load_at_B = omega * tau + phi;
  static const std::vector<Row> all{
      // Parameters and times.
      {.names = {us, ur}},
      {.names = {omega1, omega2}},
      {.names = {lambda1, lambda2}},
      {.names = {tau, tau1}, .durations = true},
      {.names = {T}, .durations = true},
      {.names = {Theta}, .durations = true},
      // Constant vectors and matrices.
      {.names = {K}, .defined_in = "39"},
      {.names = {Lambda}, .defined_in = "38"},
      {.names = {Sigma}, .defined_in = "41"},
      {.names = {psi1, psi2}, .defined_in = "39", .values = {column({1, lambda1}), column({1, lambda2})}},
      {.names = {d01, d02}, .formula_in = "6.d0"},
      {.names = {q1, q2}, .formula_in = "7"},
      {.names = {Q}, .values = {column({q1, q2})}},
      {.names = {d0}, .values = {column({d01, d02})}, .letters = {{Q}}},
      {.names = {delta0}, .defined_in = "52.X", .values = {column({d0, zero(2, 1)})}},
      // Functions of time.
      {.names = {H}, .defined_in = "6.H"},
      {.names = {H1, H2, H3}, .defined_in = "38"},
      {.names = {B1, B2, B3}, .defined_in = "38"},
      {.names = {Gamma}, .defined_in = "10.Gamma", .letters = {{H}}},
      {.names = {Gamma1, Gamma2, Gamma3}, .defined_in = "41", .letters = {{H1, H2, H3}}},
      {.names = {gamma1, gamma2, gamma3}, .defined_in = "41", .letters = {{B1, B2, B3}}},
      {.names = {F}, .defined_in = "5.F"},
      {.names = {R}, .defined_in = "5.F"},
      {.names = {L}, .defined_in = "8.L"},
      {.names = {Function{"tan", {}}}, .letters = {{Function{"cos", {}}}}},
      // The load and the states at 0, at tau (B) and at tau + tau_1 (C).
      {.names = {F0}, .defined_in = "5.F", .values = {F(0)}},
      {.names = {FB}, .defined_in = "28.F", .values = {F(tau)}, .letters = {{F0}}},
      {.names = {phiB, phiC}, .defined_in = "51.phi", .values = {load_at_B, load_at_B + omega * tau1}},
      {.names = {z10, z20}},
      {.names = {zdot10, zdot20}, .rates_of = {z10, z20}},
      {.names = {zdot1B}, .rates_of = {z1B}},
      {.names = {zdot2B}, .letters = {{zdot20}}, .rates_of = {z2B}},
      {.names = {zdot1C}, .rates_of = {z1C}},
      {.names = {zdot2C}, .letters = {{zdot20}, {zdot2B}}, .rates_of = {z2C}},
      {.names = {z0}, .values = {column({z10, z20})}},
      {.names = {zB}, .values = {column({z1B, z2B})}, .letters = {{z0}}},
      {.names = {zdot0}, .values = {column({zdot10, zdot20})}, .rates_of = {z0}},
      {.names = {zdotB}, .values = {column({zdot1B, zdot2B})}, .letters = {{zdot0}}, .rates_of = {zB}},
      {.names = {Z0}, .values = {column({z0, zdot0})}},
      {.names = {ZB}, .values = {column({zB, zdotB})}, .letters = {{Z0}}},
      {.names = {ZC}, .values = {column({z1C, z2C, zdot1C, zdot2C})}, .letters = {{Z0}, {ZB}}},
      // The motion in x, in z = x - d_0 and in z + 2 d_0.
      {.names = {X}, .motions = true},
      {.names = {Y}, .motions = true},
      {.names = {Function{"delta", {4, 1}}}, .motions = true},
      {.names = {Z}, .means = {X(t) - delta0}},
      {.names = {Zbar}, .means = {X(t) + delta0}},
      {.names = {of_time("x1"), of_time("x2"), of_time("xdot1"), of_time("xdot2")},
       .means = {component(0, X(t)), component(1, X(t)), component(2, X(t)), component(3, X(t))}},
      {.names = {of_time("y1"), of_time("y2"), of_time("ydot1"), of_time("ydot2")},
       .means = {component(0, Y(t)), component(1, Y(t)), component(2, Y(t)), component(3, Y(t))}},
      // x = z + d_0, and z + 2 d_0.
      {.names = {x0}, .defined_in = "52.X", .values = {z0 + d0}},
      {.names = {xB}, .defined_in = "52.X", .values = {zB + d0}, .letters = {{x0}}},
      {.names = {X0}, .defined_in = "52.X", .values = {Z0 + delta0}},
      {.names = {XB}, .defined_in = "52.X", .values = {ZB + delta0}, .letters = {{X0}}},
      {.names = {zbar0}, .defined_in = "55.bar", .values = {z0 + 2 * d0}},
      {.names = {zbarB}, .defined_in = "55.bar", .values = {zB + 2 * d0}, .letters = {{zbar0}}},
      {.names = {Zbar0}, .defined_in = "55.bar", .values = {Z0 + 2 * delta0}},
      {.names = {ZbarB}, .defined_in = "55.bar", .values = {ZB + 2 * delta0}, .letters = {{Zbar0}}},
      // (22), (34), (35).
      {.names = {Delta, Delta1, Delta2, Delta3},
       .defined_in = "22.Delta",
       .values = {determinant_of_columns({"a", "b", "c"}), determinant_of_columns({"-d", "b", "c"}),
                  determinant_of_columns({"d", "a", "c"}), determinant_of_columns({"d", "b", "a"})}},
      {.names = {phi1, phi2}, .formula_in = "35.def"},
      {.names = {d}, .formula_in = "35.def"},
      {.names = {a1, a2}, .formula_in = "35.def"},
      {.names = {b1, b2}, .formula_in = "35.def"},
      // Appendix 5.
      {.names = {rho1, rho2}, .formula_in = "70.rho"},
      {.names = {xi1, xi2},
       .defined_in = "57.xi",
       .values = {ZB - FB + E * (Z0 - F0), ZbarB - FB + E * (Zbar0 - F0)}},
      {.names = {X1, X2}, .defined_in = "57.xi", .values = {upper(xi1), upper(xi2)}},
      {.names = {Y1, Y2}, .defined_in = "57.xi", .values = {lower(xi1), lower(xi2)}},
      {.names = {P1, P2}, .defined_in = "63.P"},
      {.names = {P}, .defined_in = "64.P", .values = {P1 - P2}},
      {.names = {Ptilde}, .defined_in = "70.rho", .values = {block(2, {rho1, 0, 0, rho2})}},
  };
  return all;
}

// The symbols that stand beside this one in a row's `letters`, on either side.
std::vector<std::string> letters_for(const std::string& name) {
  std::vector<std::string> result;
  for (const Row& row : rows()) {
    for (const Names& above : row.letters) {
      for (std::size_t i = 0; i < above.size(); ++i) {
        if (row.names.at(i).name == name || above[i].name == name) {
          result.push_back(row.names[i].name == name ? above[i].name : row.names[i].name);
        }
      }
    }
  }
  return result;
}

void add(std::vector<Symbol>& symbols, const Row& row) {
  for (std::size_t i = 0; i < row.names.size(); ++i) {
    const Name& name = row.names[i];
    Symbol symbol{name.name, name.shape, name.of_time, row.defined_in, row.formula_in};
    for (const Name& other : row.names) {
      if (other.name != name.name) {
        symbol.other_indices.push_back(other.name);
      }
    }
    symbol.value = row.values.empty() ? std::nullopt : std::optional(row.values.at(i));
    symbol.other_letters = letters_for(name.name);
    symbol.rate_of = row.rates_of.empty() ? "" : row.rates_of.at(i).name();
    symbol.is_duration = row.durations;
    symbol.means = row.means.empty() ? std::nullopt : std::optional(row.means.at(i));
    symbol.is_motion = row.motions;
    symbols.push_back(std::move(symbol));
  }
}

// The column of four with 1 in place i, from 0.
Term unit(std::size_t i) {
  std::vector<Term> entries(4, Term(0));
  entries.at(i) = 1;
  return column(entries);
}

// What equation i of (21) says is zero, of slip on (0, tau), overshoot on (tau, tau + tau1), stick: the
// components z1, z2, z1' of Z_C - Gamma(-T) Z_0, then z2' - V at tau and at tau + tau1.
Term closing_gap(int i) {
  const Term after_slip = H(tau) * (Z0 - F0) + F(tau);                                   // (5)
  const Term after_both = H(tau + tau1) * (Z0 - F0) + 2 * L(tau1) * d0 + F(tau + tau1);  // and (8)
  return i <= 3 ? component(static_cast<std::size_t>(i - 1), after_both - Gamma(-T) * Z0)
                : component(3, i == 4 ? after_slip : after_both) - V;
}
// a_i, b_i, c_i are what stands beside z_1(0), z_2(0), z_1'(0) in it, with z_2'(0) = V, and d_i is the rest.
Term coefficient_of_gap(char letter, int i) {
  const auto at = [&](std::size_t unknown) {
    std::vector<Term> state{0, 0, 0, V};
    state[unknown] = unknown < 3 ? Term(1) : V;
    return substitute(closing_gap(i), {{"Z0", column(state)}});
  };
  return letter == 'd' ? at(3) : at(static_cast<std::size_t>(letter - 'a')) - at(3);
}

// The entries of Appendix 3: another index, or the same entry of another H.
void add_entries(std::vector<Symbol>& symbols, const std::string& letter, const Term& matrix) {
  for (int row = 1; row <= 4; ++row) {
    const Term of_row = component(static_cast<std::size_t>(row - 1), matrix);
    for (int column = 1; column <= 4; ++column) {
      const auto name = [](const std::string& of, int i, int j) { return Entries{of}(i, j).name(); };
      Symbol symbol{name(letter, row, column)};
      symbol.value = of_row * unit(static_cast<std::size_t>(column - 1));
      for (int i = 1; i <= 4; ++i) {
        symbol.other_indices.push_back(name(letter, i, column));
        symbol.other_indices.push_back(name(letter, row, i));
      }
      if (letter != "Gamma") {
        for (const char * other : {"H", "h", "Htilde"}) {
          symbol.other_indices.push_back(name(other, row, column));
        }
      }
      std::erase(symbol.other_indices, symbol.name);
      symbols.push_back(std::move(symbol));
    }
  }
}

Symbols symbols_of_oscillator() {
  std::vector<Symbol> symbols;
  for (const Row& row : rows()) {
    add(symbols, row);
  }
  for (const char letter : {'a', 'b', 'c', 'd'}) {
    Row row{.names = {}};
    for (int i = 1; i <= 5; ++i) {
      row.names.push_back(coefficient(letter, i));
      row.means.push_back(coefficient_of_gap(letter, i));
    }
    add(symbols, row);
  }
  add_entries(symbols, "H", H(tau));
  add_entries(symbols, "h", H(tau1));
  add_entries(symbols, "Htilde", H(tau + tau1));
  add_entries(symbols, "Gamma", Gamma(T));
  for (const Name& name : plain_names()) {
    add(symbols, {.names = {name}});
  }
  return Symbols(std::move(symbols));
}

const Vocabulary& oscillator() {
  static const auto at_least = [](const Term& lower, const Term& upper) {
    return Statement{lower, upper, Relation::less};
  };
  static const Vocabulary vocabulary(symbols_of_oscillator(),
                                     {at_least(0, omega1), at_least(omega1, 1), at_least(1, omega2),
                                      at_least(0, omega), at_least(0, us), at_least(0, ur)},
                                     true);
  return vocabulary;
}

thread_local const Vocabulary * in_force = nullptr;

}  // namespace

Symbols::Symbols(std::vector<Symbol> rows) : rows_(std::move(rows)) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    std::vector<std::size_t>& places = places_[rows_[i].name];
    if (std::ranges::any_of(places, [&](std::size_t k) {
          return rows_[k].shape == rows_[i].shape && rows_[k].of_time == rows_[i].of_time;
        })) {
      throw InternalError("the symbol " + rows_[i].name + " stands twice in the table");
    }
    places.push_back(i);
  }
}

const Symbol * Symbols::find(const Term& term) const {
  if (term.op() != Op::symbol && term.op() != Op::function) {
    return nullptr;
  }
  const auto found = places_.find(term.name());
  static const std::vector<std::size_t> none;
  for (const std::size_t k : found == places_.end() ? none : found->second) {
    if (rows_[k].shape == term.shape() && rows_[k].of_time == (term.op() == Op::function)) {
      return &rows_[k];
    }
  }
  return nullptr;
}

Vocabulary::Vocabulary(Symbols table, std::vector<Statement> domain, bool of_model)
    : table_(std::move(table)), domain_(std::move(domain)), of_model_(of_model) {
  static std::atomic<std::size_t> count = 0;
  number_ = count++;
}

const Vocabulary& vocabulary_here() {
  return in_force != nullptr ? *in_force : oscillator();
}

InVocabulary::InVocabulary(std::shared_ptr<const Vocabulary> vocabulary)
    : vocabulary_(std::move(vocabulary)), before_(in_force) {
  in_force = vocabulary_ ? vocabulary_.get() : before_;
}
InVocabulary::~InVocabulary() {
  in_force = before_;
}

const Symbols& symbol_table() {
  return vocabulary_here().table();
}

std::optional<Term> abbreviated(const Term& term) {
  const Symbol * symbol = term.shape().is_scalar() ? symbol_table().find(term) : nullptr;
  return symbol == nullptr ? std::nullopt : symbol->value ? symbol->value : symbol->means;
}

std::set<std::string> definitions_in(const Term& term) {
  std::set<std::string> result;
  if (const Symbol * symbol = symbol_table().find(term)) {
    if (!symbol->defined_in.empty()) {
      result.insert(symbol->defined_in);
    } else if (symbol->value) {
      result = definitions_in(*symbol->value);
    }
  }
  for (const Term& argument : term.arguments()) {
    result.merge(definitions_in(argument));
  }
  return result;
}

}  // namespace stickslip::proofs::symbols
