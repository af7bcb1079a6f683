#include "numeric/words/sweep.hpp"

#include <algorithm>

#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::words {

using model::Matrix4;
using zeros::approximate_inverse;

namespace {

Matrix4<Ball> midpoint(const Matrix4<Ball>& A) {
  return A.unaryExpr([](const Ball& entry) { return entry.midpoint(); });
}

bool is_finite(const Matrix4<Ball>& A) {
  return std::all_of(A.data(), A.data() + A.size(), [](const Ball& entry) { return entry.is_finite(); });
}

Ball dot(const Node& a, const Node& b) {
  Ball sum(0);
  for (int i = 0; i < 4; ++i) {
    add_product(sum, a(i), b(i));
  }
  return sum.midpoint();
}

// v without its parts along the first k columns of Q, twice for the sake of rounding.
Node remainder(const Matrix4<Ball>& Q, int k, Node v) {
  for (int pass = 0; pass < 2; ++pass) {
    for (int j = 0; j < k; ++j) {
      const Ball part = dot(Q.col(j), v);
      for (int i = 0; i < 4; ++i) {
        v(i) = Ball(v(i) - part * Q(i, j)).midpoint();
      }
    }
  }
  return v;
}

// The one of the four directions that differs most from the first k columns of Q.
Node another_direction(const Matrix4<Ball>& Q, int k) {
  Node best = Node::Constant(Ball(0));
  Ball largest(-1);
  for (int j = 0; j < 4; ++j) {
    const Node v = remainder(Q, k, Matrix4<Ball>(Matrix4<Ball>::Identity()).col(j));
    if (const Ball size = dot(v, v); (size - largest).is_positive()) {
      largest = size;
      best = v;
    }
  }
  return best;
}

// Nearly orthonormal columns, the first k of which span what the first k of W do, as far as these span
// anything: a landing on the belt collapses a direction.
Matrix4<Ball> orthonormal(const Matrix4<Ball>& W) {
  Matrix4<Ball> Q = Matrix4<Ball>::Constant(Ball(0));
  for (int k = 0; k < 4; ++k) {
    const Node column = W.col(k);
    Node v = remainder(Q, k, column);
    Ball negligible = dot(column, column);
    arb_mul_2exp_si(negligible.raw(), negligible.raw(), -WorkingPrecision::bits());
    if (!(dot(v, v) - negligible).is_positive()) {
      v = another_direction(Q, k);
    }
    const Ball length = Ball(sqrt(dot(v, v))).midpoint();
    for (int i = 0; i < 4; ++i) {
      Q(i, k) = Ball(v(i) / length).midpoint();
    }
  }
  return Q;
}

// The frames of all nodes. The second time round the first frame is where the first time ended, so that the
// return map, too, is nearly triangular, as far as its eigenvalues differ in size.
std::vector<Matrix4<Ball>> frames(const std::vector<Link>& links) {
  std::vector<Matrix4<Ball>> Q(links.size());
  Matrix4<Ball> now = Matrix4<Ball>::Identity();
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      Q[i] = now;
      now = orthonormal(midpoint(links[i].M) * now);
    }
  }
  return Q;
}

}  // namespace

std::optional<Matrix4<Ball>> enclosed_inverse(const Matrix4<Ball>& A, const Matrix4<Ball>& Y) {
  const Matrix4<Ball> E = Matrix4<Ball>(Matrix4<Ball>::Identity()) - Y * A;
  Ball norm(0);
  for (int i = 0; i < 4; ++i) {
    Ball sum(0);
    for (int j = 0; j < 4; ++j) {
      sum += abs(E(i, j));
    }
    arb_max(norm.raw(), norm.raw(), sum.raw(), WorkingPrecision::bits());
  }
  const Ball room = Ball(1) - norm;
  if (!room.is_positive()) {
    return std::nullopt;
  }
  // (I - E)⁻¹ - I is at most |E|/(1 - |E|).
  const Ball excess = Ball(norm / room).upper();
  Matrix4<Ball> inverse = Y;
  for (int j = 0; j < 4; ++j) {
    Ball column(0);
    for (int i = 0; i < 4; ++i) {
      column += abs(Y(i, j));
    }
    const Ball spread = Ball(excess * column).upper();
    for (int i = 0; i < 4; ++i) {
      inverse(i, j) += Ball::hull(-spread, spread);
    }
  }
  return inverse;
}

std::optional<Sweep> sweep(const std::vector<Link>& links, const Nodes& g) {
  const bool finite = std::all_of(links.begin(), links.end(), [](const Link& l) { return is_finite(l.M); });
  if (!finite) {
    return std::nullopt;
  }
  const std::size_t count = links.size();
  const std::vector<Matrix4<Ball>> Q = frames(links);
  // e_i = P_i e_0 + h_i.
  std::vector<Matrix4<Ball>> P{Matrix4<Ball>::Identity()};
  Nodes h{Node::Constant(Ball(0))};
  for (std::size_t i = 0; i < count; ++i) {
    const Matrix4<Ball>& to = Q[(i + 1) % count];
    const auto inverse = enclosed_inverse(to, to.transpose());
    if (!inverse) {
      return std::nullopt;
    }
    const Matrix4<Ball> R = *inverse * (links[i].M * Q[i]);
    P.emplace_back(R * P[i]);
    h.emplace_back(R * h[i] + *inverse * g[i]);
  }
  const Matrix4<Ball> closing = Matrix4<Ball>(Matrix4<Ball>::Identity()) - P.back();
  const auto Y = is_finite(closing) ? approximate_inverse<Ball, 4>(closing) : std::nullopt;
  const auto inverse = Y ? enclosed_inverse(closing, *Y) : std::nullopt;
  if (!inverse) {
    return std::nullopt;
  }
  const Node first = *inverse * h.back();
  Sweep result{{}, P.back()};
  for (std::size_t i = 0; i < count; ++i) {
    result.deviations.emplace_back(Q[i] * Node(P[i] * first + h[i]));
  }
  return result;
}

}  // namespace stickslip::numeric::words
