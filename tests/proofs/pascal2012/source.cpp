// What is said to be printed against what the source of the paper's text has: no glyph may differ that is not
// flagged.
#include "proofs/pascal2012/source.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "proofs/pascal2012/paper.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;
using namespace stickslip::proofs::pascal2012;

namespace {

using Use = SourceLine::Use;
using Signs = std::vector<std::string>;

// The letters, digits and signs of a formula, one by one, names of functions whole. Brackets and fraction
// bars are left out: where they stand two notations differ.
Signs signs_of(const std::string& formula) {
  Signs result;
  for (std::size_t at = 0; at < formula.size();) {
    std::size_t length = 1;
    while (at + length < formula.size() && (formula[at + length] & 0xC0) == 0x80) {
      ++length;
    }
    std::string sign = formula.substr(at, length);
    for (const char * name : {"sin", "cos", "tan", "det", "Det"}) {
      if (formula.compare(at, 3, name) == 0) {
        sign = name == std::string("Det") ? "det" : name;
        length = 3;
      }
    }
    at += length;
    if (std::string(" (){}[]/,_^&.").find(sign) == std::string::npos && sign != "…") {
      result.push_back(sign == "≡" ? "=" : sign);
    }
  }
  return result;
}

// A formula of ours as the paper's text would write it: H_1 for H_1(tau), h_1 for H_1(tau_1), Gamma_1 for
// Gamma_1(T).
std::string as_text(std::string latex) {
  static const std::vector<std::pair<std::regex, std::string>> rules{
      {std::regex(R"(\\(left|right))"), ""},
      {std::regex(R"((H|\\Gamma)_(\d)(\^\{-?\d\})?\((\\tau|T)\))"), "$1_$2$3"},
      {std::regex(R"(H_(\d)(\^\{-?\d\})?\(\\tau_1\))"), "h_$1$2"},
      {std::regex(R"(\\begin\{vmatrix\})"), "det"},
      {std::regex(R"(\\(begin\{pmatrix\}|end\{[pv]matrix\})|\\frac|\\\\)"), ""},
      {std::regex("-"), "−"},
      {std::regex("'"), "′"}};
  for (const auto& [what, with] : rules) {
    latex = std::regex_replace(latex, what, with);
  }
  static const std::map<std::string, std::string> letters{
      {"omega", "ω"}, {"tau", "τ"},   {"chi", "χ"},    {"eta", "η"},    {"varphi", "ϕ"},
      {"Gamma", "Γ"}, {"gamma", "γ"}, {"Lambda", "Λ"}, {"lambda", "λ"}, {"Sigma", "Σ"},
      {"psi", "ψ"},   {"Theta", "Θ"}, {"Omega", "Ω"},  {"Delta", "Δ"},  {"delta", "δ"},
      {"xi", "ξ"},    {"rho", "ρ"},   {"pi", "π"},     {"tilde", "˜"},  {"bar", "¯"},
      {"dot", "′"},   {"ddot", "′′"}, {"neq", "≠"},    {"leq", "≤"},    {"geq", "≥"}};
  static const std::regex command(R"(\\([A-Za-z]+))");
  std::string result;
  std::sregex_iterator found(latex.begin(), latex.end(), command), none;
  std::size_t at = 0;
  for (; found != none; ++found) {
    const auto letter = letters.find((*found)[1]);
    result += latex.substr(at, static_cast<std::size_t>(found->position()) - at) +
              (letter == letters.end() ? (*found)[1].str() : letter->second);
    at = static_cast<std::size_t>(found->position() + found->length());
  }
  return result + latex.substr(at);
}

Signs sorted(Signs signs) {
  std::ranges::sort(signs);
  return signs;
}

// Accents stand before or behind their letter.
Signs without_accents(Signs signs) {
  std::erase_if(signs, [](const std::string& sign) { return sign == "′" || sign == "˜" || sign == "¯"; });
  return signs;
}

// How the line, with what is put back, and the statement differ; empty if not at all but for what is flagged.
std::string difference(const SourceLine& line, const std::string& latex) {
  const Signs read = signs_of(as_read(line.text)), ours = signs_of(as_text(latex));
  Signs expected = read;
  for (const std::string& flag : line.otherwise) {
    const std::string sign = flag.substr(1);
    if (flag.front() == '+') {
      expected.push_back(sign);
    } else if (flag.front() == '-') {
      const auto found = std::ranges::find(expected, sign);
      if (found == expected.end()) {
        return "nothing to leave out: " + flag;
      }
      expected.erase(found);
    }
  }
  const bool same = sorted(expected) == sorted(ours) &&
                    (!line.otherwise.empty() || without_accents(read) == without_accents(ours));
  return same ? "" : fmt::format("{} against {}", fmt::join(read, ""), fmt::join(ours, ""));
}

std::vector<SourceLine> lines_of(const std::string& id, const std::set<Use>& uses) {
  std::vector<SourceLine> result;
  for (const SourceLine& line : source_lines()) {
    if (line.of == id && uses.contains(line.use)) {
      result.push_back(line);
    }
  }
  return result;
}

std::vector<SourceLine> forms_of(const std::string& id) {
  return lines_of(id, {Use::printed, Use::otherwise});
}

// Whether it states formulas of the paper: not numbers, nor words of the abstract and the conclusion.
bool prints_formulas(const Claim& claim) {
  return claim.origin == Origin::paper && !claim.printed.empty() && claim.kind != Kind::numbers &&
         claim.place != "sec7" && std::isdigit(static_cast<unsigned char>(claim.id.front())) != 0;
}

const Claim& the_claim(const std::string& id) {
  return *std::ranges::find(paper().claims, id, &Claim::id);
}

std::string without_spaces(std::string text) {
  std::erase_if(text, [](char c) { return c == ' '; });
  return text;
}

}  // namespace

TEST_CASE("every formula that counts as printed is the source's, but for glyphs that are flagged") {
  std::size_t compared = 0;
  for (const Claim& claim : paper().claims) {
    if (!prints_formulas(claim)) {
      continue;
    }
    CAPTURE(claim.id);
    const std::vector<SourceLine> lines = forms_of(claim.id);
    REQUIRE(lines.size() == claim.printed.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].use == Use::printed) {
        CHECK(difference(lines[i], proofs::symbols::latex(claim.printed[i])).empty());
        ++compared;
      }
    }
  }
  CHECK(compared > 150);
}

TEST_CASE("whatever is lost of a formula is told with its claim, and nothing else") {
  std::set<std::string> known;
  for (const Claim& claim : paper().claims) {
    known.insert(claim.id);
    CAPTURE(claim.id);
    CHECK(claim.illegible.starts_with(lost_in_source(claim.id)));
  }
  for (const Example& example : paper().examples) {
    known.insert(example.name);
  }
  for (const SourceLine& line : source_lines()) {
    CAPTURE(line.text);
    CHECK(known.contains(line.of));
    const bool lost = as_read(line.text) != as_extracted(line.text);
    if (lost && line.use != Use::numbers && line.use != Use::passage) {
      CHECK_FALSE(the_claim(line.of).illegible.empty());
    }
  }
  // Some that are easily passed over.
  CHECK(the_claim("7").illegible.find("letters $chi$") != std::string::npos);
  CHECK(the_claim("11").illegible.find("both bars of absolute values") != std::string::npos);
  CHECK(the_claim("16").illegible.find("1 of 2 minus signs") != std::string::npos);
  CHECK(the_claim("28").illegible.find("1 of 2 equality signs") != std::string::npos);
  CHECK(the_claim("40").illegible == "both minus signs, the letter $I$");
  CHECK(the_claim("45").illegible == "the minus sign");
  CHECK(the_claim("47.c").illegible.empty());
}

TEST_CASE("brackets that are put back go together") {
  for (const SourceLine& line : source_lines()) {
    const std::string text = as_read(line.text);
    CAPTURE(text);
    for (const std::string pair : {"()", "[]"}) {
      CHECK((std::ranges::count(text, pair.front()) == std::ranges::count(text, pair.back()) ||
             text.find("…") != std::string::npos));
    }
    CHECK((line.use == Use::printed || line.otherwise.empty()));
  }
}

TEST_CASE("a sign more, less, moved or changed in a formula that counts as printed is found") {
  const SourceLine line = forms_of("44.H").front();
  CHECK(difference(line, R"(H(\tau - t) = H(\tau) H(-t))").empty());
  for (const char * wrong :
       {R"(H(\tau + t) = H(\tau) H(-t))", R"(H(\tau - t) = H(\tau) H(t))", R"(H(t - \tau) = H(\tau) H(-t))",
        R"(H(\tau - t) = H(\tau) \dot H(-t))", R"(H(\tau - t_1) = H(\tau) H(-t))"}) {
    CAPTURE(wrong);
    CHECK_FALSE(difference(line, wrong).empty());
  }
  // Without its mark a glyph that is lost is missed.
  CHECK_FALSE(
      difference({"44.H", Use::printed, as_extracted(line.text)}, R"(H(\tau - t) = H(\tau) H(-t))").empty());
}

TEST_CASE("the printed numbers are those of the source") {
  for (const Example& example : paper().examples) {
    std::string numbers;
    for (const SourceLine& line : lines_of(example.name, {Use::numbers})) {
      numbers += without_spaces(as_extracted(line.text)) + ",";
    }
    const auto& data = example.data;
    for (const auto& [name, value] :
         {std::pair("χ", data.chi), {"η", data.eta}, {"us", data.us}, {"ω", data.omega}, {"p", data.p}}) {
      CAPTURE(name);
      CHECK(numbers.find(fmt::format("{}={},", name, to_string(value))) != std::string::npos);
    }
    for (const PrintedResult& result : example.results) {
      CAPTURE(result.name);
      std::string digits = result.value.text;
      if (digits.starts_with("-")) {
        digits.replace(0, 1, "−");
      }
      CHECK(numbers.find("=" + digits + ",") != std::string::npos);
    }
  }
}

TEST_CASE("what is quoted of the paper stands in the source, word by word") {
  // Words may be divided at the end of a line.
  const auto letters = [](std::string text) {
    static const std::map<std::string, std::string> names{{"tau", "τ"}, {"phi", "ϕ"}};
    for (const auto& [name, letter] : names) {
      text = std::regex_replace(text, std::regex("\\b" + name), letter);
    }
    std::erase_if(text, [](char c) { return c == ' ' || c == '-' || c == '$' || c == '_'; });
    return text;
  };
  std::set<std::string> quoted;
  for (const Remark& remark : paper().remarks) {
    CAPTURE(remark.claim);
    if (!remark.quote.empty()) {
      quoted.insert(remark.claim);
      const std::vector<SourceLine> passages = lines_of(remark.claim, {Use::passage});
      REQUIRE(passages.size() == 1);
      CHECK(letters(as_extracted(passages.front().text)).find(letters(remark.quote)) != std::string::npos);
    }
    // What is refuted is quoted, in words or as a formula.
    const Claim& claim = the_claim(remark.claim);
    if (claim.origin == Origin::paper) {
      const std::vector<SourceLine> forms = forms_of(remark.claim);
      CHECK((!remark.quote.empty() ||
             std::ranges::any_of(forms, [](const SourceLine& line) { return !line.text.empty(); })));
    }
  }
  for (const SourceLine& line : source_lines()) {
    if (line.use == Use::passage) {
      CHECK(quoted.contains(line.of));
    }
  }
  CHECK(letters("ob- tained $tau = t_1$") == "obtainedτ=t1");
}
