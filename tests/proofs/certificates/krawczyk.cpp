// Krawczyk's test as a certificate: accepted as it is, refused when what it rests on is changed.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <fstream>

#include "proofs/certificates/certificates.hpp"
#include "tests/cli/program.hpp"
#include "tests/proofs/certificates/coq.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using namespace stickslip::proofs;
using namespace stickslip::proofs::kernel;

namespace {

// x y = 1/4, (cos(x) - y - 1/2)/5 = 0, of which one derivative is a number that has no finite binary
// expansion.
methods::Claim claim(const Rational& about_x, const Rational& about_y) {
  const Variable X{"X", real_matrix(2, 1)};
  const Term x = entry(X, 0), y = entry(X, 1);
  const Rational radius(1, 1L << 30);
  const Theorem theorem = Theorem::one_zero(
      X,
      matrix(
          2, 1,
          {x * y - Rational(1, 4), Rational(1, 5) * kernel::cos(x) - Rational(1, 5) * y - Rational(1, 10)}),
      {{about_x - radius, about_x + radius}, {about_y - radius, about_y + radius}});
  return {.id = "zero", .words = "two equations have one solution", .prove = [theorem](auto&, const auto&) {
            methods::Outcome outcome;
            outcome.theorems = {theorem};
            outcome.by_kernel = true;
            outcome.verdict = Verdict::proved();
            return outcome;
          }};
}

// A solution in floating point.
std::pair<Rational, Rational> solution() {
  double x = 0.7;
  for (int step = 0; step < 50; ++step) {  // cos(x) - 1/(4 x) - 1/2 = 0
    x -= (std::cos(x) - 1 / (4 * x) - 0.5) / (-std::sin(x) + 1 / (4 * x * x));
  }
  return {Rational(x), Rational(1 / (4 * x))};
}

bool accepts(const std::filesystem::path& directory, const std::string& text) {
  std::ofstream(directory / "Claim_zero.v") << text;
  std::filesystem::remove(directory / "Claim_zero.vo");
  return run("/usr/bin/make", {"--silent", "--directory=" + directory.string()}).code == 0;
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("Coq accepts Krawczyk's test, and refuses it for another box, other equations, another matrix" *
          doctest::test_suite("nightly") * doctest::skip() * doctest::timeout(600)) {
  const auto [x, y] = solution();
  const certificates::Certificates all = certificates::certificates({claim(x, y)});
  const TemporaryDirectory temporary;
  write_certificates(temporary.path(), all);
  std::string text;
  for (const certificates::File& file : all.files) {
    text = file.name == "Claim_zero.v" ? file.text : text;
  }
  REQUIRE(text.find("zero_of_columns 2") != std::string::npos);
  CHECK(accepts(temporary.path(), text));
  // The equation that is stated is not the one that is tested, nor is the one that is read.
  CHECK_FALSE(accepts(temporary.path(), changed(text, "(-1) / 4", "(-1) / 5")));
  CHECK_FALSE(accepts(temporary.path(),
                      changed(text, "in functions_read t", "in functions_read (fun x y : R => t y x)")));
  // A box that is not the one stated; another radius than that of its sides.
  const std::size_t box = text.find("_b : list (Tree.expr * Tree.expr)"), side = text.find("((", box) + 2;
  REQUIRE(box != std::string::npos);
  CHECK_FALSE(accepts(temporary.path(), text.substr(0, side) + "1 + " + text.substr(side)));
  CHECK_FALSE(accepts(temporary.path(),
                      text.substr(0, box) + changed(text.substr(box), " / 1073741824)", " / 1073741825)")));
  // A matrix that is no inverse; slopes that are elsewhere.
  for (const std::string matrix : {"_Y", "_M"}) {
    const std::size_t at = text.find(matrix + " : list (list Z) := (((");
    REQUIRE(at != std::string::npos);
    CHECK_FALSE(
        accepts(temporary.path(), text.substr(0, at) + changed(text.substr(at), "(((", "(((1 + 2 * ")));
  }
}
