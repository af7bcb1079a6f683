#include "core/parallel.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <type_traits>

using namespace stickslip;

TEST_CASE("the results come in order, at the caller's precision, whatever the number of threads") {
  const WorkingPrecision precision(300);
  for (const std::size_t threads : {1, 2, 100}) {
    const Jobs jobs(threads);
    const std::vector<long> bits = parallel_map(1000, [](std::size_t i) {
      const WorkingPrecision own(WorkingPrecision::bits() + 8);
      return WorkingPrecision::bits() + static_cast<long>(i);
    });
    for (std::size_t i = 0; i < bits.size(); ++i) {
      CHECK(bits[i] == 308 + static_cast<long>(i));
    }
    CHECK(WorkingPrecision::bits() == 300);
    CHECK(parallel_map(0, [](std::size_t) { return 1; }).empty());
  }
}

TEST_CASE("a piece of work that fails is heard of") {
  CHECK_THROWS_AS(
      (void)parallel_map(100, [](std::size_t i) { return i == 57 ? throw std::out_of_range("57") : i; }),
      std::out_of_range);
}

TEST_CASE("two threads write no two results into one byte") {
  const auto odd = parallel_map(1000, [](std::size_t i) { return i % 2 == 1; });
  static_assert(!std::is_same_v<decltype(odd), const std::vector<bool>>);
  for (std::size_t i = 0; i < odd.size(); ++i) {
    CHECK((odd[i] != 0) == (i % 2 == 1));
  }
}
