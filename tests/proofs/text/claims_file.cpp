#include "proofs/text/claims_file.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "core/error.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/symbols/parse.hpp"
#include "proofs/symbols/table.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::methods;

namespace {

Paper read(const std::string& content) {
  return text::read_claims(content, "F", pascal2012::paper());
}

std::string example(const std::string& name) {
  std::ifstream file(std::string(STICKSLIP_SOURCE_DIR) + "/examples/claims/" + name + ".claims");
  std::stringstream content;
  content << file.rdbuf();
  return content.str();
}

std::map<std::string, std::string> statuses(const Paper& paper) {
  const symbols::InVocabulary scope(paper.vocabulary);
  std::map<std::string, std::string> result;
  for (const Record& record : audit(paper.claims).records) {
    result[record.claim.id] = to_string(record.status);
  }
  return result;
}

std::string status_of(const std::string& entries, const std::string& claim = "c") {
  return statuses(read("paper P\nsymbols a, b, c1, x\n" + entries)).at(claim);
}

std::string refusal(const std::string& content) {
  try {
    (void)read(content);
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

std::string refusal_of(const std::string& entries) {
  return refusal("paper P\nsymbols a, b, x\n" + entries);
}

}  // namespace

TEST_CASE("the papers among the examples come out as they say they do") {
  for (const auto& [name, statements] :
       {std::pair("den_hartog", 8), std::pair("belt", 8), std::pair("damped", 11)}) {
    CAPTURE(name);
    const Paper paper = read(example(name));
    CHECK(paper.sections.size() >= 3);
    CHECK(paper.statements.size() == statements);
    const auto found = statuses(paper);
    CHECK(found.size() == paper.claims.size());
    for (const Claim& claim : paper.claims) {
      CAPTURE(claim.id);
      CHECK(!claim.expected.empty());
      CHECK(found.at(claim.id) == claim.expected);
    }
  }
}

TEST_CASE(
    "a root in one statement says nothing of another, nor one in the corrected form of the printed one") {
  const std::string head = "section s S\nclaim c theorem textbook: words\n";
  CHECK(status_of(head + "  x >= 0\n  sqrt(x)^2 = x\n") == "refuted");
  CHECK(status_of(head + "  x >= 0\n  corrected sqrt(x)^2 = x\n") == "misprint_corrected");
  CHECK(status_of(head + "  x >= 0\n  if y: a = sqrt(x)\n") == "proved");
}

TEST_CASE("what is given to a premise is what it assumes") {
  const auto last = [](const std::string& given) {
    return statuses(read("paper P\nsymbols x, y\nsection s S\nassume one: x = 1\nassume more: y = x\n"
                         "claim square step: .\n  x^2 = 1\n  if one\n"
                         "claim same step: .\n  x = 1\n  if one\n"
                         "claim again step: .\n  x^2 = 1\n  if one, more\n  by premises claim square given " +
                         given + " by same\n"))
        .at("again");
  };
  CHECK(last("one") == "as_printed");
  CHECK(last("more") == "undecided");
  CHECK(last("none") == "undecided");
}

TEST_CASE("a file with characters changed is refused in a sentence, or another file") {
  const std::string whole = example("den_hartog");
  const std::string signs = "+-*/^()[]|,;:=<>'@#$ \n\tabt12.";
  std::mt19937 random(33);
  int refused = 0;
  for (int i = 0; i < 1500; ++i) {
    std::string changed = whole;
    for (int k = 0; k < 1 + i % 3; ++k) {
      changed[random() % changed.size()] = signs[random() % signs.size()];
    }
    try {
      (void)read(changed);
    } catch (const UsageError& error) {
      CHECK(std::string(error.what()).starts_with("F:"));
      ++refused;
    }
  }
  CHECK(refused > 300);
}

TEST_CASE("two papers in one process do not meet") {
  // Names of the oscillator's that are but letters here: no domain, no formula.
  const Paper other = read(
      "paper P\nsymbols us, chi, eta, omega1, omega2, omega, d, K, Z, X\n"
      "claim positive step: .\n  us > 0\n"
      "claim low step: .\n  omega1 < 1\n"
      "claim ratio step: .\n  chi eta = omega1^2 + omega2^2 - 1\n"
      "claim square step: .\n  (chi + K)^2 = chi^2 + 2 chi K + K^2\n"
      "claim given step: .\n  Z = 2 X\n  if half: X = Z/2\n"
      "claim load step: .\n  omega/omega = 1\n"
      "claim sum step: .\n  (us + omega) d/((us + omega) d) = 1\n");
  const auto check_other = [&] {
    const auto found = statuses(other);
    CHECK(found.at("positive") == "refuted");
    CHECK(found.at("low") == "refuted");
    CHECK(found.at("ratio") == "refuted");
    CHECK(found.at("square") == "as_printed");
    CHECK(found.at("given") == "as_printed");
    CHECK(found.at("load") == "where_defined");
    CHECK(found.at("sum") == "where_defined");
  };
  const auto check_paper = [] {
    Prover prover(pascal2012::paper().claims);
    CHECK(to_string(prover.prove("39.range").status) == "proved");
    CHECK(to_string(prover.prove("40").status) == "as_printed");
  };
  check_paper();
  check_other();
  check_paper();
  check_other();
  CHECK(symbols::vocabulary_here().is_of_model());
}

TEST_CASE("a file may stand on the paper") {
  const Paper paper = read(
      "let square(s) = H(s)^2\n"
      "claim twice step new: the flow of twice the time\n  square(t) = H(2 t)\n"
      "claim period step new: from (40)\n  H1(tau)^2 = I + H2(tau) H3(tau)\n  by rewriting 40 at t = tau for "
      "H1(tau)^2\n");
  CHECK(paper.claims.size() == pascal2012::paper().claims.size() + 2);
  Prover prover(paper.claims);
  CHECK(to_string(prover.prove("twice").status) == "proved");
  CHECK(to_string(prover.prove("period").status) == "proved");
  CHECK(prover.prove("period").outcome.uses.contains("40"));
}

TEST_CASE("proofs have names") {
  CHECK(status_of("claim c identity: .\n  (a + b)^2 = a^2 + 2 a b + b^2\n  by normal form\n") ==
        "as_printed");
  CHECK(status_of("claim c identity: .\n  (a + b)^2 = a^2 + a b + b^2\n  by normal form\n") == "refuted");
  CHECK(status_of("claim c step: .\n  a^2 = b^2\n  if e: a + b = 0\n  by combination (a - b) @e\n") ==
        "as_printed");
  CHECK(status_of("claim c step: .\n  a^2 = b^2\n  if e: a + b = 0\n  by combination (a + b) @e\n") ==
        "undecided");
  CHECK(status_of("claim c step: .\n  0 < a b\n  if p: 0 < a\n  if q: 0 < b\n  by order @p @q\n") ==
        "as_printed");
  CHECK(status_of("claim c step: .\n  a < x\n  if p: a < b < x\n  by order @p#1 + @p#2\n") == "as_printed");
  CHECK(status_of("claim one step: .\n  a = 2 b\n  if e: a/2 = b\nclaim c step: .\n  a + b = 3 b\n"
                  "  if e: a/2 = b\n  by putting in one\n") == "as_printed");
  CHECK(status_of("claim c step: .\n  a < b\n  by counterexample at a = 1, b = 0\n") == "refuted");
  CHECK(status_of("claim c step: .\n  a <= a + b^2\n  by counterexample at a = 0, b = 1\n") == "undecided");
  // Of a wrong formula the corrected form is proved.
  CHECK(status_of("claim c identity: .\n  (a - b)^2 = a^2 + 2 a b + b^2\n  corrected (a + b)^2 = a^2 + 2 a b "
                  "+ b^2\n") == "misprint_corrected");
  // A premise at other values; the sum of blocks takes the size of what is stated; nothing is needed.
  CHECK(status_of("claim one step: .\n  (x + 1)^2 = x^2 + 2 x + 1\nclaim c step: .\n"
                  "  (b + 1)^2 = b^2 + 2 b + 1\n  by combination @one[x = b]\n") == "as_printed");
  CHECK(status_of("claim c step: .\n  [a; b] = 0\n  if e: a = 0\n  if z: b = 0\n"
                  "  by combination [1; 0] @e + [0; 1] @z\n") == "as_printed");
  CHECK(status_of("claim c step: .\n  a - a = 0\n  by combination 0\n") == "as_printed");
  // More than one divisor; a square that is positive where something is.
  CHECK(status_of("claim c step: .\n  0 < x\n  if e: a x = b\n  if p: 0 < a\n  if q: 0 < b\n"
                  "  by order @q + @e times @p\n") == "as_printed");
  CHECK(status_of("claim c step: .\n  |x| < a\n  if p: 0 < a\n  if q: x^2 < a^2\n"
                  "  by order @q positive p\n") == "as_printed");
  CHECK(status_of("claim c step: .\n  |x| < a\n  if q: x^2 < a^2\n  by order @q\n") == "refuted");
  CHECK(status_of("claim c step: .\n  a != 0\n  if e: a b != 0\n  by nonzero e times a b^2\n") ==
        "as_printed");
  CHECK(status_of("claim c step: .\n  a != 0\n  if e: b != 0\n  by nonzero e times b\n") == "refuted");
  CHECK(status_of("claim c step: .\n  x = pi/2\n  if e: cos(x) = 0\n  if p: 0 < x\n  if q: x < pi\n"
                  "  by zero of cosine x; e; 0; 1\n") == "as_printed");
  CHECK(status_of("claim c step: .\n  x = pi/2\n  if e: cos(x) = 0\n  if p: 0 < x\n  if q: x < 2 pi\n"
                  "  by zero of cosine x; e; 0; 2\n") == "undecided");
  CHECK(status_of("assume e e.id: a = b\n  b = x\nall both = e\nclaim c step: .\n  a = x\n  if both\n"
                  "  by combination @e.id#1 + @e.id#2\n") == "as_printed");
  // Abbreviations with arguments; a line that goes on.
  CHECK(status_of("let f(s, u) = s^2 - u\nclaim c identity: .\n  f(a + b, 2 a b) =\n    a^2 + b^2\n") ==
        "as_printed");
}

TEST_CASE("an equation is read from either side where nobody names the proof") {
  CHECK(status_of("claim c step: .\n  a > 3\n  if e: exp(2) = a\n") == "as_printed");
  CHECK(status_of("claim c step: .\n  a > 8\n  if e: exp(2) = a\n") == "refuted");
  CHECK(status_of("claim c step: .\n  a > 3\n  if e: exp(2) = a\n  by normal form\n") != "as_printed");
}

TEST_CASE("a method that does not fit is refused or decides nothing, in a sentence") {
  const auto status = [](const std::string& content) {
    return to_string(Prover(read(content).claims).prove("mine").status);
  };
  const std::string group =
      "claim g model: .\n  E Z0 = H(t) E Z0\nclaim mine step new: .\n  E Z0 = E E Z0\n  by ";
  CHECK(status(group + "rewriting g for E Z0\n") == "refuted");  // it feeds itself, and a point is found
  const auto said = [&](const std::string& method) {
    try {
      return status(group + method + "\n");
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
  };
  CHECK(said("rewriting g for E + H(t)") == "claim mine: the premise g cannot be solved as wanted");
  CHECK(said("rewriting g over E") == "claim mine divides by E without assuming that it can");
  // Refuted where both sides are the same.
  CHECK(status("claim mine step new: .\n  V > 0\n  by normal form\n") == "refuted");
  CHECK(status("claim mine step new: .\n  V != 0\n  by normal form\n") == "refuted");
  CHECK(status("claim mine step new: .\n  cos(pi*tau) > -1\n  by normal form\n") == "refuted");
}

TEST_CASE("motions of a paper of its own") {
  const std::string paper =
      "paper P\nsymbols w, b, c, v in 0 < w\nsymbols Z: motion of 2\n"
      "let turned(s) = [cos(w s), sin(w s)/w; -w sin(w s), cos(w s)]\n"
      "assume moves: d/dt[Z(t)] = [0, 1; -w^2, 0] Z(t) for b < t < c\n"
      "assume inside: b <= t <= c\nassume begins: Z(b) = [v; 0]\n";
  const std::string every =
      "claim every theorem: .\n  Z(t) = turned(t - b) Z(b)\n  if moves, inside\n  by flow turned(t); [0; 0]; "
      "moves\n";
  const Paper whole = read(
      paper + every +
      "claim from theorem: .\n  Z(t) = [v cos(w (t - b)); -v w sin(w (t - b))]\n  if moves, inside, begins\n"
      "  by flow turned(t); [0; 0]; moves from begins\n"
      "claim wrong theorem: .\n  Z(t) = Z(b)\n  if moves, inside\n  by flow turned(t); [0; 0]; moves\n"
      "claim false theorem: .\n  Z(t) = turned(t - b) Z(b)\n  if moves, inside\n  by flow turned(2 t); [0; "
      "0]; moves\n"
      "claim outside theorem: .\n  Z(t) = turned(t - b) Z(b)\n  if moves\n  by flow turned(t); [0; 0]; "
      "moves\n");
  const symbols::InVocabulary scope(whole.vocabulary);
  Prover prover(whole.claims);
  for (const char * proved : {"every", "from"}) {
    CAPTURE(proved);
    CHECK(to_string(prover.prove(proved).status) == "as_printed");
    CHECK(prover.prove(proved).outcome.obeyed == Obeyed::theorem);
  }
  for (const char * open : {"wrong", "false", "outside"}) {
    CHECK(to_string(prover.prove(open).status) == "undecided");
  }
  // Two laws at one time: nothing obeys both, and what follows from them is of nothing.
  const Paper two = read(paper +
                         "claim both theorem: .\n  Z(t) = turned(t - b) Z(b)\n  if moves, inside\n"
                         "  if other: d/dt[Z(t)] = [1; 1] for b < t < c\n  if lasts: b < c\n"
                         "  by flow turned(t); [0; 0]; moves\n");
  const symbols::InVocabulary other(two.vocabulary);
  Prover second(two.claims);
  CHECK(to_string(second.prove("both").status) == "undecided");
  // "Z = 0" is refuted by a motion, which a claim before states.
  CHECK(statuses(read(paper + every + "claim rest theorem: .\n  v = 0\n  if moves, begins\n")).at("rest") !=
        "as_printed");
}

TEST_CASE("remarks, judgements and results are a part of a paper") {
  const std::string claims = "claim c step: .\n  a = b\nclaim d step new: .\n  a/b = a (1/b)\n";
  const Paper paper =
      read("paper P\nsymbols a, b\n" + claims +
           "words all: whatever $a$ and $b$ are\n"
           "remark c\n  place line 3\n  says $a$ is $b$,\n    {all}\n  fact it is not\n"
           "judgement d\n  kept nothing is lost at $b = 0$\n  shown by c, d\n"
           "result quotients: Quotients\n  theorem {all}, $a/b = a (1/b)$\n  claims d\n  lists yes\n");
  REQUIRE(paper.remarks.size() == 1);
  CHECK(remark_on(paper, "c")->says == "$a$ is $b$, whatever $a$ and $b$ are");
  CHECK(remark_on(paper, "c")->place == "line 3");
  REQUIRE(paper.judgements.size() == 1);
  CHECK_FALSE(paper.judgements[0].matters);
  CHECK(paper.judgements[0].shown_by == std::set<std::string>{"c", "d"});
  REQUIRE(paper.results.size() == 1);
  CHECK(paper.results[0].theorem == "whatever $a$ and $b$ are, $a/b = a (1/b)$");
  CHECK(paper.results[0].lists);
  CHECK(refusal_of("remark c\n  says x\n  fact y\n") == "F:3: there is no claim 'c' before this line");
  CHECK(refusal_of(claims + "remark c\n  says x\n") ==
        "F:7: a remark has 'says', what the paper says, and 'fact', what is so");
  CHECK(refusal_of(claims + "remark c\n  says x\n  says y\n") == "F:9: 'says' stands there twice");
  CHECK(refusal_of(claims + "remark c\n  said x\n") ==
        "F:8: 'said': the lines of 'remark' begin with place, says, fact, because, see, quote, note");
  CHECK(refusal_of(claims + "remark c\n  says <b>\n") == "F:8: '<b>': words have no \\, <, >, {, } or &");
  CHECK(refusal_of(claims + "judgement c\n  lost x\n  kept y\n") ==
        "F:7: a judgement of a hypothesis has either 'lost', what is so where it fails, or 'kept'");
  CHECK(refusal_of(claims + "result r: R\n  theorem x\n") ==
        "F:7: a result has 'theorem', and 'claims' that say it");
  CHECK(refusal_of(claims + "result r: R\n  theorem x\n  claims e\n") ==
        "F:7: there is no claim 'e' before this line");
  // A file that lists statements has these, and no others.
  const Paper stated =
      read("paper P\nsymbols a, b\n" + claims +
           "statements First part\nstatement T1 figure [Fig. 1] it shows $a$\n  but a drawing\n"
           "statement T2 step [line 3] the first,\n    in words\n  claims c\n  see d\n");
  REQUIRE(stated.statements.size() == 2);
  CHECK(stated.statements[0].missing == "a drawing");
  CHECK(stated.statements[1].words == "the first, in words");
  CHECK(stated.statements[1].section == "First part");
  CHECK(stated.statements[1].claims == std::vector<std::string>{"c"});
  CHECK(is_stated(stated, "c"));
  CHECK_FALSE(is_stated(stated, "d"));
  CHECK(refusal_of(claims + "statement T1 step line 3\n") ==
        "F:7: a statement is an id, a kind, its place in square brackets, and words");
  CHECK(refusal_of(claims + "statement T1 step [line 3] x\n") ==
        "F:7: T1: 'claims' state it, or 'but' says why there are none");
  CHECK(refusal_of("words x\n") == "F:3: a name, ':' and what it stands for belong to 'words', each once");
}

TEST_CASE("a sine is positive between 0 and pi, and not beyond") {
  const auto sine = [](const std::string& range) {
    return status_of("claim c step new: .\n  a sin(x) > 0\n  if e: a > 0\n  if r: " + range +
                     "\n  by order sin(x) @e\n");
  };
  CHECK(sine("0 < x < pi") == "proved");
  CHECK(sine("0 < 2 x < pi") == "proved");
  CHECK(sine("0 < x < 4") != "proved");
  CHECK(sine("-1 < x < pi") != "proved");
  CHECK(sine("0 <= x < pi") != "proved");
}

TEST_CASE("what a file may not say is refused with its place") {
  CHECK(refusal("nonsense\n") ==
        "F:1: 'nonsense' begins no entry: there are paper, symbols, let, section, assume, all, claim, words, "
        "remark, judgement, result, statements, statement");
  CHECK(refusal("  indented\n") == "F:1: an indented line belongs to an entry, and there is none before it");
  CHECK(refusal("paper P\n") == "F: there is no claim in it");
  CHECK(refusal("symbols a\n") ==
        "F:1: 'symbols' belongs to a paper of its own: begin the file with an entry 'paper'");
  CHECK(refusal("section s\npaper P\n") == "F:2: 'paper' stands before all other entries");
  CHECK(refusal_of("symbols a\n") == "F:3: 'a' has a meaning already");
  CHECK(refusal_of("symbols omega_0, omega0\n") ==
        "F:3: 'omega0' is printed as 'omega_0' is: take another name");
  CHECK(refusal_of("symbols zdot1\nsymbols zdot_1: motion of 2\n") ==
        "F:4: 'zdot_1' is printed as 'zdot1' is: take another name");
  CHECK(refusal_of("symbols 2a\n") ==
        "F:3: '2a' is no name for a symbol: a name is a letter, then letters and digits");
  for (const char * kind : {"motion", "motion of 9", "motion of", "matrix", "motion of 2x2"}) {
    CHECK(refusal_of(std::string("symbols Y: ") + kind + " in 0 < Y\n") ==
          std::string("F:3: '") + kind +
              "': after ':' stands 'motion of' and how many numbers it has, from 1 to 8");
  }
  CHECK(refusal_of("symbols Y: motion of 2\nclaim c step: .\n  Y = 0\n").starts_with("F:5: "));
  CHECK(refusal_of("symbols Y: motion of 2 in 0 < Y\n").starts_with("F:3: "));
  CHECK(refusal_of("symbols y in y != 0\n") ==
        "F:3: 'y != 0': a domain says that a symbol of the file is less or greater than a number");
  CHECK(refusal_of("symbols y in 1 < y, y < 0\n") ==
        "F:3: 'y < 0': with what is said before no value is left");
  // Whatever is said first: in an empty domain everything would hold.
  for (const char * domain :
       {"7 < y, 0 < y, y < 5", "0 < y, 7 < y, y < 5", "y < 5, y < 9, 7 < y", "0 < y < -1/2"}) {
    CHECK(refusal_of(std::string("symbols y in ") + domain + "\n")
              .ends_with("with what is said before no value is left"));
  }
  for (const char * domain : {"pi < 3", "t < 0", "1 < 0"}) {
    CHECK(refusal_of(std::string("symbols y in ") + domain + "\n")
              .ends_with("is less or greater than a number"));
  }
  CHECK(refusal_of("let f(y, y) = y\n") == "F:3: 'y' is no name of a parameter, or that of two");
  CHECK(refusal_of("let y = y + 1\n") == "F:3: column 2: no symbol 'y'; there are a, b, t, x");
  CHECK(refusal_of("let y(s) = s\nclaim c step: .\n  y(a, b) = 1\n") ==
        "F:5: column 1: y takes 1 arguments, and here are 2");
  // v(a) would be d/dt[a^2] = 0, and w(t) would be d/dt[t^2].
  for (const char * rate : {"let v(t) = d/dt[t^2]\n", "let w(s) = d/dt[s t]\n"}) {
    CHECK(refusal_of(rate).ends_with(
        "is a rate of something with a parameter in it: write d/dt[…] where it is needed"));
  }
  CHECK(refusal_of("claim c step: .\n  a = z\n") == "F:4: column 5: no symbol 'z'; there are a, b, t, x");
  CHECK(refusal_of("claim c step: .\n  H1(t) = 1\n").starts_with("F:4: column 1: no symbol 'H1'"));
  CHECK(refusal_of("claim c step: .\n") == "F:3: the claim c states nothing");
  CHECK(refusal_of("claim ../c step: .\n  a = a\n") ==
        "F:3: '../c' is no id of a claim: letters, digits, '_' and '.'");
  CHECK(refusal_of("claim c step: .\n  a = a\nclaim c step: .\n  a = a\n") == "F:5: there are two claims c");
  CHECK(refusal_of("claim c stop: .\n  a = a\n")
            .starts_with("F:3: 'stop' is no kind of claim: there are definition"));
  CHECK(
      refusal_of("claim c step mine: .\n  a = a\n").starts_with("F:3: 'mine' is no origin: there are paper"));
  CHECK(refusal_of("claim c step: <script>\n  a = a\n") ==
        "F:3: '<script>': words have no \\, <, >, {, } or &");
  CHECK(refusal_of("claim c step: \\input{x}\n  a = a\n") ==
        "F:3: '\\input{x}': words have no \\, <, >, {, } or &");
  CHECK(refusal_of("claim c step: half $a\n  a = a\n") ==
        "F:3: 'half $a': a formula in words stands between two dollars");
  CHECK(refusal_of("claim c step: .\n  a = b\n  if e\n") == "F:5: nothing is assumed as 'e'");
  CHECK(refusal_of("claim c step: .\n  a = b\n  if a > 0\n") ==
        "F:5: nothing is assumed as 'a > 0'; what is assumed here takes a name: 'if NAME: a > 0'");
  CHECK(refusal_of("claim c step: .\n  a = b\n  by magic\n")
            .starts_with("F:5: 'magic' is no method of proof: there are normal form"));
  CHECK(refusal_of("claim c step: .\n  a = b\n  by rewriting d\n") ==
        "F:5: 'd' is neither assumed by c nor a claim before it");
  CHECK(refusal_of("claim c step: .\n  a = b\n  if e: a = b\n  by combination @e#2\n") ==
        "F:6: '@e#2': e says 1 things");
  CHECK(refusal_of("claim c step: .\n  a = b\n  if e: a = b\n  by combination a\n") ==
        "F:6: each product of a combination has one @id, and 'a' has 0");
  CHECK(refusal_of("claim c step: .\n  a = b\n  if e: a = b\n  by combination @e; @e\n") ==
        "F:6: c states 1 things, and its proof is of 2");
  CHECK(refusal_of("claim c step: .\n  a = b\n  expect wonder\n") == "F:5: 'wonder' is no status of a claim");
  CHECK(refusal_of("claim c step: .\n  a = b\n  by normal form\n  by normal form\n") ==
        "F:6: the claim c has two proofs");
  // What only this program's own text may say.
  CHECK(refusal_of("program example S\n") == "F:3: there is no program 'example S'");
  CHECK(refusal_of("claim c step: .\n  a = b\n  by program\n").starts_with("F:5: 'program' is no method"));
  CHECK(refusal_of("claim c step: .\n  a = b\n  part one\n  part two\n") ==
        "F:3: the claim c has words for 2 parts, and states 1 things");
  CHECK(refusal_of("symbols abs: motion of 1\n") ==
        "F:3: 'abs' is a word of the format: a symbol needs another name");
  CHECK(refusal_of("symbols part\n") == "F:3: 'part' is a word of the format: a symbol needs another name");
  CHECK(refusal_of("claim c step: .\n  a = b\n  conversely by normal form\n") ==
        "F:5: 'normal form': what is assumed need not follow from what is stated, says a counterexample");
  CHECK(refusal_of("all e = f\n") == "F:3: nothing is assumed as 'f'");
  CHECK(refusal_of("assume e: a = b\nall e = e\n") == "F:4: there are two assumptions e");
  const auto refused_proof = [](const std::string& line) {
    return refusal_of("claim c step: .\n  a < b\n  if e: a < b\n  if z: a = 0\n  by " + line + "\n");
  };
  CHECK(refused_proof("combination @z[x = 1") == "F:7: '@z[': the bracket is not closed");
  CHECK(refused_proof("order @e times @z") == "F:7: '@e times @z': after 'times' stands what is positive");
  CHECK(refused_proof("order @e positive w") == "F:7: 'w' is neither assumed by c nor a claim before it");
  CHECK(refused_proof("nonzero e") == "F:7: 'e': after the assumption stand 'times' and a multiplier");
  CHECK(refused_proof("nonzero w times a") == "F:7: c assumes nothing as 'w'");
  CHECK(refused_proof("flow a; b") ==
        "F:7: 'a; b': there stand the flow, the forced motion, and what is assumed of the phase");
  CHECK(
      refused_proof("mean value 1; e; e; e")
          .ends_with("there stand a row, and what is assumed of phase, slope, beginning, end and duration"));
  CHECK(refused_proof("zero of cosine a; z; 0")
            .ends_with("there stand an angle, a premise, and two numbers between which angle/pi lies"));
  CHECK(refused_proof("zero of cosine a; z; 0; x").starts_with("F:7: "));
  CHECK(refused_proof("decrease e").ends_with("there stand a premise and a weight"));
  CHECK(
      refused_proof("periodic decrease e; 1").ends_with("there stand a premise, a weight and what returns"));
  CHECK(refused_proof("instances e with x") ==
        "F:7: 'x': after 'with' stand a function, '=' and its value at t");
  CHECK(refused_proof("counterexample at a = 1; because b = 2")
            .ends_with("a counterexample goes on with 'where', 'with' or 'not'"));
  CHECK(refusal_of("let big = (a + b)^2\nlet big2 = " + std::string(150, '(') + "big" +
                   std::string(150, ')') + "\nclaim c step: .\n  big2 = 1\n") == "");
  CHECK(refusal(std::string(5000000, 'x')) == "F: a file of claims has at most 4000000 characters");
}

TEST_CASE("a parameter does not take the place of a symbol of its name") {
  // q speaks of the symbol x, and f puts its argument in for its parameter alone.
  const std::string lets = "let q = x^2\nlet f(x) = q + x\nlet g(t) = t^2 + a\n";
  CHECK(status_of(lets + "claim c step: .\n  f(3) = 12\n") == "refuted");
  CHECK(status_of(lets + "claim c step: .\n  f(3) = x^2 + 3\n") == "as_printed");
  CHECK(status_of(lets + "claim c step: .\n  f(q) = 2 x^2\n") == "as_printed");
  CHECK(status_of(lets + "claim c step: .\n  g(t + 1) = t^2 + 2 t + 1 + a\n") == "as_printed");
  CHECK(status_of("symbols y in -1 < y, y < 1/2\nclaim c step: .\n  y < 1\n") == "as_printed");
}

TEST_CASE("a name means what the file says, whatever is called alike") {
  // A rate within a sum has a name of its own, which a motion may have, too.
  const std::string motion = "symbols D1: motion of 1\nclaim c step: .\n  d/dt[sin(t)] + D1(t) = ";
  CHECK(status_of(motion + "2 cos(t)\n") == "undecided");
  CHECK(status_of(motion + "cos(t) + D1(t)\n") == "as_printed");
  const std::string alike = "symbols x_1\nlet x1 = 5\nclaim c step: .\n  ";
  CHECK(status_of(alike + "x_1 = 5\n") == "refuted");
  CHECK(status_of(alike + "x1 = 5\n") == "as_printed");
}

TEST_CASE("abbreviations of abbreviations do not grow without end") {
  std::string entries = "let n0 = a + b\n";
  for (int k = 1; k < 30; ++k) {
    entries +=
        "let n" + std::to_string(k) + " = n" + std::to_string(k - 1) + " * n" + std::to_string(k - 1) + "\n";
  }
  CHECK(refusal_of(entries + "claim c step: .\n  n29 = 1\n")
            .find("stands for a formula of more than 20000 parts") != std::string::npos);
}

TEST_CASE("what contradicts itself in a file proves nothing") {
  CHECK(status_of("claim c step: .\n  a = b\n  if e: x = 1\n  if f: x = 2\n") == "undecided");
  CHECK(statuses(read("paper P\nsymbols y in 0 < y\nclaim c step: .\n  y = 7\n  if e: y = -1\n")).at("c") ==
        "undecided");
}
