#include "numeric/atlas/work.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "numeric/atlas/judge.hpp"

namespace stickslip::numeric::atlas {

void put_in_order(const Question& q, std::vector<Leaf>& leaves) {
  for (const Leaf& leaf : leaves) {
    if (leaf.tile == 0 || depth(leaf.tile) > q.finest()) {
      throw InputOutputError(fmt::format("box {} is none of this atlas", leaf.tile));
    }
  }
  std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
    const std::uint64_t x = stretch(a.tile).first;
    const std::uint64_t y = stretch(b.tile).first;
    return x != y ? x < y : a.tile < b.tile;
  });
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  for (std::size_t i = 1; i < leaves.size(); ++i) {
    if (stretch(leaves[i].tile).first < stretch(leaves[i - 1].tile).last) {
      throw InputOutputError(fmt::format("boxes {} and {} overlap, or contradict each other",
                                         leaves[i - 1].tile, leaves[i].tile));
    }
  }
}

std::vector<Tile> gaps(const std::vector<Leaf>& leaves) {
  std::vector<Tile> result;
  std::uint64_t covered = 0;
  const auto fill = [&](std::uint64_t until) {
    for (const Tile tile : tiles_of({covered, until})) {
      result.push_back(tile);
    }
  };
  for (const Leaf& leaf : leaves) {
    fill(stretch(leaf.tile).first);
    covered = stretch(leaf.tile).last;
  }
  fill(volume(whole));
  return result;
}

Rational share(std::uint64_t volume) {
  Rational result(static_cast<unsigned long>(volume));
  mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), most_depth);
  return result;
}

Tally tally(const Question& q, const std::vector<Leaf>& leaves) {
  Tally all;
  all.leaves = leaves.size();
  for (const Leaf& leaf : leaves) {
    const std::uint64_t v = volume(leaf.tile);
    const Finding& f = leaf.finding;
    all.orbits_known += f.orbits >= 0 ? v : 0;
    all.admissible_known += f.admissible >= 0 ? v : 0;
    if (f.is_decided()) {
      all.decided += v;
      all.counts[{f.orbits, f.admissible, f.stable}] += v;
      continue;
    }
    (f.reason == static_cast<std::uint8_t>(Reason::outside) ? all.outside : all.open) += v;
    all.coarser += depth(leaf.tile) < q.finest() ? v : 0;
    all.reasons[f.reason] += v;
  }
  return all;
}

namespace {

constexpr int boxes_of_block = 2000;
constexpr std::chrono::seconds longest_block{2};
constexpr int small = 8;  // halvings: what is known around a rest must be found again, so none is smaller

}  // namespace

Block work_on(const Question& q, Tile tile, const std::function<bool()>& stop) {
  const auto until = std::chrono::steady_clock::now() + longest_block;
  struct Task {
    Tile tile;
    Knowledge known;  // of the box that it is a half of
  };
  std::vector<Task> tasks;
  tasks.push_back({tile, known_around(q, tile, Balls::both)});
  Block block;
  const auto is_over = [&](int judged) {
    return (judged >= boxes_of_block || std::chrono::steady_clock::now() >= until) &&
           depth(tasks.back().tile) <= q.finest() - small;
  };
  for (int judged = 0; !tasks.empty() && !is_over(judged) && !stop(); ++judged) {
    auto [here, known] = std::move(tasks.back());
    tasks.pop_back();
    if (depth(here) == q.finest()) {
      block.leaves.push_back({here, judge_finest(q, here, Balls::both, std::move(known))});
      continue;
    }
    const Finding finding = judge(q, here, Balls::both, known);
    if (finding.is_decided() || finding.reason == static_cast<std::uint8_t>(Reason::outside)) {
      block.leaves.push_back({here, finding});
    } else {
      tasks.push_back({2 * here + 1, known});
      tasks.push_back({2 * here, std::move(known)});
    }
  }
  for (const Task& task : tasks) {
    block.rest.push_back(task.tile);
  }
  return block;
}

void work_on_all(const Question& q, const std::vector<Tile>& tiles, const std::function<bool()>& stop,
                 const std::function<void(const std::vector<Leaf>&)>& done) {
  std::mutex one_at_a_time;
  tbb::parallel_for_each(tiles.begin(), tiles.end(), [&](Tile tile, tbb::feeder<Tile>& feeder) {
    give_numbers_back_at_end();
    if (stop()) {
      return;
    }
    const Block block = work_on(q, tile, stop);
    {
      const std::lock_guard hold(one_at_a_time);
      done(block.leaves);
    }
    for (const Tile rest : block.rest) {
      feeder.add(rest);
    }
  });
}

}  // namespace stickslip::numeric::atlas
