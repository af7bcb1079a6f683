#include "proofs/text/claims_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <optional>
#include <set>
#include <sstream>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "proofs/methods/assumptions.hpp"
#include "proofs/methods/automatic.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/symbols/parse.hpp"
#include "proofs/symbols/table.hpp"
#include "proofs/text/proof_lines.hpp"

namespace stickslip::proofs::text {

using namespace methods;
using symbols::is_name;
using symbols::Names;
using symbols::Statement;
using symbols::Term;

namespace {

constexpr std::size_t longest_file = 4000000;

// What the notation has for the symbols of every paper.
const std::vector<std::string>& functions_of_all() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all(symbols::elementary_functions.begin(), symbols::elementary_functions.end());
    all.emplace_back("sign");
    return all;
  }();
  return names;
}

// An entry, which begins in the first column, and the lines that are indented below it.
struct Line {
  std::size_t number = 0;  // in the file, from 1
  std::string text;
};
struct Entry {
  Line head;
  std::vector<Line> body;
};

// The word in front, and the rest.
std::pair<std::string, std::string> first_word(const std::string& text) {
  const auto end = text.find_first_of(" \t");
  return end == std::string::npos ? std::pair(text, std::string())
                                  : std::pair(text.substr(0, end), trimmed(text.substr(end)));
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::string part;
  std::istringstream stream(text);
  while (std::getline(stream, part, separator)) {
    parts.push_back(trimmed(part));
  }
  return parts;
}

// Of claims, assumptions and sections: they become names of files.
bool is_id(const std::string& id) {
  return !id.empty() && id.size() <= 60 && std::isalnum(static_cast<unsigned char>(id.front())) != 0 &&
         id.find("..") == std::string::npos && id.back() != '.' && std::ranges::all_of(id, [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
         });
}

// Words of the notation, and those with which lines of a claim begin.
bool is_reserved(const std::string& name) {
  static const std::set<std::string> words{"I",  "abs",    "det",       "for",        "but",  "if",
                                           "by", "expect", "corrected", "conversely", "part", "illegible"};
  return words.contains(name);
}

// The number that a term made of numbers is.
std::optional<Rational> constant(const Term& term) {
  if (term.op() == symbols::Op::number) {
    return term.number();
  }
  if (term.op() == symbols::Op::negate) {
    const auto inside = constant(term.arguments()[0]);
    return inside ? std::optional<Rational>(-*inside) : std::nullopt;
  }
  if (term.op() == symbols::Op::quotient) {
    const auto above = constant(term.arguments()[0]), below = constant(term.arguments()[1]);
    return above && below && *below != 0 ? std::optional<Rational>(*above / *below) : std::nullopt;
  }
  return std::nullopt;
}

// What is proved of it.
const std::vector<Statement>& form_of(const Claim& claim) {
  return claim.corrected.empty() ? claim.printed : claim.corrected;
}

class Reading {
 public:
  Reading(std::string name, const Paper& known, const Programs * programs)
      : name_(std::move(name)), programs_(programs) {
    paper_ = known;
    names_ = symbols::names_of(symbols::symbol_table());
    for (const Claim& claim : known.claims) {
      context_->said.emplace(claim.id, form_of(claim));
    }
  }

  [[nodiscard]] Paper read(const std::string& content) {
    for (const Entry& entry : entries(content)) {
      line_ = entry.head.number;
      const auto [word, rest] = first_word(entry.head.text);
      static const std::map<std::string, void (Reading::*)(const std::string&, const Entry&)> kinds{
          {"paper", &Reading::begin_paper},
          {"symbols", &Reading::symbols_line},
          {"let", &Reading::let},
          {"section", &Reading::section},
          {"assume", &Reading::assume},
          {"all", &Reading::all},
          {"claim", &Reading::claim},
          {"program", &Reading::program},
          {"words", &Reading::words},
          {"remark", &Reading::remark},
          {"result", &Reading::result},
          {"judgement", &Reading::judgement},
          {"statements", &Reading::statements},
          {"statement", &Reading::statement}};
      const auto kind = kinds.find(word);
      if (kind == kinds.end()) {
        fail(
            fmt::format("'{}' begins no entry: there are paper, symbols, let, section, assume, all, claim, "
                        "words, remark, judgement, result, statements, statement",
                        word));
      }
      (this->*kind->second)(rest, entry);
    }
    finish();
    return std::move(paper_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw UsageError(fmt::format("{}:{}: {}", name_, line_, what));
  }
  // What the work throws about a line, with the place of that line.
  template <class Work>
  auto here(const Work& work) const {
    try {
      return work();
    } catch (const symbols::ParseError& error) {
      throw error.in(fmt::format("{}:{}", name_, line_));
    } catch (const UsageError& error) {
      fail(error.what());
    }
  }

  [[nodiscard]] std::vector<Entry> entries(const std::string& content) {
    if (content.size() > longest_file) {
      throw UsageError(fmt::format("{}: a file of claims has at most {} characters", name_, longest_file));
    }
    std::vector<Entry> found;
    std::vector<std::pair<std::size_t, Line>> indented;  // below the last head, with their columns
    const auto close = [&] {
      if (found.empty()) {
        return;
      }
      std::size_t first = std::string::npos;
      for (const auto& [indent, line] : indented) {
        first = std::min(first, indent);
      }
      Entry& entry = found.back();
      const std::string word = first_word(entry.head.text).first;
      static const std::set<std::string> with_lines{"paper",     "assume", "claim",    "remark",
                                                    "judgement", "result", "statement"};
      const bool has_lines = with_lines.contains(word);
      for (const auto& [indent, line] : indented) {
        if (indent == first && has_lines) {
          entry.body.push_back(line);
        } else {
          (entry.body.empty() ? entry.head : entry.body.back()).text += " " + line.text;
        }
      }
      indented.clear();
    };
    std::istringstream stream(content);
    std::string text;
    for (line_ = 1; std::getline(stream, text); ++line_) {
      if (const auto comment = text.find("# ");
          comment != std::string::npos && trimmed(text.substr(0, comment)).empty()) {
        continue;
      }
      const std::string plain = trimmed(text);
      if (plain.empty() || plain == "#") {
        continue;
      }
      const std::size_t indent = text.find_first_not_of(" \t");
      if (indent == 0) {
        close();
        found.push_back({{line_, plain}, {}});
      } else if (found.empty()) {
        fail("an indented line belongs to an entry, and there is none before it");
      } else {
        indented.emplace_back(indent, Line{line_, plain});
      }
    }
    close();
    return found;
  }

  void begin_paper(const std::string& rest, const Entry& entry) {
    if (begun_) {
      fail("'paper' stands before all other entries");
    }
    begun_ = alone_ = true;
    paper_ = {};
    context_->said.clear();
    Bibliography& source = paper_.bibliography;
    source.title = rest;
    read_fields(entry, {{"author", &source.author},
                        {"title", &source.title},
                        {"journal", &source.journal},
                        {"doi", &source.doi},
                        {"text", &source.text}});
    names_ = {};
    for (const std::string& function : functions_of_all()) {
      names_.functions.emplace(function, symbols::Shape{});
    }
    names_.quantities = {{"pi", {}}, {"t", {}}};
    make_vocabulary();
  }

  // The lines of an entry, "NAME words", each at most once, with passages that have a name put in.
  using Fields = std::vector<std::pair<const char *, std::string *>>;
  void read_fields(const Entry& entry, const Fields& fields) {
    for (const Line& line : entry.body) {
      line_ = line.number;
      const auto field = std::ranges::find_if(
          fields, [&](const auto& one) { return line.text.starts_with(std::string(one.first) + " "); });
      if (field == fields.end()) {
        std::vector<std::string> names;
        for (const auto& [name, place] : fields) {
          names.emplace_back(name);
        }
        fail(fmt::format("'{}': the lines of '{}' begin with {}", first_word(line.text).first,
                         first_word(entry.head.text).first, fmt::join(names, ", ")));
      }
      if (!field->second->empty()) {
        fail(fmt::format("'{}' stands there twice", field->first));
      }
      *field->second = checked_words(with_passages(trimmed(line.text.substr(std::strlen(field->first)))));
    }
    line_ = entry.head.number;
  }
  [[nodiscard]] std::string with_passages(std::string text) const {
    for (const auto& [name, passage] : passages_) {
      const std::string mark = "{" + name + "}";
      for (std::size_t at = text.find(mark); at != std::string::npos;
           at = text.find(mark, at + passage.size())) {
        text.replace(at, mark.size(), passage);
      }
    }
    return text;
  }

  // "NAME: words", for {NAME} in the words of remarks and results.
  void words(const std::string& rest, const Entry&) {
    const auto colon = rest.find(':');
    const std::string name = trimmed(rest.substr(0, colon));
    if (colon == std::string::npos || !is_name(name) || passages_.contains(name)) {
      fail("a name, ':' and what it stands for belong to 'words', each once");
    }
    passages_.emplace(name, checked_words(trimmed(rest.substr(colon + 1))));
  }

  [[nodiscard]] const std::string& known_claim(const std::string& id) const {
    if (std::ranges::find(paper_.claims, id, &Claim::id) == paper_.claims.end()) {
      fail(fmt::format("there is no claim '{}' before this line", id));
    }
    return id;
  }
  [[nodiscard]] std::vector<std::string> known_claims(const std::string& ids) const {
    std::vector<std::string> result = split(ids, ',');
    std::ranges::for_each(result, [this](const std::string& id) { (void)known_claim(id); });
    return result;
  }

  // The part of the paper in which the statements that follow stand.
  void statements(const std::string& rest, const Entry&) { part_ = checked_words(rest); }

  // "ID KIND [PLACE] WORDS".
  void statement(const std::string& rest, const Entry& entry) {
    const auto [id, after_id] = first_word(rest);
    const auto [kind, after_kind] = first_word(after_id);
    const auto closing = after_kind.find(']');
    if (!is_id(id) || !after_kind.starts_with('[') || closing == std::string::npos) {
      fail("a statement is an id, a kind, its place in square brackets, and words");
    }
    PrintedStatement one{.id = id,
                         .place = checked_words(after_kind.substr(1, closing - 1)),
                         .kind = kind_of(kind, Kind::check),
                         .words = checked_words(trimmed(after_kind.substr(closing + 1)))};
    one.section = part_;
    std::string claims, other, see;
    read_fields(
        entry,
        {{"claims", &claims}, {"or", &other}, {"at", &one.example}, {"but", &one.missing}, {"see", &see}});
    one.claims = known_claims(claims);
    one.or_read = known_claims(other);
    one.see = known_claims(see);
    if (one.claims.empty() && one.missing.empty()) {
      fail(fmt::format("{}: 'claims' state it, or 'but' says why there are none", id));
    }
    statements_.push_back(one);
  }

  void remark(const std::string& rest, const Entry& entry) {
    Remark one;
    one.claim = known_claim(rest);
    read_fields(entry, {{"place", &one.place},
                        {"says", &one.says},
                        {"fact", &one.fact},
                        {"because", &one.because},
                        {"see", &one.see},
                        {"quote", &one.quote},
                        {"note", &one.note}});
    if (one.says.empty() || one.fact.empty()) {
      fail("a remark has 'says', what the paper says, and 'fact', what is so");
    }
    paper_.remarks.push_back(one);
  }

  void judgement(const std::string& rest, const Entry& entry) {
    std::string lost, kept, shown_by;
    Judgement one;
    one.origin = known_claim(rest);
    read_fields(entry, {{"lost", &lost}, {"kept", &kept}, {"shown by", &shown_by}});
    if (lost.empty() == kept.empty()) {
      fail("a judgement of a hypothesis has either 'lost', what is so where it fails, or 'kept'");
    }
    one.matters = kept.empty();
    one.words = lost + kept;
    const std::vector<std::string> claims = known_claims(shown_by);
    one.shown_by = {claims.begin(), claims.end()};
    paper_.judgements.push_back(one);
  }

  void result(const std::string& rest, const Entry& entry) {
    const auto colon = rest.find(':');
    if (colon == std::string::npos) {
      fail("an id, ':' and a title belong to 'result'");
    }
    Result one;
    one.id = trimmed(rest.substr(0, colon));
    one.title = checked_words(trimmed(rest.substr(colon + 1)));
    std::string claims, lists;
    read_fields(entry, {{"setting", &one.setting},
                        {"theorem", &one.theorem},
                        {"idea", &one.idea},
                        {"see", &one.see},
                        {"claims", &claims},
                        {"lists", &lists}});
    one.claims = known_claims(claims);
    one.lists = !lists.empty();
    if (one.theorem.empty() || one.claims.empty()) {
      fail("a result has 'theorem', and 'claims' that say it");
    }
    paper_.results.push_back(one);
  }

  void symbols_line(const std::string& rest, const Entry&) {
    require_alone("symbols");
    const auto in = rest.find(" in "), colon = rest.find(':');
    const std::optional<symbols::Shape> motion =
        colon < in ? std::optional(shape_of_motion(trimmed(rest.substr(colon + 1, in - colon - 1))))
                   : std::nullopt;
    for (const std::string& name : split(rest.substr(0, std::min(in, colon)), ',')) {
      new_name(name);
      if (const std::string other = methods::looks_like(name, names_); !other.empty()) {
        fail(fmt::format("'{}' is printed as '{}' is: take another name", name, other));
      }
      if (motion) {
        names_.functions.emplace(name, *motion);
        rows_.push_back({.name = name, .shape = *motion, .of_time = true, .is_motion = true});
      } else {
        names_.quantities.emplace(name, symbols::Shape{});
        rows_.push_back({name});
      }
    }
    if (in != std::string::npos) {
      for (const std::string& relation : split(rest.substr(in + 4), ',')) {
        for (const Statement& one : here([&] { return symbols::parse_statements(relation, names_); })) {
          add_to_domain(one);
        }
      }
    }
    make_vocabulary();
  }

  // "motion of 2": a function of time with so many numbers, of which no more is known.
  [[nodiscard]] symbols::Shape shape_of_motion(const std::string& kind) const {
    const std::string count = kind.starts_with("motion of ") ? trimmed(kind.substr(10)) : "";
    if (count.size() != 1 || count.front() < '1' || count.front() > '8') {
      fail(fmt::format("'{}': after ':' stands 'motion of' and how many numbers it has, from 1 to 8", kind));
    }
    return {count.front() - '0', 1};
  }

  // "number < symbol" or "symbol < number", however it is turned.
  void add_to_domain(const Statement& one) {
    const Statement below = symbols::with_less(one);
    const Term &lower = below.left, &upper = below.right;
    const std::optional<Rational> least = constant(lower), greatest = constant(upper);
    const Term& symbol = least ? upper : lower;
    const bool is_own = symbol.op() == symbols::Op::symbol &&
                        std::ranges::find(rows_, symbol.name(), &symbols::Symbol::name) != rows_.end();
    if (below.relation != symbols::Relation::less || !(least || greatest) || !is_own || one.during) {
      fail(fmt::format("'{}': a domain says that a symbol of the file is less or greater than a number",
                       symbols::text(one)));
    }
    domain_.push_back(
        {least ? Term(*least) : lower, greatest ? Term(*greatest) : upper, symbols::Relation::less});
    make_vocabulary();
    const symbols::InVocabulary scope(paper_.vocabulary);
    const Bounds known = bounds_of(symbol.name());
    if (known.lower && known.upper && *known.lower >= *known.upper) {
      fail(fmt::format("'{}': with what is said before no value is left", symbols::text(one)));
    }
  }

  void let(const std::string& rest, const Entry&) {
    begun_ = true;
    const auto equals = rest.find('=');
    if (equals == std::string::npos) {
      fail("a name, '=' and what it stands for belong to 'let'");
    }
    std::string name = trimmed(rest.substr(0, equals));
    symbols::Abbreviation abbreviation{{}, Term(0)};
    Names inside = names_;
    if (const auto open = name.find('('); open != std::string::npos) {
      if (name.back() != ')') {
        fail(fmt::format("'{}': the parameters of a name stand in brackets, with commas", name));
      }
      abbreviation.parameters = split(name.substr(open + 1, name.size() - open - 2), ',');
      name = trimmed(name.substr(0, open));
      for (const std::string& parameter : abbreviation.parameters) {
        if (!is_name(parameter) || is_reserved(parameter) ||
            std::ranges::count(abbreviation.parameters, parameter) > 1) {
          fail(fmt::format("'{}' is no name of a parameter, or that of two", parameter));
        }
      }
    }
    // A parameter is read as a symbol that nobody can type: other abbreviations in the formula may speak of a
    // symbol of its name, which is not put in.
    for (std::string& parameter : abbreviation.parameters) {
      const std::string apart = fmt::format("{} of {}", parameter, name);
      inside.abbreviations.insert_or_assign(parameter, symbols::Abbreviation{{}, symbols::scalar(apart)});
      parameter = apart;
    }
    new_name(name);
    abbreviation.means = here([&] { return symbols::parse_term(rest.substr(equals + 1), inside); });
    if (size_of(abbreviation.means) > longest_abbreviation) {
      fail(fmt::format("'{}' stands for a formula of more than {} parts", name, longest_abbreviation));
    }
    // Put into a rate, a parameter t, or an argument with t in it, would be differentiated, too.
    if (has_rate_of(abbreviation.means, abbreviation.parameters)) {
      fail(fmt::format("'{}' is a rate of something with a parameter in it: write d/dt[…] where it is needed",
                       name));
    }
    names_.abbreviations.emplace(name, abbreviation);
  }

  [[nodiscard]] static bool mentions(const Term& term, const std::vector<std::string>& names) {
    return (term.op() == symbols::Op::symbol && std::ranges::find(names, term.name()) != names.end()) ||
           std::ranges::any_of(term.arguments(), [&](const Term& part) { return mentions(part, names); });
  }
  [[nodiscard]] static bool has_rate_of(const Term& term, const std::vector<std::string>& names) {
    return (term.op() == symbols::Op::derivative && mentions(term, names)) ||
           std::ranges::any_of(term.arguments(), [&](const Term& part) { return has_rate_of(part, names); });
  }

  static constexpr std::size_t longest_abbreviation = 20000;
  [[nodiscard]] static std::size_t size_of(const Term& term) {
    std::size_t size = 1;
    for (const Term& part : term.arguments()) {
      size += size_of(part);
    }
    return size;
  }

  void section(const std::string& rest, const Entry&) {
    begun_ = true;
    const auto [id, title] = first_word(rest);
    if (!is_id(id)) {
      fail(fmt::format("'{}' is no id of a section", id));
    }
    if (std::ranges::any_of(paper_.sections, [&id = id](const Section& one) { return one.id == id; })) {
      fail(fmt::format("there are two sections {}", id));
    }
    section_ = {id, title.empty() ? id : checked_words(title), id};
    paper_.sections.push_back(section_);
  }

  // "NAME: statement", "NAME ID: statement", with more statements on lines of their own.
  void assume(const std::string& rest, const Entry& entry) {
    begun_ = true;
    const auto colon = rest.find(':');
    auto [name, id] = first_word(trimmed(rest.substr(0, colon)));
    id = id.empty() ? name : id;
    if (colon == std::string::npos || !is_id(name) || !is_id(id)) {
      fail("an assumption has an id, ':' and a statement");
    }
    std::vector<Assumption> assumed = assumptions_of(id, rest.substr(colon + 1));
    for (const Line& line : entry.body) {
      line_ = line.number;
      for (const Assumption& one : assumptions_of(id, line.text)) {
        assumed.push_back(one);
      }
    }
    name_assumptions(name, assumed);
  }

  // "NAME = ID, ID, …".
  void all(const std::string& rest, const Entry&) {
    begun_ = true;
    const auto equals = rest.find('=');
    const std::string name = trimmed(rest.substr(0, equals));
    if (equals == std::string::npos || !is_id(name)) {
      fail("a name, '=' and ids of assumptions belong to 'all'");
    }
    name_assumptions(name, assumptions_named(rest.substr(equals + 1)));
  }

  void name_assumptions(const std::string& name, const std::vector<Assumption>& assumed) {
    if (!assumptions_.emplace(name, assumed).second) {
      fail(fmt::format("there are two assumptions {}", name));
    }
  }

  [[nodiscard]] std::vector<Assumption> assumptions_of(const std::string& id, const std::string& text) const {
    std::vector<Assumption> result;
    for (const Statement& one : here([&] { return symbols::parse_statements(text, names_); })) {
      result.push_back({id, one});
    }
    return result;
  }

  // Of "id, id".
  [[nodiscard]] std::vector<Assumption> assumptions_named(const std::string& ids) const {
    std::vector<Assumption> result;
    for (const std::string& id : split(ids, ',')) {
      const auto found = assumptions_.find(id);
      if (found == assumptions_.end()) {
        fail(fmt::format("nothing is assumed as '{}'{}", id,
                         is_name(id) ? "" : "; what is assumed here takes a name: 'if NAME: " + id + "'"));
      }
      result.insert(result.end(), found->second.begin(), found->second.end());
    }
    return result;
  }

  // Claims that the program makes itself, in this place.
  void program(const std::string& rest, const Entry&) {
    for (Claim one : programmed(&Programs::claims, rest)) {
      one.place = section_.id;
      context_->said.emplace(one.id, form_of(one));
      paper_.claims.push_back(std::move(one));
    }
  }
  template <class Made>
  [[nodiscard]] const Made& programmed(std::map<std::string, Made> Programs::*kind,
                                       const std::string& name) const {
    static const Programs none;
    const auto& known = (programs_ != nullptr ? *programs_ : none).*kind;
    const auto made = known.find(name);
    if (made == known.end()) {
      fail(fmt::format("there is no program '{}'", name));
    }
    return made->second;
  }

  void claim(const std::string& rest, const Entry& entry) {
    begun_ = true;
    Claim claim = claim_of(rest);
    std::map<std::string, Line> proofs;  // by "by", "conversely by", "corrected by"
    for (const Line& line : entry.body) {
      line_ = line.number;
      auto [word, text] = first_word(line.text);
      if ((word == "conversely" || word == "corrected") && text.starts_with("by ")) {
        word += " by";
        text = trimmed(text.substr(3));
      }
      const auto statements = [&](const std::string& of) {
        return here([&] { return symbols::parse_statements(of, names_); });
      };
      const auto add = [](std::vector<Statement>& to, const std::vector<Statement>& more) {
        to.insert(to.end(), more.begin(), more.end());
      };
      if (word == "if") {
        add_assumptions(claim, text);
      } else if (word == "by" || word == "conversely by" || word == "corrected by") {
        if (word == "conversely by" && !text.starts_with("counterexample ")) {
          fail(fmt::format("'{}': what is assumed need not follow from what is stated, says a counterexample",
                           text));
        }
        if (!proofs.emplace(word, Line{line_, text}).second) {
          fail(fmt::format("the claim {} has two proofs", claim.id));
        }
      } else if (word == "expect") {
        if (!is_status(text)) {
          fail(fmt::format("'{}' is no status of a claim", text));
        }
        claim.expected = text;
      } else if (word == "part") {
        claim.parts.push_back(checked_words(text));
      } else if (word == "illegible") {
        claim.illegible = checked_words(text);
      } else if (word == "corrected") {
        add(claim.corrected, statements(text));
      } else {
        add(claim.printed, statements(line.text));
      }
    }
    line_ = entry.head.number;
    if (claim.printed.empty() && claim.kind != Kind::model && programs_ == nullptr) {
      fail(fmt::format("the claim {} states nothing", claim.id));
    }
    const std::size_t stated = claim.printed.size() + claim.corrected.size();
    if (!claim.parts.empty() && claim.parts.size() != stated && (stated > 0 || programs_ == nullptr)) {
      fail(fmt::format("the claim {} has words for {} parts, and states {} things", claim.id,
                       claim.parts.size(), stated));
    }
    {
      const symbols::InVocabulary scope(paper_.vocabulary);
      claim = saying(claim, claim.printed);
    }
    prove(claim, proofs);
    state(claim);
    context_->said.emplace(claim.id, form_of(claim));
    paper_.claims.push_back(std::move(claim));
  }

  // Gives it the proofs that the lines name.
  void prove(Claim& claim, const std::map<std::string, Line>& proofs) {
    for (const auto& [word, line] : proofs) {
      line_ = line.number;
      (word == "by"              ? claim.prove
       : word == "conversely by" ? claim.prove_converse
                                 : claim.prove_corrected) = proof(claim, line.text);
    }
    const bool is_given =
        claim.kind == Kind::model || (claim.kind == Kind::definition && programs_ != nullptr);
    claim.is_searched = !claim.prove && !is_given;
    if (claim.is_searched) {
      claim.prove = proof_of(claim, *context_, "");
    }
    if (!claim.corrected.empty() && !claim.prove_corrected) {
      claim.prove_corrected = claim.prove;
    }
  }
  [[nodiscard]] Proof proof(const Claim& claim, const std::string& line) const {
    if (programs_ == nullptr) {
      return here([&] { return proof_of(claim, *context_, line); });
    }
    if (line == "program") {
      return programmed(&Programs::proofs, claim.id);
    }
    // Read when it is needed, for there are many; then all claims are known. A line that is of another claim
    // than this, or cannot be read, proves nothing.
    return [context = std::shared_ptr<const ProofContext>(context_), line](Prover& prover, const Claim& of) {
      try {
        return proof_of(of, *context, line)(prover, of);
      } catch (const UsageError& error) {
        return Outcome{.verdict = Verdict::undecided(error.what())};
      }
    };
  }

  // "id kind origin: words".
  [[nodiscard]] Claim claim_of(const std::string& rest) const {
    const auto colon = rest.find(':');
    std::istringstream head(rest.substr(0, colon));
    std::string id, kind, origin, more;
    head >> id >> kind >> origin >> more;
    if (colon == std::string::npos || kind.empty() || !more.empty()) {
      fail("a claim has an id, a kind, perhaps an origin, then ':' and words");
    }
    if (!is_id(id)) {
      fail(fmt::format("'{}' is no id of a claim: letters, digits, '_' and '.'", id));
    }
    if (std::ranges::any_of(paper_.claims, [&](const Claim& one) { return one.id == id; })) {
      fail(fmt::format("there are two claims {}", id));
    }
    Claim claim{.id = id, .place = section_.id};
    claim.kind = kind_of(kind);
    claim.origin = origin.empty() ? Origin::paper : origin_of(origin);
    claim.words = checked_words(trimmed(rest.substr(colon + 1)));
    return claim;
  }

  // Of those from the first to this one.
  [[nodiscard]] Kind kind_of(const std::string& word, Kind last = Kind::numbers) const {
    std::vector<std::string> names;
    for (int k = 0; k <= static_cast<int>(last); ++k) {
      names.push_back(to_string(static_cast<Kind>(k)));
      if (names.back() == word) {
        return static_cast<Kind>(k);
      }
    }
    fail(fmt::format("'{}' is no kind of claim: there are {}", word, fmt::join(names, ", ")));
  }
  [[nodiscard]] Origin origin_of(const std::string& word) const {
    std::vector<std::string> names;
    for (const OriginFacts& one : origins()) {
      if (one.name == word) {
        return one.origin;
      }
      names.emplace_back(one.name);
    }
    fail(fmt::format("'{}' is no origin: there are {}", word, fmt::join(names, ", ")));
  }

  // Ids of assumptions, or "id: statement".
  void add_assumptions(Claim& claim, const std::string& text) {
    std::vector<Assumption> more;
    if (const auto colon = text.find(':'); colon != std::string::npos) {
      const std::string id = trimmed(text.substr(0, colon));
      if (!is_id(id)) {
        fail(fmt::format("'{}' is no id of an assumption", id));
      }
      more = assumptions_of(id, text.substr(colon + 1));
    } else {
      more = assumptions_named(text);
    }
    claim.assumptions.insert(claim.assumptions.end(), more.begin(), more.end());
  }

  // Of a paper of its own, what it or text books say is one of its statements.
  void state(const Claim& claim) {
    if (alone_ && facts(claim.origin).source != nullptr) {
      paper_.statements.push_back({.id = fmt::format("S{:03}", paper_.statements.size() + 1),
                                   .place = claim.id,
                                   .kind = claim.kind,
                                   .words = claim.words,
                                   .claims = {claim.id},
                                   .section = section_.title});
    }
  }

  // Words go into pages and LaTeX: no commands, and formulas between dollars that belong together.
  [[nodiscard]] std::string checked_words(const std::string& words) const {
    if (programs_ == nullptr && words.find_first_of("\\<>{}&") != std::string::npos) {
      fail(fmt::format("'{}': words have no \\, <, >, {{, }} or &", words));
    }
    if (std::ranges::count(words, '$') % 2 != 0) {
      fail(fmt::format("'{}': a formula in words stands between two dollars", words));
    }
    return words;
  }

  void require_alone(const char * what) {
    begun_ = true;
    if (!alone_) {
      fail(fmt::format("'{}' belongs to a paper of its own: begin the file with an entry 'paper'", what));
    }
  }
  void new_name(const std::string& name) const {
    if (is_reserved(name)) {
      fail(fmt::format("'{}' is a word of the format: a symbol needs another name", name));
    }
    if (!is_name(name)) {
      fail(fmt::format("'{}' is no name for a symbol: a name is a letter, then letters and digits", name));
    }
    if (name == "t" || name == "pi" || names_.has(name)) {
      fail(fmt::format("'{}' has a meaning already", name));
    }
  }

  void make_vocabulary() {
    std::vector<symbols::Symbol> rows = rows_;
    for (const std::string& function : functions_of_all()) {
      rows.push_back({.name = function, .of_time = true});
    }
    rows.push_back({.name = "pi"});
    rows.push_back({.name = "t"});
    paper_.vocabulary = std::make_shared<const symbols::Vocabulary>(symbols::Symbols(rows), domain_, false);
  }

  void finish() {
    if (paper_.claims.empty()) {
      throw UsageError(fmt::format("{}: there is no claim in it", name_));
    }
    if (!statements_.empty()) {
      paper_.statements = statements_;
    }
    if (alone_ && paper_.sections.empty()) {
      paper_.sections.push_back(section_);
    }
    if (!alone_ && std::ranges::find(paper_.claims, "own", &Claim::place) != paper_.claims.end()) {
      paper_.sections.push_back({"own", "Claims of your own", "own"});
    }
  }

  std::string name_;
  std::size_t line_ = 0;
  Paper paper_;
  std::shared_ptr<ProofContext> context_ = std::make_shared<ProofContext>();
  Names& names_ = context_->names;
  std::vector<symbols::Symbol> rows_;
  std::vector<Statement> domain_;
  std::map<std::string, std::vector<Assumption>> assumptions_;
  std::map<std::string, std::string> passages_;
  std::string part_;
  std::vector<PrintedStatement> statements_;
  const Programs * programs_;

  Section section_{"own", "Claims", "own"};
  bool begun_ = false, alone_ = false;
};

}  // namespace

Paper read_claims(const std::string& content, const std::string& name, const Paper& known,
                  const Programs * programs) {
  return Reading(name, known, programs).read(content);
}

}  // namespace stickslip::proofs::text
