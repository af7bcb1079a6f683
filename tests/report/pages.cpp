#include "report/pages.hpp"

#include <doctest/doctest.h>

#include <regex>
#include <set>

#include "core/error.hpp"
#include "report/escape.hpp"
#include "report/templates.hpp"
#include "tests/report/sample.hpp"

using namespace stickslip;
using namespace stickslip::report;

namespace {

std::string page(const std::string& name) {
  for (const File& file : pages(sample_audit())) {
    if (file.name == name) {
      return file.content;
    }
  }
  return {};
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::set<std::string> matches(const std::string& text, const char* expression) {
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
  CHECK(render("t", "{{#list}}{{.}};{{/list}}{{#has_empty}}x{{/has_empty}}", data, escape_html) ==
        "&lt;a&gt;;b;");
  CHECK(render("t", "{{^none}}no{{/none}}{{^has_word}}ne{{/has_word}}{{n}}", data, escape_html) == "none3");
  CHECK(render("t", "{{#list}}{{& .}}{{/list}}", data, escape_html) == "<a>b");
  CHECK_THROWS_AS(static_cast<void>(render("t", "{{#list}}", data, escape_html)), InternalError);
}

TEST_CASE("every link of the page leads somewhere") {
  const std::string html = page("index.html");
  const std::set<std::string> anchors = matches(html, "id=\"([^\"]*)\"");
  for (const std::string& target : matches(html, "href=\"#([^\"]*)\"")) {
    CHECK_MESSAGE(anchors.contains(target), target);
  }
  CHECK(anchors.contains("5.where"));
  CHECK(anchors.contains("findings"));
}

TEST_CASE("text is escaped for the page it stands on, nothing of a template remains") {
  const std::string html = page("index.html");
  const std::string tex = page("audit.tex");
  CHECK(mentions(html, "for x &lt; y &amp; y &gt; &quot;0&quot;."));
  CHECK(mentions(tex, "for x $<$ y \\& y $>$ ''0''."));
  CHECK(mentions(tex, "u\\_s is 100\\% of \\{F\\}"));
  CHECK(mentions(tex, "\\formula{\\omega-\\omega_1\\neq 0}"));
  CHECK_FALSE(mentions(html, "{{"));
  CHECK_FALSE(mentions(tex, "<<"));
  CHECK_FALSE(mentions(tex, ">>"));
}

TEST_CASE("two runs make the same pages") {
  const std::vector<File> first = pages(sample_audit());
  const std::vector<File> second = pages(sample_audit());
  REQUIRE(first.size() == 3);
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(first[i].content == second[i].content);
  }
}
