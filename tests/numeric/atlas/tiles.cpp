// Boxes and their volumes, exactly; the log, and what becomes of it when a process is killed.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include <doctest/doctest.h>
#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/atlas/log.hpp"
#include "numeric/atlas/work.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/symmetric.hpp"
#include "tests/report/temporary.hpp"

namespace stickslip::numeric::atlas {
namespace {

namespace fs = std::filesystem;

Interval point(const char * x) {
  return {parse_rational(x), parse_rational(x)};
}
Interval range(const char * from, const char * to) {
  return {parse_rational(from), parse_rational(to)};
}

Question near_S(int resolution) {
  return {
      &families::symmetric(),
      {point("0.5"), point("3.8"), point("0.02"), point("1"), range("0.59", "0.61"), range("0.04", "0.06")},
      {4, 5},
      resolution};
}

// All leaves, by single blocks.
std::vector<Leaf> all_leaves(const Question& q) {
  std::vector<Leaf> leaves;
  work_on_all(
      q, {whole}, [] { return false; },
      [&](const std::vector<Leaf>& some) { leaves.insert(leaves.end(), some.begin(), some.end()); });
  put_in_order(q, leaves);
  return leaves;
}

TEST_CASE("The halves of a tile make the tile, in volume and along the line") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    Tile tile = whole;
    for (auto steps = random() % 59; steps > 0; --steps) {
      tile = 2 * tile + random() % 2;
    }
    CHECK(volume(2 * tile) + volume(2 * tile + 1) == volume(tile));
    CHECK(stretch(2 * tile).first == stretch(tile).first);
    CHECK(stretch(2 * tile).last == stretch(2 * tile + 1).first);
    CHECK(stretch(2 * tile + 1).last == stretch(tile).last);
    CHECK(tiles_of(stretch(tile)) == std::vector<Tile>{tile});
  }
}

TEST_CASE("The boxes of a tile's halves share a face, and nothing is lost in rationals") {
  const Question q = near_S(12);
  std::mt19937_64 random(2);
  for (int i = 0; i < 200; ++i) {
    Tile tile = whole;
    for (auto steps = random() % 24; steps > 0; --steps) {
      tile = 2 * tile + random() % 2;
    }
    const std::size_t cut = q.axes[static_cast<std::size_t>(depth(tile)) % 2];
    const Box box = box_of(q, tile);
    const Box low = box_of(q, 2 * tile);
    const Box high = box_of(q, 2 * tile + 1);
    for (std::size_t k = 0; k < box.size(); ++k) {
      CHECK(low[k].lower == box[k].lower);
      CHECK(high[k].upper == box[k].upper);
      CHECK((k == cut ? low[k].upper == high[k].lower : low[k].upper == box[k].upper));
    }
  }
}

TEST_CASE("Leaves cover the whole, once, and their volumes add up exactly") {
  const Question q = near_S(4);
  std::vector<Leaf> leaves = all_leaves(q);
  CHECK(gaps(leaves).empty());
  const Tally all = tally(q, leaves);
  CHECK(share(all.decided) + share(all.outside) + share(all.open) == 1);
  CHECK(all.coarser == 0);
  // Whatever is taken away is what is missing, box by box.
  std::mt19937_64 random(3);
  std::vector<Leaf> some;
  for (const Leaf& leaf : leaves) {
    if (random() % 3 != 0) {
      some.push_back(leaf);
    }
  }
  std::vector<Leaf> again = some;
  work_on_all(
      q, gaps(some), [] { return false; },
      [&](const std::vector<Leaf>& found) { again.insert(again.end(), found.begin(), found.end()); });
  put_in_order(q, again);
  CHECK(again == leaves);
  // A box twice is a box; two that contradict each other are an error, and so is one within another.
  std::vector<Leaf> twice = leaves;
  twice.push_back(leaves.front());
  put_in_order(q, twice);
  CHECK(twice == leaves);
  twice.back().finding.orbits = 77;
  twice.push_back(leaves.back());
  CHECK_THROWS_AS(put_in_order(q, twice), InputOutputError);
  std::vector<Leaf> nested{{2, {0, 0, 0, 0}}, {5, {0, 0, 0, 0}}};
  CHECK_THROWS_AS(put_in_order(q, nested), InputOutputError);
}

TEST_CASE("What stops the work loses nothing that was found") {
  const Question q = near_S(4);
  std::vector<Leaf> leaves;
  std::vector<Tile> open{whole};
  std::mt19937_64 random(4);
  for (int rounds = 0; !open.empty() && rounds < 100000; ++rounds) {
    auto left = static_cast<int>(random() % 20);
    const Block block = work_on(q, open.back(), [&left] { return left-- == 0; });
    open.pop_back();
    leaves.insert(leaves.end(), block.leaves.begin(), block.leaves.end());
    open.insert(open.end(), block.rest.begin(), block.rest.end());
  }
  put_in_order(q, leaves);
  CHECK(leaves == all_leaves(q));
}

TEST_CASE("A log gives back what was written, cut where it is torn or damaged") {
  const TemporaryDirectory directory;
  const fs::path log = directory / "a.log";
  const Question q = near_S(6);
  const std::string asked = identity(q, "1.0");
  create_log(log, asked);
  CHECK_THROWS_AS(create_log(log, asked), InputOutputError);
  const std::vector<Leaf> leaves{{4, {3, 2, 1, 0}}, {5, {-1, -1, -1, 6}}, {3, {0, 0, 0, 0}}};
  Log(log, 0, asked).append(leaves);
  CHECK(read_log(log, asked) == leaves);
  const fs::path file = log / "0.leaves";
  const auto size = fs::file_size(file);
  for (std::uintmax_t cut = 1; cut <= 16; ++cut) {
    fs::resize_file(file, size - cut);
    CHECK(read_log(log, asked) == std::vector<Leaf>(leaves.begin(), leaves.end() - 1));
    CHECK(fs::file_size(file) == size - 16);
    Log(log, 0, asked).append({leaves.back()});  // goes on behind the cut
    CHECK(read_log(log, asked) == leaves);
  }
  // One wrong bit in the second record: only the first counts.
  for (const int at : {16, 20, 24, 25, 26, 27, 28, 31}) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(at);
    const int byte = stream.get();
    stream.seekp(at);
    stream.put(static_cast<char>(byte ^ 1));
    stream.close();
    CHECK(read_log(log, asked) == std::vector<Leaf>(leaves.begin(), leaves.begin() + 1));
    Log(log, 0, asked).append({leaves[1], leaves[2]});
  }
  CHECK_THROWS_AS((void)read_log(log, identity(near_S(7), "1.0")), UsageError);
  CHECK_THROWS_AS((void)read_log(log, identity(q, "1.1")), UsageError);
  CHECK_THROWS_AS((void)read_log(directory / "none", asked), InputOutputError);
}

TEST_CASE("Questions that no atlas answers are refused") {
  Question q = near_S(12);
  require_understood(q);
  q.resolution = 31;
  CHECK_THROWS_AS(require_understood(q), UsageError);
  q = near_S(12);
  q.axes.clear();
  CHECK_THROWS_AS(require_understood(q), UsageError);
  q = near_S(12);
  q.family = &families::overshooting();
  CHECK_THROWS_AS(require_understood(q), UsageError);
  // Machines are ones all over the ranges.
  const auto machines = [](Interval m1, Interval belt, Interval at_rest) {
    const auto one = [](const Rational& x) { return Interval{x, x}; };
    return Question{&families::nonsticking(),
                    {m1, one(1), one(320), one(80), one(1), one(2), belt, one(1), one(1), at_rest},
                    {0},
                    12,
                    Values::coefficients};
  };
  require_understood(machines({3, 4}, {0, 1}, {3, 4}));
  CHECK_THROWS_AS(require_understood(machines({0, 4}, {0, 1}, {3, 4})), DomainError);
  CHECK_THROWS_AS(require_understood(machines({3, 4}, {-1, 1}, {3, 4})), DomainError);
  CHECK_THROWS_WITH_AS(require_understood(machines({3, 4}, {0, 1}, {2, 4})),
                       doctest::Contains("greater than friction_sliding = 2"), DomainError);
  // A family with a stick that no atlas knows is not judged by the equations of another.
  families::Family fourth;
  fourth.name = "fourth";
  fourth.phases = families::symmetric().phases;
  fourth.why_no_phi = "phi is a result";
  q = near_S(12);
  q.family = &fourth;
  CHECK_THROWS_WITH_AS(require_understood(q), "no atlas is made of fourth orbits", UsageError);
}

}  // namespace
}  // namespace stickslip::numeric::atlas
