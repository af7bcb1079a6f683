#include "numeric/words/sweep.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>

#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::words {

using model::Matrix4;
using zeros::approximate_inverse;
using zeros::in_double;

namespace {

bool is_finite(const Matrix4<Ball>& A) {
  return std::all_of(A.data(), A.data() + A.size(), [](const Ball& entry) { return entry.is_finite(); });
}

// The product of the reflections I - 2 v vᵀ/(v v) that bring W to triangular form: exactly orthogonal,
// however the vectors v were found, so its inverse is its transpose. Its first k columns span what those of W
// do, as far as these span anything: a landing on the belt collapses a direction.
Matrix4<Ball> orthogonal(const Eigen::Matrix4d& W) {
  Matrix4<Ball> Q = Matrix4<Ball>::Identity();
  const Eigen::HouseholderQR<Eigen::Matrix4d> qr(W);
  if (!qr.matrixQR().allFinite()) {
    return Q;
  }
  for (int k = 2; k >= 0; --k) {
    std::array<Ball, 4> v;
    v[static_cast<std::size_t>(k)] = Ball(1);
    Ball square(1);
    for (int i = k + 1; i < 4; ++i) {
      v[static_cast<std::size_t>(i)] = Ball(qr.matrixQR()(i, k));
      add_product(square, v[static_cast<std::size_t>(i)], v[static_cast<std::size_t>(i)]);
    }
    for (int j = k; j < 4; ++j) {
      Ball part(0);
      for (int i = k; i < 4; ++i) {
        add_product(part, v[static_cast<std::size_t>(i)], Q(i, j));
      }
      part = Ball(2) * part / square;
      for (int i = k; i < 4; ++i) {
        subtract_product(Q(i, j), part, v[static_cast<std::size_t>(i)]);
      }
    }
  }
  return Q;
}

// The frames of all nodes. The second time round the first frame is where the first time ended, so that the
// return map, too, is nearly triangular, as far as its eigenvalues differ in size.
std::vector<Matrix4<Ball>> frames(const std::vector<Link>& links) {
  std::vector<Eigen::Matrix4d> M;
  for (const Link& link : links) {
    M.emplace_back(in_double(link.M));
  }
  Eigen::Matrix4d now = Eigen::Matrix4d::Identity();
  for (const Eigen::Matrix4d& factor : M) {
    now = Eigen::HouseholderQR<Eigen::Matrix4d>(factor * now).householderQ();
  }
  std::vector<Matrix4<Ball>> Q;
  for (const Eigen::Matrix4d& factor : M) {
    Q.push_back(orthogonal(now));
    now = factor * in_double(Q.back());
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
    const Matrix4<Ball> to = Q[(i + 1) % count].transpose();
    const Matrix4<Ball> R = to * Matrix4<Ball>(links[i].M * Q[i]);
    P.emplace_back(R * P[i]);
    h.emplace_back(R * h[i] + to * g[i]);
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
