#include "numeric/machines/basins/set_after.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <cmath>

#include "core/domain.hpp"
#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/words/word.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

namespace {

constexpr long bits_of_sets = 128;

struct Followed {
  SetAfter::Part part;
  Verdict verdict;
  Eigen::Index side = 0;  // that is best halved
};

Followed followed(const SetFlow& flow, const SetAfterQuestion& q, SetAfter::Part part) {
  std::vector<Eigen::Index> axes;
  for (Eigen::Index k = 0; k < part.half.size(); ++k) {
    if (part.half(k) > 0) {
      axes.push_back(k);
    }
  }
  Matrix S = Matrix::Constant(part.half.size(), static_cast<Eigen::Index>(axes.size()), Ball(0));
  Followed result{part, {}, 0};
  double longest = -1;
  for (std::size_t l = 0; l < axes.size(); ++l) {
    // Middles are rounded: a little more, so that no start between two parts is missed.
    S(axes[l], static_cast<Eigen::Index>(l)) =
        Ball(part.half(axes[l]) + 0x1p-50 * (std::abs(part.middle(axes[l])) + part.half(axes[l])));
    const double length = part.half(axes[l]) / q.half(axes[l]);
    if (length > longest) {
      longest = length;
      result.side = axes[l];
    }
  }
  // The load has the phase theta at time 0.
  const Ball begin =
      q.machine.oscillator.is_autonomous() ? Ball(0) : Ball(q.theta) / flow.phases().oscillator().omega;
  SetOfMotions set = set_at(begin, {}, part.middle.cast<Ball>(), S, false);
  const auto piece = flow.piece_of(set.all.value.tail(part.middle.size()), begin);
  if (!piece) {
    // The velocity of the mass on the belt tells them apart.
    const Eigen::Index speed = flow.phases().speed_row();
    result.side = part.half(speed) > 0 ? speed : result.side;
    result.verdict = Verdict::undecided(
        "some starts move as the belt does, or as a piece of the law ends, and others do not");
    return result;
  }
  set.piece = *piece;
  result.verdict = flow.follow(set, begin + Ball(q.time));
  result.part.pieces.push_back(*piece);
  result.part.pieces.insert(result.part.pieces.end(), set.passed.begin(), set.passed.end());
  result.part.states = set.all.value.tail(part.middle.size());
  double most = 0;
  for (std::size_t l = 0; l < set.all.second.size(); ++l) {
    const double change = zeros::in_double(set.all.derivative_of_first(l)).norm();
    if (result.verdict.truth != Truth::proved && change > most &&
        part.half(axes[l]) > longest / 16 * q.half(axes[l])) {
      most = change;
      result.side = axes[l];
    }
  }
  return result;
}

}  // namespace

std::string SetAfter::Part::phases() const {
  std::string letters;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == 0 || pieces[i].kind != pieces[i - 1].kind) {
      letters += words::letter(pieces[i].kind);
    }
  }
  return letters;
}

double SetAfter::share(const Part& part) const {
  double share = 1;
  for (Eigen::Index k = 0; k < part.half.size(); ++k) {
    share *= question.half(k) > 0 ? part.half(k) / question.half(k) : 1;
  }
  return share;
}

double SetAfter::proved() const {
  double sum = 0;
  for (const Part& part : parts) {
    sum += share(part);
  }
  return sum;
}

Vector SetAfter::hull() const {
  Vector all = parts.empty() ? Vector() : parts.front().states;
  for (const Part& part : parts) {
    for (Eigen::Index k = 0; k < all.size(); ++k) {
      all(k) = Ball::hull(all(k), part.states(k));
    }
  }
  return all;
}

SetAfter set_after(const SetAfterQuestion& q) {
  require_machine(q.machine);
  const auto states = static_cast<Eigen::Index>(2 * q.machine.oscillator.size());
  require(q.middle.size() == states && q.half.size() == states, "the box of starts",
          fmt::format("{} and {} numbers", q.middle.size(), q.half.size()),
          fmt::format("{} each, positions and velocities", states));
  require(q.half.minCoeff() >= 0 && q.half.maxCoeff() > 0, "a half width of the box of starts",
          q.half.minCoeff(), "0 or more, and one above");
  require(q.time > 0 && std::isfinite(q.time), "the time", q.time, "above 0");
  const WorkingPrecision scope(bits_of_sets);
  SetAfter result{q, {}, {}, false};
  tbb::enumerable_thread_specific<SetFlow> flows([&] { return SetFlow(q.machine); });
  std::vector<SetAfter::Part> open{{q.middle, q.half, {}, {}}};
  long tried = 0;
  while (!open.empty()) {
    const bool last = tried + 2 * static_cast<long>(open.size()) > q.most_parts || interrupted();
    tried += static_cast<long>(open.size());
    const auto all =
        parallel_map(open.size(), [&](std::size_t i) { return followed(flows.local(), q, open[i]); });
    std::vector<SetAfter::Part> next;
    for (const Followed& one : all) {
      if (one.verdict.truth == Truth::proved) {
        result.parts.push_back(one.part);
      } else if (last) {
        result.open[one.verdict.reason.substr(0, one.verdict.reason.find(": "))] += result.share(one.part);
      } else {
        for (const int sign : {-1, 1}) {
          next.push_back({one.part.middle, one.part.half, {}, {}});
          next.back().half(one.side) /= 2;
          next.back().middle(one.side) += sign * next.back().half(one.side);
        }
      }
    }
    open = next;
  }
  result.interrupted = interrupted();
  return result;
}

}  // namespace stickslip::numeric::machines
