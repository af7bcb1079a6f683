#include "numeric/branches/multiples.hpp"

#include <fmt/format.h>

#include <cmath>

#include "numeric/branches/setting.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::branches {

namespace {

constexpr double nearness = 0x1p-17;
constexpr int most_stretches = 1 << 14;

class Finder {
 public:
  explicit Finder(const BranchQuestion& question)
      : question_(question), curve_(curve_of(question, families::NonstickingClosing{})) {}

  std::vector<Multiple> run() {
    look(question_.from, question_.to);
    if (looks_ > most_stretches ||
        (found_.size() == 1 && found_[0].from == question_.from && found_[0].to == question_.to)) {
      return {};
    }
    std::vector<Multiple> all;
    for (const Near& one : found_) {
      all.push_back({fmt::format("{} omega = omega{}", one.k, one.mode + 1), one.from, one.to, zero(one)});
    }
    return all;
  }

 private:
  struct Near {
    Rational from, to;
    int mode;
    double k;
  };

  // omega_j/omega, j = 1, 2.
  [[nodiscard]] std::array<Ball, 2> ratios(const Ball& value) const {
    const zeros::Vector p = curve_.data_at(value);
    const model::Modes<Ball> m = model::modes<Ball>(p(0), p(1));
    return {m.omega1 / p(4), m.omega2 / p(4)};
  }

  // Adds what is near in these parts of the interval, from the left to the right.
  void look(const Rational& from, const Rational& to) {
    if (++looks_ > most_stretches) {
      return;
    }
    const std::array<Ball, 2> ratio = ratios(between(from, to));
    bool is_free = true;
    for (int mode = 0; mode < 2; ++mode) {
      const auto [low, high] = scalars::ends(ratio[static_cast<std::size_t>(mode)]);
      const double k = std::max(2.0, std::ceil(low / (1 + nearness)));
      if (k <= high / (1 - nearness)) {
        if (high - low < k * nearness / 2) {
          return add({from, to, mode, k});
        }
        is_free = false;
      }
    }
    if (!is_free) {
      const Rational middle = (from + to) / 2;
      look(from, middle);
      look(middle, to);
    }
  }

  void add(const Near& one) {
    if (!found_.empty() && found_.back().to == one.from && found_.back().mode == one.mode &&
        found_.back().k == one.k) {
      found_.back().to = one.to;
    } else {
      found_.push_back(one);
    }
  }

  // Bisected as far as the signs are known.
  [[nodiscard]] std::optional<Ball> zero(const Near& one) const {
    const auto sign = [&](const Rational& value) {
      const Ball over = ratios(Ball(value))[static_cast<std::size_t>(one.mode)] - Ball(one.k);
      return over.is_positive() ? 1 : over.is_negative() ? -1 : 0;
    };
    Rational from = one.from, to = one.to;
    const int first = sign(from);
    if (first * sign(to) >= 0) {
      return std::nullopt;
    }
    while (!(Ball(Rational(to - from)) - Ball(resolution / 64)).is_negative()) {
      const Rational middle = (from + to) / 2;
      const int here = sign(middle);
      if (here == 0) {
        break;
      }
      (here == first ? from : to) = middle;
    }
    return between(from, to);
  }

  const BranchQuestion& question_;
  Curve curve_;
  int looks_ = 0;
  std::vector<Near> found_;
};

}  // namespace

std::vector<Multiple> multiples_in(const BranchQuestion& question) {
  return question.word || question.orbits.family != &families::nonsticking() ? std::vector<Multiple>{}
                                                                             : Finder(question).run();
}

UnresolvedPart left_out(const Multiple& multiple, const std::string& parameter) {
  UnresolvedPart part{between(multiple.from, multiple.to), {}, "", true};
  if (multiple.at) {
    part.where = {{parameter, *multiple.at}};
    part.reason = fmt::format("the resonance {}: not looked into next to it", multiple.name);
  } else {
    part.reason = fmt::format("next to the resonance {}: not looked into", multiple.name);
  }
  return part;
}

}  // namespace stickslip::numeric::branches
