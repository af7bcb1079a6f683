#include "numeric/atlas/work.hpp"

#include <tbb/parallel_for_each.h>

#include <chrono>
#include <mutex>

#include "numeric/atlas/judge.hpp"

namespace stickslip::numeric::atlas {

namespace {

constexpr int boxes_of_block = 2000;
constexpr std::chrono::seconds longest_block{2};

}  // namespace

Block work_on(const Question& q, Tile tile, const std::function<bool()>& stop) {
  const auto until = std::chrono::steady_clock::now() + longest_block;
  Block block;
  block.rest.push_back(tile);
  for (int judged = 0;
       !block.rest.empty() && judged < boxes_of_block && std::chrono::steady_clock::now() < until && !stop();
       ++judged) {
    const Tile here = block.rest.back();
    block.rest.pop_back();
    const Finding finding = judge(q, here);
    const bool outside = finding.reason == static_cast<std::uint8_t>(Reason::outside);
    if (finding.is_decided() || outside || depth(here) == q.finest()) {
      block.leaves.push_back({here, finding});
    } else {
      block.rest.push_back(2 * here + 1);
      block.rest.push_back(2 * here);
    }
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
