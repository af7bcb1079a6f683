#include "report/audit/pages.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <regex>
#include <set>

#include "core/error.hpp"
#include "report/tools/latex.hpp"
#include "report/tools/templates.hpp"
#include "tests/report/audit/sample.hpp"

using namespace stickslip;
using namespace stickslip::report;
using namespace stickslip::report::audit;
using namespace stickslip::report::tools;

namespace {

const Report& sample_report() {
  static const Report report = pages({sample_paper(), sample_audit()}, {});
  return report;
}

std::string page(const std::string& name) {
  for (const File& file : sample_report().files) {
    if (file.name == name) {
      return file.content;
    }
  }
  return {};
}

// Without what KaTeX has made of the formulas: tags, and the source that goes with the MathML.
std::string visible(const std::string& html) {
  const std::string plain = std::regex_replace(html, std::regex("<annotation[^>]*>[^<]*</annotation>"), "");
  return std::regex_replace(plain, std::regex("<[^>]*>"), "");
}

std::set<std::string> matches(const std::string& text, const char * expression) {
  const std::regex regex(expression);
  std::set<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i) {
    found.insert((*i)[1]);
  }
  return found;
}

}  // namespace

TEST_CASE("templates see lists, absent things and escaped text") {
  const Json data = {
      {"empty", Json::array()}, {"list", {"<a>", "b"}}, {"none", nullptr}, {"word", ""}, {"n", 3}};
  CHECK(render("t", "{{#list}}{{.}};{{/list}}{{#has_empty}}x{{/has_empty}}", data, html_format) ==
        "&lt;a&gt;;b;");
  CHECK(render("t", "{{^none}}no{{/none}}{{^has_word}}ne{{/has_word}}{{n}}", data, html_format) == "none3");
  CHECK(render("t", "{{#list}}{{& .}}{{/list}}", data, html_format) == "<a>b");
  CHECK_THROWS_AS(static_cast<void>(render("t", "{{#list}}", data, html_format)), InternalError);
}

TEST_CASE("templates see sentences with formulas, and parts of other files") {
  const Json data = {{"words", "$p < tau$ & $b$"}, {"reason", "$tau = 1$"}, {"witness", nullptr}};
  CHECK(render("t", "{{#prose}}{{&words}}{{/prose}}", data, html_format) ==
        "<tex>p &lt; \\tau</tex> &amp; <tex>b</tex>");
  CHECK(mentions(render("t", "{{>reason.html}}", data, html_format), "<tex>\\tau = 1</tex>"));
}

TEST_CASE("every link of the pages leads somewhere") {
  const std::string statements = page("statements.html");
  const std::string index = page("index.html");
  const std::set<std::string> anchors = matches(statements, "id=\"([^\"]*)\"");
  for (const std::string& target : matches(index, "href=\"statements.html#([^\"]*)\"")) {
    CHECK_MESSAGE(anchors.contains(target), target);
  }
  for (const std::string& target : matches(statements, "href=\"#([^\"]*)\"")) {
    CHECK_MESSAGE(anchors.contains(target), target);
  }
  const std::set<std::string> own = matches(index, "id=\"([^\"]*)\"");
  for (const std::string& target : matches(index, "href=\"#([^\"]*)\"")) {
    CHECK_MESSAGE(own.contains(target), target);
  }
  CHECK(anchors.contains("5.where"));
  CHECK(own.contains("findings"));
}

TEST_CASE("every place has a row among the uses and leads to its claims, which name what they use") {
  const std::string index = page("index.html"), statements = page("statements.html");
  for (const char * place : {"sec2", "sec3", "sec4", "A2"}) {
    CHECK(mentions(index, fmt::format("<th scope=\"row\"><a href=\"statements.html#place-{}\"", place)));
  }
  CHECK(mentions(statements, "<dt>uses</dt><dd class=\"names\"><a href=\"#2\">2</a>"));
  CHECK(mentions(statements, "<dt>used by</dt><dd class=\"names\"><a href=\"#44\">44</a>"));
}

TEST_CASE("a short formula is MathML alone, a long one KaTeX's with MathML inside") {
  const File short_one{"a.html", "<tex>x_1 &lt; y</tex>"};
  const File accented{"b.html", "<tex-display>\\dot x = y</tex-display>"};
  const std::string long_source = "a+b+c+d+e+f+g+h+i+j+k+l+m+n+o+p+q+r+s+t+u";
  const std::vector<File> set =
      with_formulas({short_one, accented, {"c.html", "<tex>" + long_source + "</tex>"}});
  CHECK(set.at(0).content.starts_with("<math>"));
  CHECK(mentions(set.at(0).content, "<math><msub><mi mathvariant=normal>x</mi><mn>1</mn></msub>"));
  CHECK(set.at(1).content.starts_with("<div class=\"formula\"><i class=katex>"));
  CHECK(set.at(2).content.starts_with("<i class=katex>"));
  CHECK(mentions(set.at(2).content, "<math>"));
  CHECK(mentions(set.at(2).content, " aria-hidden=true>"));
  CHECK_FALSE(mentions(set.at(2).content, "<span"));
}

TEST_CASE("a matrix too wide for a telephone is set in a row, and one that fits is not") {
  const std::string wide = "\\cos(\\frac{\\omega_1 \\tau}{2}) + \\sin(\\frac{\\omega_1 \\tau}{2})";
  const auto display = [](const std::string& entry) {
    return "<tex-display>\\begin{pmatrix} a &amp; b \\\\ " + entry + " &amp; " + entry +
           " \\end{pmatrix}</tex-display>";
  };
  const std::vector<File> set =
      with_formulas({{"a.html", display("c")}, {"b.html", display(wide)}, {"c.html", "<tex>x</tex>."}});
  CHECK(mentions(set.at(0).content, "<mtable>"));
  CHECK_FALSE(mentions(set.at(1).content, "<mtable>"));
  CHECK(mentions(set.at(1).content, "<mo>;</mo>"));
  CHECK(set.at(2).content == "<span class=whole><math><mi mathvariant=normal>x</mi></math>.</span>");
}

TEST_CASE("formulas are set, with MathML inside, and none is left as source") {
  for (const char * name : {"index.html", "statements.html"}) {
    const std::string html = page(name);
    CHECK(mentions(html, "<math"));
    CHECK_FALSE(mentions(html, "<tex>"));
    CHECK_FALSE(mentions(html, "<tex-"));
    CHECK_FALSE(mentions(visible(html), "\\"));
  }
  CHECK(mentions(page("katex.css"), "url(data:font/woff2;base64,"));
  CHECK_FALSE(mentions(page("katex.css"), "url(fonts/"));
  CHECK_THROWS_AS((void)with_formulas({{"a.html", "<tex>\\nosuchcommand</tex>"}}), InputOutputError);
}

TEST_CASE("the findings stand in the order of their weight") {
  const std::string html = page("index.html");
  std::size_t last = 0;
  for (const char * title : {"Not decided", "What does not hold as the paper has it", "Digits",
                             "Hypotheses that the paper does not state"}) {
    const std::size_t place = html.find(fmt::format("<h3>{}", title));
    CHECK(place != std::string::npos);
    CHECK(place > last);
    last = place;
  }
  CHECK(mentions(html, "Should read"));
  CHECK(html.find("The paper says") < html.find("In fact"));
  CHECK(html.find("In fact") < html.find("Because"));
  CHECK(mentions(html, "7.750"));  // 7.7503 with the three digits of 7.749
}

TEST_CASE("the paper's statements and the new results are on the pages") {
  for (const char * id : {"S001", "S005"}) {
    CHECK(mentions(page("paper.html"), fmt::format("id=\"{}\"", id)));
    CHECK(mentions(page("index.html"), fmt::format("href=\"paper.html#{}\"", id)));
  }
  CHECK(mentions(page("paper.html"), "a drawing"));
  CHECK(mentions(page("index.html"), "Time is reversed"));
  CHECK(mentions(page("statements.html"), "new result"));
}

TEST_CASE("text is escaped for the page it stands on, nothing of a template remains") {
  const std::string html = page("index.html");
  const std::string tex = page("audit.tex");
  CHECK(mentions(html, " &amp; "));
  CHECK(mentions(page("statements.html"), "&quot;0&quot;."));
  CHECK(mentions(tex, "for $x < y$ \\& $y$ $>$ ''0''."));
  CHECK(mentions(tex, "$u_s$ is 100\\% of \\{$F$\\}"));
  CHECK(mentions(tex, "$\\omega - \\omega_1 \\neq 0$"));
  CHECK_FALSE(mentions(html, "{{"));
  CHECK_FALSE(mentions(tex, "<<"));
  CHECK_FALSE(mentions(tex, ">>"));
}

TEST_CASE("two runs make the same pages") {
  const std::vector<File>& first = sample_report().files;
  const std::vector<File> second = pages({sample_paper(), sample_audit()}, {}).files;
  REQUIRE(first.size() >= 7);
  REQUIRE(first.size() == second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(first[i].name == second[i].name);
    CHECK(first[i].content == second[i].content);
  }
}
