// The generic search on functions whose zeros are known.
#include "numeric/zeros/search.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <csignal>

using namespace stickslip;
using namespace stickslip::numeric::zeros;

namespace {

// sin(10 x): zeros k pi/10, the first at the very end of [0, 2].
struct Ripple {
  template <class T>
  Eigen::Matrix<T, 1, 1> operator()(const Eigen::Matrix<T, 1, 1>& x) const {
    using std::sin;
    return Eigen::Matrix<T, 1, 1>(T(sin(T(T(10) * x(0)))));
  }
};

// sin(10 x) and y - 1: one coordinate of a zero is known at once, as far as doubles go.
struct HalfKnown {
  template <class T>
  Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& v) const {
    using std::sin;
    return {T(sin(T(T(10) * v(0)))), T(v(1) - T(1))};
  }
};

// x² + y² = 1 and x = y: two zeros, one in each quadrant; (x - y)² = 0 instead makes both double.
struct Diagonal {
  bool doubled = false;
  template <class T>
  Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& v) const {
    const T d = v(0) - v(1);
    return {T(v(0) * v(0) + v(1) * v(1) - T(1)), doubled ? T(d * d) : d};
  }
};

template <int N, class F>
SearchResult<N> search_all(const F& f, const Cell<N>& domain, const SearchLimits& limits = {}) {
  return search<N>(
      domain, [&](const Box<N>& X) { return contract_by_krawczyk<N>(f, X); },
      [&](const Box<N>& X) { return decide_by_krawczyk<N>(f, X); }, limits);
}

}  // namespace

TEST_CASE("all zeros on a line, each once, ends included") {
  const SearchResult<1> result = search_all<1>(Ripple{}, {{0}, {2}});
  CHECK(result.complete());
  REQUIRE(result.zeros.size() == 7);
  for (int k = 0; k < 7; ++k) {
    const Ball exact = Ball(k) * Ball::pi() / Ball(10);
    CHECK(std::count_if(result.zeros.begin(), result.zeros.end(),
                        [&](const ZeroProof<1>& z) { return z.box(0).overlaps(exact); }) == 1);
  }
}

TEST_CASE("a zero on the face between cells is found once") {
  const SearchResult<2> result = search_all<2>(Diagonal{}, {{-1, -1}, {1, 1}});
  CHECK(result.complete());
  CHECK(result.zeros.size() == 2);
}

TEST_CASE("a zero is told from a multiple one where one of its coordinates can shrink no more") {
  const SearchResult<2> result = search_all<2>(HalfKnown{}, {{0.1, 0.3}, {2, 1.7}});
  CHECK(result.complete());
  CHECK(result.zeros.size() == 6);
}

TEST_CASE("double zeros stay unresolved, covered and with a reason") {
  const SearchResult<2> result = search_all<2>(Diagonal{true}, {{0, 0}, {1, 1}});
  CHECK(result.zeros.empty());
  REQUIRE_FALSE(result.complete());
  const Ball root = sqrt(Ball(2)) / Ball(2);
  CHECK(std::any_of(result.unresolved.begin(), result.unresolved.end(), [&](const UnresolvedBox<2>& open) {
    return open.box(0).contains(root) && open.box(1).contains(root) && !open.reason.empty();
  }));
}

namespace {

// Whether each zero of Ripple in [0, 2] lies in a proved box or in an unresolved one.
void check_that_nothing_is_lost(const SearchResult<1>& result) {
  for (int k = 0; k < 7; ++k) {
    const Ball exact = Ball(k) * Ball::pi() / Ball(10);
    const bool found = std::any_of(result.zeros.begin(), result.zeros.end(),
                                   [&](const ZeroProof<1>& z) { return z.box(0).overlaps(exact); });
    const bool open = std::any_of(result.unresolved.begin(), result.unresolved.end(),
                                  [&](const UnresolvedBox<1>& u) { return u.box(0).overlaps(exact); });
    CHECK((found || open));
  }
}

}  // namespace

TEST_CASE("a caller may say which side of a cell is halved, until it is small: then the longest one") {
  // The first coordinate alone tells whether a cell is empty.
  const auto contract = [](const Box<2>& X) {
    return X(0).contains(Ball(Rational(1, 3)).midpoint()) ? std::optional(X) : std::nullopt;
  };
  const auto decide = [](const Box<2>& X) { return ZeroProof<2>{Verdict::undecided("open"), X, X}; };
  const SearchLimits limits{0x1p-6, 100000};
  const Cell<2> domain{{0, 0}, {1, 1}};
  const SearchResult<2> by_longest = search<2>(domain, contract, decide, limits);
  const SearchResult<2> by_first =
      search<2>(domain, contract, decide, limits, [](const Cell<2>&) { return std::size_t{0}; });
  CHECK(by_first.cells < by_longest.cells);
  CHECK(by_first.cells > 128);  // the other side is halved, too
  for (const SearchResult<2>& result : {by_first, by_longest}) {
    REQUIRE(result.unresolved.size() == 1);
    const Box<2>& open = result.unresolved.front().box;
    CHECK((open(0).radius() - Ball(0x1p-7)).is_negative());
    CHECK(open(1).contains(Ball(0)));
    CHECK(open(1).contains(Ball(1)));
  }
}

TEST_CASE("the limit of cells loses nothing") {
  SearchLimits limits;
  limits.cells = 3;
  check_that_nothing_is_lost(search_all<1>(Ripple{}, {{0}, {2}}, limits));
}

TEST_CASE("a person's limits are taken in place of the search's own") {
  const long needed = search_all<1>(Ripple{}, {{0}, {2}}).cells;
  {
    const Effort little(3, {});
    const SearchResult<1> part = search_all<1>(Ripple{}, {{0}, {2}});
    CHECK(part.cells == 3);
    CHECK(part.unresolved.front().reason == "the search was stopped at its limit of cells");
    check_that_nothing_is_lost(part);
  }
  {
    const Effort no_time({}, 1e-9);
    const SearchResult<1> part = search_all<1>(Ripple{}, {{0}, {2}});
    CHECK(part.cells < needed);
    CHECK(part.unresolved.front().reason == "the search was stopped at its limit of time");
    check_that_nothing_is_lost(part);
  }
  {
    const Effort more({}, 1e300);
    SearchLimits limits;
    limits.cells = 3;
    CHECK(search_all<1>(Ripple{}, {{0}, {2}}, limits).complete());
  }
  SearchLimits limits;
  limits.cells = 3;
  CHECK_FALSE(search_all<1>(Ripple{}, {{0}, {2}}, limits).complete());
}

TEST_CASE("an interrupted search stops and loses nothing") {
  const SearchResult<1> whole = search_all<1>(Ripple{}, {{0}, {2}});
  SearchResult<1> part;
  {
    const Interruptible scope;
    std::atomic<int> asked = 0;  // by the threads that examine a batch
    const auto interrupted_contractor = [&](const Box<1>& X) {
      if (++asked == 4) {
        std::raise(SIGINT);
      }
      return contract_by_krawczyk<1>(Ripple{}, X);
    };
    part = search<1>({{0}, {2}}, interrupted_contractor,
                     [](const Box<1>& X) { return decide_by_krawczyk<1>(Ripple{}, X); });
    CHECK(asked >= 4);
    CHECK(asked < whole.cells);
  }
  CHECK_FALSE(interrupted());
  CHECK_FALSE(part.complete());
  CHECK(part.zeros.size() < whole.zeros.size());
  CHECK(part.unresolved.front().reason == "the search was interrupted");
  check_that_nothing_is_lost(part);
}
