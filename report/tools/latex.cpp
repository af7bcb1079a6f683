#include "report/tools/latex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <vector>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "report/tools/json.hpp"
#include "report/tools/plot.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::tools {

namespace {

const Tool& typesetter() {
  static const Tool tool{"node", "nodejs", "set formulas"};
  return tool;
}

Json set(const Json& pages) {
  const std::string answer =
      run(typesetter(), {"-e", templates().at("katex.js")}, Json{{"pages", pages}}.dump(), "/");
  if (!Json::accept(answer)) {
    throw InputOutputError("cannot set formulas: the answer of node is not whole");
  }
  return Json::parse(answer);
}

}  // namespace

void require_katex() {
  require(typesetter());
  (void)set(Json::array());
}

std::vector<File> with_formulas(const std::vector<File>& pages) {
  Json sent = Json::array();
  for (const File& page : pages) {
    sent.push_back({{"name", page.name}, {"content", page.content}});
  }
  const Json answer = set(sent);
  std::vector<File> result;
  for (const Json& page : answer.at("pages")) {
    result.push_back({page.at("name"), page.at("content")});
  }
  result.push_back({"katex.css", answer.at("css")});
  return result;
}

namespace {

namespace fs = std::filesystem;

const Tool& compiler() {
  static const Tool tool{"pdflatex", "texlive-latex-recommended", "compile LaTeX"};
  return tool;
}

// What a pass leaves for the next one: numbers of pages, the contents, bookmarks.
std::string notes(const Workshop& workshop, const std::string& name) {
  return workshop.content(name + ".aux") + workshop.content(name + ".toc") + workshop.content(name + ".out");
}

// The first complaint in what TeX writes down.
std::string complaint(const std::string& log) {
  const std::size_t start = log.find("\n! ");
  return start == std::string::npos ? ""
                                    : ": " + log.substr(start + 3, log.find('\n', start + 1) - start - 3);
}

// Once without a document, then until the pass finds the notes that it leaves; whether it came to that.
bool settled(const Workshop& workshop, const std::string& name) {
  constexpr int most_passes = 6;
  std::vector<std::string> arguments{"-halt-on-error", "-interaction=nonstopmode", "-no-shell-escape",
                                     "-draftmode", name + ".tex"};
  (void)run(compiler(), arguments, {}, workshop.path());
  std::erase(arguments, "-draftmode");
  for (int pass = 2; pass <= most_passes; ++pass) {
    const std::string before = notes(workshop, name);
    (void)run(compiler(), arguments, {}, workshop.path());
    if (notes(workshop, name) == before) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool can_compile() {
  return is_there(compiler());
}

Compiled compile(const std::vector<File>& files, const std::string& name) {
  if (!can_compile()) {
    return {{}, fmt::format("{} is not there (Debian has it in {})", compiler().program, compiler().package)};
  }
  try {
    const Uninterrupted until_it_is_cleaned_up;
    const Workshop workshop("compile LaTeX");
    write_files(workshop.path(), files);
    try {
      if (!settled(workshop, name)) {
        return {{}, "its numbers of pages do not settle"};
      }
    } catch (const InputOutputError&) {
      return {{}, fmt::format("{} failed{}", compiler().program, complaint(workshop.content(name + ".log")))};
    }
    return {{{name + ".pdf", read_file(workshop.path() / (name + ".pdf"))}}, {}};
  } catch (const InputOutputError& error) {
    return {{}, error.what()};
  }
}

namespace {

// The widest line, in letters.
constexpr double column = 34;

// What stands between the brace at `at` and its partner; `at` is then behind it.
std::string group(const std::string& latex, std::size_t& at) {
  const std::size_t from = at + 1;
  for (int depth = 0; at < latex.size(); ++at) {
    depth += latex[at] == '{' ? 1 : latex[at] == '}' ? -1 : 0;
    if (depth == 0) {
      break;
    }
  }
  return latex.substr(from, at++ - from);
}

// In letters: indices are smaller, signs have space about them, of a fraction the wider side counts.
double width(const std::string& latex) {
  static const std::regex name(R"(\\[a-z]+)");
  double result = 0;
  for (std::size_t at = 0; at < latex.size();) {
    std::smatch found;
    if (latex.compare(at, 5, "\\frac") == 0) {
      at += 5;
      const std::string above = group(latex, at), below = group(latex, at);
      result += std::max(width(above), width(below));
    } else if ((latex[at] == '_' || latex[at] == '^') && at + 1 < latex.size()) {
      ++at;
      const std::string index = latex[at] == '{' ? group(latex, at) : latex.substr(at++, 1);
      result += 0.7 * width(index);
    } else if (std::regex_search(latex.begin() + static_cast<long>(at), latex.end(), found, name,
                                 std::regex_constants::match_continuous)) {
      const std::string word = found.str();
      at += word.size();
      result += word == "\\left" || word == "\\right" || word == "\\dot" ? 0
                : word == "\\sin" || word == "\\cos" || word == "\\leq"  ? 3
                                                                         : 1.2;
    } else {
      const char c = latex[at++];
      result += c == ' ' || c == '{' || c == '}' ? 0 : c == '+' || c == '-' || c == '=' || c == '<' ? 2.5 : 1;
    }
  }
  return result;
}

// Cut in front of what matches and stands in no bracket, behind no sign.
std::vector<std::string> pieces(const std::string& latex, const std::regex& sign) {
  std::vector<std::string> result;
  std::size_t begin = 0;
  for (std::sregex_iterator found(latex.begin(), latex.end(), sign), end; found != end; ++found) {
    const auto at = static_cast<std::size_t>(found->position());
    const std::string before = latex.substr(0, at);
    const auto count = [&](const std::string& what) {
      int times = 0;
      for (std::size_t k = 0; (k = before.find(what, k)) != std::string::npos; k += what.size()) {
        ++times;
      }
      return times;
    };
    const bool behind_sign = before.empty() || std::string("+-=<>").find(before.back()) != std::string::npos;
    if (!behind_sign && count("{") == count("}") && count("\\left") == count("\\right")) {
      result.push_back(latex.substr(begin, at - begin));
      begin = at;
    }
  }
  result.push_back(latex.substr(begin));
  return result;
}

// In front of signs and relations, and of brackets where that leaves what is too wide.
std::vector<std::string> pieces(const std::string& latex) {
  static const std::regex sign(R"( (\+|-|=|<|>|\\leq|\\geq|\\neq) )"), bracket(R"( \\left)");
  std::vector<std::string> result;
  for (const std::string& piece : pieces(latex, sign)) {
    if (width(piece) <= column) {
      result.push_back(piece);
      continue;
    }
    bool first = true;
    for (const std::string& factor : pieces(piece, bracket)) {
      result.push_back(first ? factor : " \\cdot" + factor);
      first = false;
    }
  }
  return result;
}

}  // namespace

std::string displayed(const std::string& latex) {
  std::vector<std::string> lines;
  for (const std::string& piece : pieces(latex)) {
    if (!lines.empty() && width(lines.back() + piece) <= column) {
      lines.back() += piece;
    } else {
      lines.push_back(piece);
    }
  }
  const std::string kind = lines.size() == 1 ? "gather*" : "multline*";
  std::string result = "\\begin{" + kind + "}\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    result += (i == 0 ? "" : " \\\\\n{}") + lines[i];
  }
  return result + "\n\\end{" + kind + "}";
}

}  // namespace stickslip::report::tools
