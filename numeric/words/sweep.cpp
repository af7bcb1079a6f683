#include "numeric/words/sweep.hpp"

#include <algorithm>

#include "numeric/zeros/dense.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::words {

using zeros::in_double;
using zeros::product;
using Matrix = model::MatrixX<Ball>;

namespace {

bool is_finite(const Matrix& A) {
  return std::all_of(A.data(), A.data() + A.size(), [](const Ball& entry) { return entry.is_finite(); });
}

// The frames of all nodes. The second time round the first frame is where the first time ended, so that the
// return map, too, is nearly triangular, as far as its eigenvalues differ in size.
std::vector<Matrix> frames(const std::vector<Link>& links) {
  std::vector<Eigen::MatrixXd> M;
  for (const Link& link : links) {
    M.emplace_back(in_double(link.M));
  }
  const Eigen::Index n = links.front().M.rows();
  Eigen::MatrixXd now = Eigen::MatrixXd::Identity(n, n);
  for (const Eigen::MatrixXd& factor : M) {
    now = zeros::orthonormal(factor.lazyProduct(now));
  }
  std::vector<Matrix> Q;
  for (const Eigen::MatrixXd& factor : M) {
    Q.push_back(orthogonal(now));
    now = factor.lazyProduct(in_double(Q.back()));
  }
  return Q;
}

}  // namespace

// The product of the reflections I - 2 v vᵀ/(v v) that bring W to triangular form: exactly orthogonal,
// however the vectors v were found, so its inverse is its transpose.
Matrix orthogonal(const Eigen::MatrixXd& W) {
  const Eigen::Index n = W.rows();
  Matrix Q = Matrix::Identity(n, n);
  const Eigen::MatrixXd found = zeros::reflections(W);
  if (!found.allFinite()) {
    return Q;
  }
  model::VectorX<Ball> v(n);
  for (Eigen::Index k = n - 2; k >= 0; --k) {
    v(k) = Ball(1);
    Ball square(1);
    for (Eigen::Index i = k + 1; i < n; ++i) {
      v(i) = Ball(found(i, k));
      add_product(square, v(i), v(i));
    }
    for (Eigen::Index j = k; j < n; ++j) {
      Ball part(0);
      for (Eigen::Index i = k; i < n; ++i) {
        add_product(part, v(i), Q(i, j));
      }
      part = Ball(2) * part / square;
      for (Eigen::Index i = k; i < n; ++i) {
        subtract_product(Q(i, j), part, v(i));
      }
    }
  }
  return Q;
}

std::optional<Matrix> enclosed_inverse(const Matrix& A, const Matrix& Y) {
  const Eigen::Index n = A.rows();
  const Matrix E = Matrix(Matrix::Identity(n, n)) - Matrix(product(Y, A));
  const Ball norm = zeros::norm(E);
  const Ball room = Ball(1) - norm;
  if (!room.is_positive()) {
    return std::nullopt;
  }
  // (I - E)⁻¹ - I is at most |E|/(1 - |E|).
  const Ball excess = Ball(norm / room).upper();
  Matrix inverse = Y;
  for (Eigen::Index j = 0; j < n; ++j) {
    Ball column(0);
    for (Eigen::Index i = 0; i < n; ++i) {
      column += abs(Y(i, j));
    }
    const Ball spread = Ball(excess * column).upper();
    for (Eigen::Index i = 0; i < n; ++i) {
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
  const std::vector<Matrix> Q = frames(links);
  const Eigen::Index n = links.front().M.rows();
  // e_i = P_i e_0 + h_i.
  std::vector<Matrix> P{Matrix::Identity(n, n)};
  Nodes h{Node::Constant(n, Ball(0))};
  for (std::size_t i = 0; i < count; ++i) {
    const Matrix to = Q[(i + 1) % count].transpose();
    const Matrix R = product(to, Matrix(product(links[i].M, Q[i])));
    P.emplace_back(product(R, P[i]));
    h.emplace_back(product(R, h[i]) + product(to, g[i]));
  }
  const Matrix closing = Matrix(Matrix::Identity(n, n)) - P.back();
  const auto Y = is_finite(closing) ? zeros::row_combinations(closing) : std::nullopt;
  const auto inverse = Y ? enclosed_inverse(closing, *Y) : std::nullopt;
  if (!inverse) {
    return std::nullopt;
  }
  const Node first = product(*inverse, h.back());
  Sweep result{{}, P.back()};
  for (std::size_t i = 0; i < count; ++i) {
    result.deviations.emplace_back(product(Q[i], Node(product(P[i], first) + h[i])));
  }
  return result;
}

}  // namespace stickslip::numeric::words
