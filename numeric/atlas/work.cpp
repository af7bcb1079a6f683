#include "numeric/atlas/work.hpp"

#include <tbb/parallel_for_each.h>

#include <chrono>
#include <mutex>

#include "numeric/atlas/judge.hpp"

namespace stickslip::numeric::atlas {

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
    const bool finest = depth(here) == q.finest();
    const Finding finding =
        finest ? judge_finest(q, here, Balls::both, std::move(known)) : judge(q, here, Balls::both, known);
    const bool outside = finding.reason == static_cast<std::uint8_t>(Reason::outside);
    if (finding.is_decided() || outside || finest) {
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
