#include "symbolic/objects/object_lines.hpp"

#include <algorithm>
#include <map>

#include "symbolic/typeset/latex.hpp"

namespace stickslip::symbolic::objects {

using namespace algebra;
using namespace typeset;

namespace {

using GiNaC::ex;

// About how many characters wide a formula is when it is set: a command is one, a fraction as wide as its
// wider part.
std::size_t width(std::string_view text) {
  std::size_t result = 0;
  const auto group = [&](std::size_t open) {
    std::size_t close = open;
    for (int depth = 0; close < text.size(); ++close) {
      depth += text[close] == '{' ? 1 : text[close] == '}' ? -1 : 0;
      if (depth == 0) {
        break;
      }
    }
    return close;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with("\\frac{")) {
      const std::size_t over = group(i + 5);
      const std::size_t under = group(over + 1);
      result +=
          std::max(width(text.substr(i + 6, over - i - 6)), width(text.substr(over + 2, under - over - 2)));
      i = under;
    } else if (text[i] == '\\') {
      const std::size_t end = std::min(
          text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", i + 1), text.size());
      result += text.substr(i, end - i) == "\\cos" || text.substr(i, end - i) == "\\sin" ? 3 : 1;
      i = end - 1;
    } else if (text[i] != '{' && text[i] != '}' && text[i] != '_' && text[i] != '^') {
      ++result;
    }
  }
  return result;
}

// The terms of a sum, in an order that does not depend on how it was built.
std::vector<ex> terms_of(const ex& sum) {
  std::map<std::string, ex> by_text;
  if (!GiNaC::is_a<GiNaC::add>(sum)) {
    return {sum};
  }
  for (const ex& term : sum) {
    by_text.emplace(text(term), term);
  }
  std::vector<ex> result;
  for (const auto& entry : by_text) {
    result.push_back(entry.second);
  }
  return result;
}

// How wide a line may be.
constexpr std::size_t page = 52;

// The factor of a product that is a sum of most terms, of equals the last by its text; 0 if there is none.
ex longest_sum(const ex& product) {
  std::map<std::pair<std::size_t, std::string>, ex> sums;
  for (const ex& factor : GiNaC::is_a<GiNaC::mul>(product) ? product : ex(GiNaC::lst{product})) {
    if (GiNaC::is_a<GiNaC::add>(factor)) {
      sums.emplace(std::pair(factor.nops(), text(factor)), factor);
    }
  }
  return sums.empty() ? ex(0) : sums.rbegin()->second;
}

// The terms, those too wide for a line multiplied out by their longest sum.
std::vector<ex> narrow(const std::vector<ex>& terms) {
  std::vector<ex> result;
  for (const ex& term : terms) {
    const ex longest = longest_sum(term);
    if (width(latex(term)) <= page || longest.is_zero()) {
      result.push_back(term);
      continue;
    }
    // GiNaC keeps a product of a sum with either sign: the order is that of the terms when multiplied out.
    ex product = 0;
    for (const ex& part : terms_of(longest)) {
      product += part * (term / longest);
    }
    const std::vector<ex> parts = narrow(terms_of(product));
    result.insert(result.end(), parts.begin(), parts.end());
  }
  return result;
}

}  // namespace

ex chi() {
  return symbol("chi");
}
ex eta() {
  return symbol("eta");
}
ex omega() {
  return symbol("omega");
}
ex phi() {
  return symbol("phi");
}
model::Modes<ex> modes() {
  return {symbol("omega1"), symbol("omega2"), symbol("lambda1"), symbol("lambda2")};
}
model::Parameters<ex> parameters() {
  return {chi(), eta(), symbol("us"), symbol("V"), omega(), symbol("p")};
}
model::Vector2<ex> Q_symbols() {
  return {symbol("q1"), symbol("q2")};
}
model::Vector2<ex> d0_symbols() {
  return {symbol("d01"), symbol("d02")};
}

ex written_in(const ex& value, Unknowns unknowns) {
  return unknowns == Unknowns::omega ? in_frequencies(value) : value;
}

Line scalar(const std::string& left, const ex& value, Unknowns unknowns) {
  return {left, latex(written_in(value, unknowns)), {value}};
}

Line broken(const std::string& left, const std::vector<std::string>& terms) {
  Line line{left, ""};
  std::size_t used = width(left) + 3;
  for (const std::string& term : terms) {
    if (!line.right.empty() && used + width(term) > page) {
      line.right += " \\\\\n{}";
      used = 2;
    }
    line.right += term;
    used += width(term);
  }
  return line;
}

Line sum(const std::string& left, const ex& value) {
  std::vector<std::string> texts;
  for (const ex& term : narrow(terms_of(value))) {
    const std::string text = latex(term);
    texts.push_back((texts.empty() || text.starts_with("-") ? "" : "+") + text);
  }
  Line line = broken(left, texts);
  line.entries = {value};
  return line;
}

void append_meanings(Lines& lines, Unknowns unknowns) {
  if (unknowns == Unknowns::omega) {
    lines.push_back(scalar("\\chi", chi(), unknowns));
    lines.push_back(scalar("\\eta", eta(), unknowns));
    lines.push_back(scalar("\\lambda_1", modes().lambda1, unknowns));
    lines.push_back(scalar("\\lambda_2", modes().lambda2, unknowns));
  }
}

}  // namespace stickslip::symbolic::objects
