#include "cli/answers/machine_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <utility>
#include <vector>

#include "core/ball.hpp"
#include "core/decimal.hpp"
#include "core/error.hpp"

namespace stickslip::cli {

using numeric::machines::Machine;

namespace {

constexpr long most_masses = 100;
constexpr long greatest_multiple = 1000;

class Reader {
 public:
  // Where a path leads stands its value, if there is one.
  struct Place {
    std::string path;
    std::optional<Rational> value = {};
    const toml::node * node = nullptr;
    std::optional<Rational> found = {};  // what stands there
  };

  Reader(const std::string& text, std::string file, std::vector<Place> places = {})
      : file_(std::move(file)), places_(std::move(places)) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      lines_.push_back(line);
    }
    try {
      root_ = toml::parse(text, file_);
    } catch (const toml::parse_error& error) {
      throw UsageError(fmt::format("{}, line {}: {}", file_, error.source().begin.line, error.description()));
    }
    for (Place& place : places_) {
      place.node = place.path == base_frequency ? nullptr : node_at(place.path);
      for (const Place * other = places_.data(); other != &place; ++other) {
        if (other->node == place.node || (is_frequency(*other) && is_frequency(place))) {
          throw UsageError(
              fmt::format("{}: {} and {} vary together: give one of them", file_, other->path, place.path));
        }
      }
    }
  }

  MachineInTables read() {
    require_keys(root_, "", {"units", "mass", "spring", "belt", "friction", "load"});
    MachineInTables result;
    result.in_SI = read_units();
    auto& o = result.machine.oscillator;
    for (const toml::table * mass : tables("mass")) {
      require_keys(*mass, "mass", {"m"});
      o.masses.push_back(number(*mass, "mass", "m"));
    }
    const std::size_t n = o.masses.size();
    if (n == 0 || n > static_cast<std::size_t>(most_masses)) {
      throw UsageError(fmt::format("{}: {} masses; 1 to {} are possible", file_, n, most_masses));
    }
    const auto size = static_cast<Eigen::Index>(n);
    o.stiffness = model::MatrixX<Rational>::Constant(size, size, Rational(0));
    o.damping = o.stiffness;
    for (const toml::table * spring : tables("spring")) {
      read_spring(*spring, o);
    }
    const toml::table& belt = table(root_, "belt");
    require_keys(belt, "belt", {"mass", "velocity"});
    o.rubbing = mass(belt, "belt", n);
    o.V = number(belt, "belt", "velocity");
    read_friction(o);
    read_loads(result.machine);
    for (const Place& place : places_) {
      if (!place.found) {
        refuse_to_vary(place);
      }
    }
    require_machine(result.machine);
    return result;
  }

  // What stands in the file where the only path leads.
  Rational value() {
    (void)read();
    return *places_.front().found;
  }

 private:
  static constexpr const char * base_frequency = "frequency";
  // Of a load alone, or of all.
  static bool is_frequency(const Place& place) { return place.path.ends_with(base_frequency); }

  [[noreturn]] void refuse_to_vary(const Place& place) const {
    throw UsageError(fmt::format("{}: {} is no number that can vary", file_, place.path));
  }

  [[nodiscard]] const toml::node * node_at(const std::string& path) const {
    const toml::node * node = &root_;
    std::istringstream parts(path);
    for (std::string part; node != nullptr && std::getline(parts, part, '.');) {
      if (const toml::array * list = node->as_array()) {
        const bool is_number =
            !part.empty() && part.size() < 6 && part.find_first_not_of("0123456789") == std::string::npos;
        const std::size_t k = is_number ? std::stoul(part) : 0;
        node = k >= 1 && k <= list->size() ? list->get(k - 1) : nullptr;
      } else {
        node = node->is_table() ? node->as_table()->get(part) : nullptr;
      }
    }
    if (node == nullptr) {
      throw UsageError(
          fmt::format("{}: nothing stands at {}; such as belt.velocity, mass.1.m, spring.1.k, "
                      "load.1.amplitude, friction.at_rest, friction.sliding.2.1, frequency do",
                      file_, path));
    }
    return node;
  }

  [[noreturn]] void refuse(const toml::node& at, const std::string& what) const {
    throw UsageError(fmt::format("{}, line {}: {}", file_, at.source().begin.line, what));
  }

  // The text of a value, from the file: its exact digits.
  [[nodiscard]] std::string text_of(const toml::node& node) const {
    const toml::source_region& where = node.source();
    const std::string& line = lines_.at(where.begin.line - 1);
    const std::size_t from = where.begin.column - 1;
    const std::size_t to = where.end.line == where.begin.line ? where.end.column - 1 : line.size();
    std::string text = from < line.size() ? line.substr(from, to - from) : "";
    std::erase(text, '_');
    return text;
  }

  [[nodiscard]] Place * place_of(const toml::node& node) const {
    const auto place = std::ranges::find(places_, &node, &Place::node);
    return place == places_.end() ? nullptr : &*place;
  }

  [[nodiscard]] Rational number(const toml::node& node, const std::string& name) const {
    std::string text;
    if (const auto * quoted = node.as_string()) {
      text = quoted->get();
    } else if (node.is_number()) {
      text = text_of(node);
    } else {
      refuse(node, fmt::format("{} is no number", name));
    }
    Rational value;
    try {
      value = parse_rational(text);
    } catch (const UsageError& error) {
      refuse(node, fmt::format("{}: {}", name, error.what()));
    }
    // The text is found by its place in the file; the number that was parsed says that it is this one.
    const std::optional<double> parsed = node.is_number() ? node.value<double>() : std::nullopt;
    if (parsed && std::abs(value.get_d() - *parsed) > 1e-12 * std::abs(*parsed)) {
      refuse(node, fmt::format("{} = {} cannot be read exactly: write it in quotes", name, *parsed));
    }
    if (Place * place = place_of(node)) {
      place->found = value;
      if (place->value) {
        value = *place->value;
        text = to_string(Ball(value), 3);
        text.erase(std::min(text.size(), text.find(" ±")));
      }
    }
    // Beyond, doubles end, in which motions are followed.
    static const Rational greatest = parse_rational("1e100"), least = parse_rational("1e-100");
    if (value != 0 && (abs(value) > greatest || abs(value) < least)) {
      refuse(node, fmt::format("{} = {}: the size of a number is from 1e-100 to 1e100, or 0", name, text));
    }
    return value;
  }
  // One that says which or how many, and does not vary.
  [[nodiscard]] Rational fixed_number(const toml::node& node, const std::string& name) const {
    if (const Place * place = place_of(node)) {
      refuse_to_vary(*place);
    }
    return number(node, name);
  }
  [[nodiscard]] Rational number(const toml::table& in, const std::string& of, const char * key) const {
    const toml::node * node = in.get(key);
    if (node == nullptr) {
      refuse(in, fmt::format("{} is missing in {}", key, of));
    }
    return number(*node, key);
  }
  [[nodiscard]] Rational number_or_zero(const toml::table& in, const std::string& of,
                                        const char * key) const {
    return in.contains(key) ? number(in, of, key) : Rational(0);
  }

  [[nodiscard]] const toml::table& table(const toml::table& in, const char * key) const {
    const toml::node * node = in.get(key);
    if (node == nullptr) {
      throw UsageError(fmt::format("{}: there is no table [{}]", file_, key));
    }
    if (!node->is_table()) {
      refuse(*node, fmt::format("{} is no table: write [{}]", key, key));
    }
    return *node->as_table();
  }

  [[nodiscard]] std::vector<const toml::table *> tables(const char * key) const {
    std::vector<const toml::table *> result;
    const toml::node * node = root_.get(key);
    if (node == nullptr) {
      return result;
    }
    if (!node->is_array_of_tables()) {
      refuse(*node, fmt::format("{} is no list of tables: write [[{}]]", key, key));
    }
    for (const toml::node& one : *node->as_array()) {
      result.push_back(one.as_table());
    }
    return result;
  }

  void require_keys(const toml::table& in, const std::string& of,
                    std::initializer_list<std::string_view> known) const {
    for (const auto& [key, value] : in) {
      if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
        refuse(value, fmt::format("'{}' is not known{}: it may be {}", key.str(),
                                  of.empty() ? "" : " in " + of, fmt::join(known, ", ")));
      }
    }
  }

  // A mass by its number, counted from 1 in the file.
  [[nodiscard]] std::size_t mass(const toml::table& in, const std::string& of, std::size_t count) const {
    if (!in.contains("mass")) {
      refuse(in, fmt::format("mass is missing in {}", of));
    }
    const Rational given = fixed_number(*in.get("mass"), "mass");
    if (given.get_den() != 1 || given < 1 || given > static_cast<long>(count)) {
      refuse(*in.get("mass"), fmt::format("mass = {}: it is a number from 1 to {}", to_string(given), count));
    }
    return given.get_num().get_ui() - 1;
  }

  [[nodiscard]] bool read_units() const {
    const toml::node * node = root_.get("units");
    if (node == nullptr) {
      return true;
    }
    const auto * text = node->as_string();
    if (text == nullptr || (text->get() != "SI" && text->get() != "none")) {
      refuse(*node, "units is \"SI\" or \"none\"");
    }
    return text->get() == "SI";
  }

  void read_spring(const toml::table& spring, model::FrictionOscillator<Rational>& o) const {
    require_keys(spring, "spring", {"between", "k", "c"});
    const toml::node * between = spring.get("between");
    const toml::array * ends = between == nullptr ? nullptr : between->as_array();
    if (ends == nullptr || ends->size() != 2) {
      refuse(spring, "a spring is between two: between = [0, 1], 0 being the wall");
    }
    std::array<long, 2> at{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Rational given = fixed_number((*ends)[i], "between");
      if (given.get_den() != 1 || given < 0 || given > static_cast<long>(o.size())) {
        refuse(*between, fmt::format("between {}: a mass is a number from 1 to {}, the wall is 0",
                                     to_string(given), o.size()));
      }
      at[i] = given.get_num().get_si();
    }
    if (at[0] == at[1]) {
      refuse(*between, "a spring is between two different ones");
    }
    if (!spring.contains("k") && !spring.contains("c")) {
      refuse(spring, "a spring has a stiffness k, or a dashpot c, or both");
    }
    const auto add = [&](model::MatrixX<Rational>& A, const char * key) {
      const Rational value = number_or_zero(spring, "spring", key);
      if (value < 0) {
        throw DomainError(key, to_string(value), std::string(key) + " >= 0");
      }
      for (std::size_t i = 0; i < 2; ++i) {
        if (at[i] != 0) {
          A(at[i] - 1, at[i] - 1) += value;
        }
      }
      if (at[0] != 0 && at[1] != 0) {
        A(at[0] - 1, at[1] - 1) -= value;
        A(at[1] - 1, at[0] - 1) -= value;
      }
    };
    add(o.stiffness, "k");
    add(o.damping, "c");
  }

  [[nodiscard]] model::SmoothFriction<Rational> smooth_friction(const toml::table& in) const {
    require_keys(in, "sliding", {"falls", "from", "to", "over", "viscous"});
    const toml::node * falls = in.get("falls");
    const auto * text = falls == nullptr ? nullptr : falls->as_string();
    if (text == nullptr || (text->get() != "exponentially" && text->get() != "hyperbolically")) {
      refuse(in, "sliding falls = \"exponentially\" or \"hyperbolically\"");
    }
    return {text->get() == "exponentially" ? model::Fall::exponential : model::Fall::hyperbolic,
            number(in, "sliding", "from"), number(in, "sliding", "to"), number(in, "sliding", "over"),
            number_or_zero(in, "sliding", "viscous")};
  }

  [[nodiscard]] model::FrictionLaw<Rational> law(const toml::table& in) const {
    model::FrictionLaw<Rational> law{number(in, "friction", "at_rest"), {}};
    const toml::node * sliding = in.get("sliding");
    if (sliding == nullptr) {
      refuse(in, "sliding is missing in friction");
    }
    if (sliding->is_table()) {
      return numeric::machines::smooth_law(law.at_rest, smooth_friction(*sliding->as_table()));
    }
    if (!sliding->is_array()) {
      law.sliding.push_back({Rational(0), number(*sliding, "sliding"), Rational(0)});
      return law;
    }
    for (const toml::node& point : *sliding->as_array()) {
      const toml::array * pair = point.as_array();
      if (pair == nullptr || pair->size() != 2) {
        refuse(point, "sliding is a force, a list of pairs [relative velocity, force] or a smooth law");
      }
      law.sliding.push_back(
          {number((*pair)[0], "a relative velocity"), number((*pair)[1], "a force"), Rational(0)});
    }
    for (std::size_t i = 0; i + 1 < law.sliding.size(); ++i) {
      model::SlidingPiece<Rational>& piece = law.sliding[i];
      const model::SlidingPiece<Rational>& next = law.sliding[i + 1];
      if (next.from <= piece.from && !places_.empty()) {
        throw DomainError("a relative velocity of sliding", to_string(next.from),
                          "more than the one before, " + to_string(piece.from));
      }
      if (next.from <= piece.from) {
        refuse(*sliding, fmt::format("the relative velocities of sliding increase: {} does not follow {}",
                                     to_string(next.from), to_string(piece.from)));
      }
      piece.slope = Rational((next.force - piece.force) / (next.from - piece.from));
    }
    return law;
  }

  void read_friction(model::FrictionOscillator<Rational>& o) const {
    const toml::table& friction = table(root_, "friction");
    require_keys(friction, "friction", {"at_rest", "sliding", "overshoot"});
    o.forward = law(friction);
    o.backward = o.forward;
    if (friction.contains("overshoot")) {
      const toml::table& other = table(friction, "overshoot");
      require_keys(other, "friction.overshoot", {"at_rest", "sliding"});
      o.backward = law(other);
    }
  }

  // The loads' frequencies are whole multiples of one: the greatest that divides them all.
  void read_loads(Machine& machine) const {
    auto& o = machine.oscillator;
    std::vector<Rational> frequencies;
    std::optional<bool> in_turns;
    for (const toml::table * load : tables("load")) {
      require_keys(*load, "load",
                   {"mass", "amplitude", "sine", "frequency", "angular_frequency", "constant"});
      const std::size_t at = mass(*load, "load", o.size());
      if (load->contains("constant")) {
        if (load->size() != 2) {
          refuse(*load, "a constant load has a mass and nothing else");
        }
        o.loads.push_back({at, 0, number(*load, "load", "constant"), Rational(0)});
        frequencies.emplace_back(0);
        continue;
      }
      const bool turns = load->contains("frequency");
      if (turns == load->contains("angular_frequency")) {
        refuse(*load, "a load has a frequency or an angular_frequency, one of the two");
      }
      if (in_turns && *in_turns != turns) {
        refuse(*load, "the loads have frequencies or angular frequencies, all of them the same");
      }
      in_turns = turns;
      const Rational frequency = number(*load, "load", turns ? "frequency" : "angular_frequency");
      if (frequency <= 0) {
        throw DomainError("a load's frequency", to_string(frequency), "> 0");
      }
      o.loads.push_back({at, 1, number(*load, "load", "amplitude"), number_or_zero(*load, "load", "sine")});
      frequencies.push_back(frequency);
    }
    machine.in_turns = in_turns.value_or(false);
    const auto varying =
        std::count_if(frequencies.begin(), frequencies.end(), [](const Rational& f) { return f != 0; });
    const auto one = std::ranges::find_if(places_, is_frequency);
    if (one != places_.end() && one->node != nullptr && varying > 1) {
      throw UsageError(
          fmt::format("{}: of several loads the frequencies vary together: --along {} A..B, the greatest "
                      "that divides them all",
                      file_, base_frequency));
    }
    o.omega = 1;
    Rational base = 0;
    for (const Rational& f : frequencies) {
      base = f == 0 ? base : base == 0 ? f : common_divisor(base, f);
    }
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
      if (frequencies[i] == 0) {
        continue;
      }
      const Rational multiple(frequencies[i] / base);
      if (multiple > greatest_multiple) {
        throw UsageError(fmt::format(
            "{}: the loads' frequencies have no base frequency in common: {} is {} times the greatest that "
            "divides them all, at most {} times is possible",
            file_, to_string(frequencies[i]), to_string(multiple), greatest_multiple));
      }
      o.loads[i].k = static_cast<int>(multiple.get_num().get_si());
      o.omega = base;
    }
    if (one != places_.end() && one->node == nullptr && base != 0) {
      one->found = base;
      o.omega = one->value.value_or(base);
    }
  }

  [[nodiscard]] static Rational common_divisor(const Rational& a, const Rational& b) {
    const mpz_class numerators =
        gcd(mpz_class(a.get_num() * b.get_den()), mpz_class(b.get_num() * a.get_den()));
    Rational result(numerators, mpz_class(a.get_den() * b.get_den()));
    result.canonicalize();
    return result;
  }

  std::string file_;
  mutable std::vector<Place> places_;
  std::vector<std::string> lines_;
  toml::table root_;
};

}  // namespace

bool has_tables(const std::string& text) {
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    line.erase(0, line.find_first_not_of(" \t"));
    if (line.starts_with("[[mass]]")) {
      return true;
    }
  }
  return false;
}

std::optional<MachineInTables> machine_in_tables(const std::string& text, const std::string& file,
                                                 const std::vector<Datum>& data) {
  if (!has_tables(text)) {
    return std::nullopt;
  }
  std::vector<Reader::Place> places;
  for (const auto& [path, value] : data) {
    places.push_back({path, value});
  }
  return Reader(text, file, std::move(places)).read();
}

Rational value_in_tables(const std::string& text, const std::string& file, const std::string& path) {
  return Reader(text, file, {{path}}).value();
}

}  // namespace stickslip::cli
