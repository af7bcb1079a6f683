#include "proofs/kernel/balls.hpp"

namespace stickslip::proofs::kernel {
namespace {

// A square matrix, row by row.
struct Square {
  std::size_t rows;
  std::vector<Ball> entries = std::vector<Ball>(rows * rows, Ball(0));
  [[nodiscard]] Ball& operator()(std::size_t i, std::size_t j) { return entries[i * rows + j]; }
  [[nodiscard]] const Ball& operator()(std::size_t i, std::size_t j) const { return entries[i * rows + j]; }
};

// Nearly the inverse, by Gauss and Jordan with the midpoints: exact numbers, of which nothing is taken for
// granted.
Square nearly_inverse(Square a) {
  std::transform(a.entries.begin(), a.entries.end(), a.entries.begin(),
                 [](const Ball& entry) { return entry.midpoint(); });
  Square inverse{a.rows};
  for (std::size_t k = 0; k < a.rows; ++k) {
    inverse(k, k) = Ball(1);
  }
  const auto in_both = [&](const auto& change) {
    for (Square * m : {&a, &inverse}) {
      for (std::size_t j = 0; j < a.rows; ++j) {
        change(*m, j);
      }
    }
  };
  const auto size = [&a](std::size_t i, std::size_t k) { return std::abs(a(i, k).approximate()); };
  for (std::size_t k = 0; k < a.rows; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < a.rows; ++i) {
      pivot = size(i, k) > size(pivot, k) ? i : pivot;
    }
    in_both([&](Square& m, std::size_t j) { std::swap(m(k, j), m(pivot, j)); });
    const Ball scale = (Ball(1) / a(k, k)).midpoint();
    in_both([&](Square& m, std::size_t j) { m(k, j) = (m(k, j) * scale).midpoint(); });
    for (std::size_t i = 0; i < a.rows; ++i) {
      const Ball factor = i == k ? Ball(0) : a(i, k);
      in_both([&](Square& m, std::size_t j) { m(i, j) = (m(i, j) - factor * m(k, j)).midpoint(); });
    }
  }
  return inverse;
}

// Krawczyk's K = m - Y f(m) + (I - Y f'(box)) (box - m), m in the middle, Y any matrix: if it lies inside the
// box, the box holds exactly one zero of f.
std::vector<Ball> krawczyk_image(const Variable& X, const Term& f, const Box& box) {
  const std::size_t n = box.size();
  std::vector<Variable> x;
  std::vector<Term> avoid{f}, entries;
  Balls::Values over_box, in_middle;
  std::vector<Ball> rest, image;  // box - m; m, and then K
  for (const Interval& interval : box) {
    x.push_back(fresh(real_number, avoid));
    avoid.emplace_back(x.back());
    entries.emplace_back(x.back());
    const Ball side = ball(interval), middle = side.midpoint();
    over_box[x.back()] = {side};
    in_middle[x.back()] = {middle};
    rest.push_back(side - middle);
    image.push_back(middle);
  }
  const Term system = substitute(f, {{X, matrix(X.type.rows, 1, entries)}});
  InBalls values({over_box});
  static_cast<void>(values(system));  // no divisor may be zero anywhere in the box
  Square slope{n};
  for (std::size_t j = 0; j < n; ++j) {
    const std::vector<Ball> column = values(partial_derivative(system, x[j]));
    for (std::size_t i = 0; i < n; ++i) {
      slope(i, j) = column[i];
    }
  }
  const Square Y = nearly_inverse(slope);
  const std::vector<Ball> at_middle = InBalls({in_middle})(system);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      Ball left(i == j ? 1 : 0);
      for (std::size_t k = 0; k < n; ++k) {
        left -= Y(i, k) * slope(k, j);
      }
      image[i] += left * rest[j] - Y(i, j) * at_middle[j];
    }
  }
  return image;
}

bool lies_inside(const Ball& ball, const Interval& side) {
  return ball.is_finite() && (ball - Ball(side.first.value())).is_positive() &&
         (Ball(side.second.value()) - ball).is_positive();
}

}  // namespace

Formula inside(const Term& x, const Box& box) {
  std::vector<Formula> parts;
  for (std::size_t i = 0; i < box.size(); ++i) {
    parts.push_back(within(box[i].first, entry(x, static_cast<int>(i)), box[i].second));
  }
  return all(parts);
}

Formula exactly_one(const Variable& x, const Box& box, const Formula& a) {
  const Variable y = fresh(x.type, {x, a});
  const Formula here = all({inside(x, box), a});
  const Formula there = substitute(here, {{x, y}});
  return all({exists(x, here), for_all(x, for_all(y, implies(all({here, there}), equal(x, y))))});
}

Theorem Theorem::one_zero(const Variable& X, const Term& f, const Box& box, long bits) {
  require(X.type == real_matrix(static_cast<int>(box.size()), 1),
          "a box has as many sides as the column entries");
  require(f.is_closed() && f.type() == X.type, "a system has as many equations as unknowns");
  require(std::all_of(f.variables().begin(), f.variables().end(), [&](const Variable& v) { return v == X; }),
          "a system has no variable but its unknown");
  require_precision(bits);
  const WorkingPrecision scope(bits);
  const std::vector<Ball> image = krawczyk_image(X, f, box);
  require(std::equal(image.begin(), image.end(), box.begin(), lies_inside),
          "Krawczyk's test does not prove that the box holds exactly one zero");
  Step step{.rule = "one_zero", .data = {X, f, bits}};
  for (const Interval& side : box) {
    step.data.insert(step.data.end(), {side.first, side.second});
  }
  return {step, exactly_one(X, box, equal(f, zero(X.type)))};
}

}  // namespace stickslip::proofs::kernel
