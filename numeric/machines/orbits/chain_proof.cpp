#include "numeric/machines/orbits/chain_proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>

#include "numeric/zeros/krawczyk.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using zeros::in_double;
using zeros::product;

namespace {

bool is_finite(const Matrix& A) {
  return std::all_of(A.data(), A.data() + A.size(), [](const Ball& entry) { return entry.is_finite(); });
}
bool is_finite(const InData<Matrix>& A) {
  return is_finite(A.rest) &&
         std::ranges::all_of(A.c, [](const Matrix& coefficient) { return is_finite(coefficient); });
}

// The frames of all nodes. The second time round the first frame is where the first time ended, so that the
// return map, too, is nearly triangular, as far as its eigenvalues differ in size.
std::vector<Matrix> frames(const std::vector<Link>& links) {
  std::vector<Eigen::MatrixXd> M;
  for (const Link& link : links) {
    M.emplace_back(in_double(link.M.c[0]));
  }
  const Eigen::Index n = M.front().rows();
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
    const Ball twice = Ball(2) / square;
    for (Eigen::Index j = k; j < n; ++j) {
      Ball part(0);
      for (Eigen::Index i = k; i < n; ++i) {
        add_product(part, v(i), Q(i, j));
      }
      part *= twice;
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
    const Ball spread = scalars::within(excess * column);
    for (Eigen::Index i = 0; i < n; ++i) {
      inverse(i, j) += spread;
    }
  }
  return inverse;
}

namespace {

// Solves C x = v, C = 1 - P: with Y near the inverse, where C is linear, and |1 - Y C| = e < 1 the solutions
// are within e/(1 - e) |Y v| of Y v. That Y, of all, and e/(1 - e).
std::optional<std::pair<Matrix, Ball>> solver(const InData<Matrix>& P) {
  const Matrix one = Matrix::Identity(P.c[0].rows(), P.c[0].rows());
  const Matrix C = one - P.c[0];
  const auto inverse = is_finite(P) ? zeros::row_combinations(C) : std::nullopt;
  if (!inverse) {
    return std::nullopt;
  }
  InData<Matrix> Y(*inverse);
  Y.c.resize(P.c.size());
  for (std::size_t i = 1; i < P.c.size(); ++i) {
    if (monomial(i).degree() == 1 && !is_none(P.c[i])) {
      Y.c[i] = zeros::midpoints(product(*inverse, Matrix(product(P.c[i], *inverse))));
    }
  }
  InData<Matrix> E = Y * P;
  E += Y * Ball(-1);
  E += InData<Matrix>(one);
  const Ball e = zeros::norm(E.all()), room = Ball(1) - e;
  if (!room.is_positive()) {
    return std::nullopt;
  }
  return std::pair(Y.all(), Ball(e / room));
}

// Powers of two, as exponents, in which the links are balanced.
std::vector<long> units_of(const std::vector<Link>& links) {
  Eigen::MatrixXd sizes = in_double(links.front().M.c[0]).cwiseAbs();
  for (std::size_t i = 1; i < links.size(); ++i) {
    sizes += in_double(links[i].M.c[0]).cwiseAbs();
  }
  std::vector<long> exponents;
  for (const Ball& unit : balance(sizes.unaryExpr([](double x) { return Ball(x); }))) {
    exponents.push_back(std::lround(std::log2(unit.approximate())));
  }
  return exponents;
}

void scale(Ball& x, long exponent) {
  arb_mul_2exp_si(x.raw(), x.raw(), exponent);
}

// S M S⁻¹.
void scale(Matrix& M, const std::vector<long>& units) {
  for (Eigen::Index k = 0; k < M.cols(); ++k) {
    for (Eigen::Index i = 0; i < M.rows(); ++i) {
      scale(M(i, k), units[static_cast<std::size_t>(i)] - units[static_cast<std::size_t>(k)]);
    }
  }
}

// S d, or its inverse.
Node scaled(Node d, const std::vector<long>& units, long sign) {
  for (Eigen::Index i = 0; i < d.size(); ++i) {
    scale(d(i), sign * units[static_cast<std::size_t>(i)]);
  }
  return d;
}

}  // namespace

std::optional<LinearChain> LinearChain::of(std::vector<Link> links) {
  const bool finite =
      std::all_of(links.begin(), links.end(), [](const Link& link) { return is_finite(link.M); });
  if (!finite) {
    return std::nullopt;
  }
  LinearChain chain;
  chain.units_ = units_of(links);
  for (Link& link : links) {
    for (Matrix& coefficient : link.M.c) {
      scale(coefficient, chain.units_);
    }
    scale(link.M.rest, chain.units_);
  }
  const std::size_t count = links.size();
  chain.Q_ = frames(links);
  InData<Matrix> P(Matrix::Identity(chain.Q_.front().rows(), chain.Q_.front().rows()));
  chain.P_.push_back(P.all());
  for (std::size_t i = 0; i < count; ++i) {
    const Matrix to = chain.Q_[(i + 1) % count].transpose();
    const InData<Matrix> R =
        mapped(links[i].M, [&](const Matrix& M) { return Matrix(product(to, product(M, chain.Q_[i]))); });
    P = R * P;
    chain.R_.push_back(R.all());
    chain.P_.push_back(P.all());
  }
  const auto solving = solver(P);
  if (!solving) {
    return std::nullopt;
  }
  std::tie(chain.inverse_, chain.share_) = *solving;
  return chain;
}

Nodes LinearChain::deviations(const Nodes& g) const {
  const std::size_t count = R_.size();
  Nodes h{Node::Constant(inverse_.rows(), Ball(0))};
  for (std::size_t i = 0; i < count; ++i) {
    const Matrix to = Q_[(i + 1) % count].transpose();
    h.emplace_back(product(R_[i], h[i]) + product(to, scaled(g[i], units_, 1)));
  }
  Node first = product(inverse_, h.back());
  Ball largest(0);
  for (const Ball& entry : first) {
    arb_max(largest.raw(), largest.raw(), abs(entry).upper().raw(), WorkingPrecision::bits());
  }
  const Ball off = scalars::within(largest * share_);
  for (Ball& entry : first) {
    entry += off;
  }
  Nodes deviations;
  for (std::size_t i = 0; i < count; ++i) {
    const Node deviation = product(Q_[i], Node(product(P_[i], first) + h[i]));
    deviations.emplace_back(scaled(deviation, units_, -1));
  }
  return deviations;
}

namespace {

constexpr long fewest_bits = 128;
// From where on Newton's method does not come back, as a power of two: states of a motion in units of its
// own lengths.
constexpr long far_away = 20;

ChainProof open(const char * reason) {
  return {Verdict::undecided(reason), 0, {}, {}, {}};
}

template <class All>
std::vector<Link> links_of(const Chain& chain, const All& nodes) {
  std::vector<Link> links;
  links.reserve(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    links.push_back(chain.link(nodes, i));
  }
  return links;
}

Nodes responses(const std::vector<Link>& links, const Nodes& conditions) {
  Nodes g;
  for (std::size_t i = 0; i < links.size(); ++i) {
    g.push_back(links[i].response(conditions[i]));
  }
  return g;
}

Nodes conditions_of(const std::vector<Link>& links) {
  Nodes F;
  std::ranges::transform(links, std::back_inserter(F), &Link::conditions);
  return F;
}

Nodes conditions_of(const Chain& chain, const Nodes& nodes) {
  Nodes F;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    F.push_back(chain.conditions(nodes, i));
  }
  return F;
}

// 2^result is not less than any component.
long exponent(const Nodes& deviations) {
  long largest = -1000000000L;
  for (const Node& d : deviations) {
    for (Eigen::Index i = 0; i < d.size(); ++i) {
      const Ball size = abs(d(i)).upper();
      if (!size.is_finite()) {
        return far_away + 1;
      }
      if (size.is_positive()) {
        largest = std::max(largest, fmpz_get_si(ARF_EXPREF(arb_midref(size.raw()))));
      }
    }
  }
  return largest;
}

// The chain at the working precision of the moment, made once as long as that stays: it may keep what it
// has computed.
class Chains {
 public:
  explicit Chains(const MachineQuestion& question) : question_(question) {}

  [[nodiscard]] const Chain& now() {
    if (bits_ != WorkingPrecision::bits()) {
      chain_.emplace(question_);
      bits_ = WorkingPrecision::bits();
    }
    return *chain_;
  }

 private:
  const MachineQuestion& question_;
  long bits_ = 0;
  std::optional<Chain> chain_;
};

// Where Newton's method led.
struct Approach {
  std::optional<Nodes> nodes;
  bool astray = false;  // more bits would not help
};

// In floats, from as many bits as a guess deserves up to `bits`. The links of a step serve the ones after it
// at the same precision once they are near enough.
Approach approximate(Chains& chains, Nodes nodes, long bits) {
  constexpr int most_steps = 12;     // at one precision
  constexpr long near_enough = -20;  // of steps, as a power of two
  long precision = std::min(fewest_bits, bits);
  long before = far_away;
  std::vector<Link> links;
  std::optional<LinearChain> linear;
  long gain = 0;  // of a step over the one before, as a power of two: the step where the links are
  for (int k = 0; k < most_steps; ++k) {
    const WorkingPrecision scope(precision);
    const Chain& chain = chains.now();
    const bool fresh = gain > near_enough;
    if (fresh) {
      links = links_of(chain, nodes);
      linear = LinearChain::of(links);
    }
    if (!linear) {
      return {};
    }
    const Nodes F = fresh ? conditions_of(links) : conditions_of(chain, nodes);
    const Nodes step = linear->deviations(midpoints(responses(links, F)));
    const long size = exponent(step);
    if (size > far_away) {
      return {{}, true};
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes[i] = zeros::midpoints(nodes[i] + step[i]);
    }
    gain = fresh ? size : gain;
    // The step after this one is as much smaller, or as small as rounding allows.
    if (-(size + gain) > precision || (size >= before && -size > precision / 4)) {
      if (precision == bits) {
        return {nodes};
      }
      precision = std::min(2 * precision, bits);
      gain = 0;
      k = 0;
    }
    before = size;
  }
  return {{}, true};
}

// The boxes around the nodes with the radius 2^exponent in units of each component, max(1, |middle|).
Nodes boxes(const Nodes& nodes, long exponent) {
  Nodes X = nodes;
  for (Node& u : X) {
    for (Eigen::Index j = 0; j < u.size(); ++j) {
      Ball r = (abs(u(j)) + Ball(1)).upper();
      arb_mul_2exp_si(r.raw(), r.raw(), exponent);
      u(j) += Ball::hull(-r, r);
    }
  }
  return X;
}

bool is_inside(const Nodes& nodes, const Nodes& room) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!zeros::is_interior<Eigen::Dynamic>(nodes[i], room[i])) {
      return false;
    }
  }
  return true;
}

ChainProof test(const Chain& chain, const Nodes& m, long exponent) {
  const Nodes X = boxes(m, exponent);
  const std::vector<Link> links = links_of(chain, X);
  const auto linear = LinearChain::of(links);
  if (!linear) {
    return open("an event of the motion may not be transversal, or 1 may be a multiplier");
  }
  const Nodes deviations = linear->deviations(responses(links, conditions_of(chain, m)));
  Nodes N = m;
  for (std::size_t i = 0; i < N.size(); ++i) {
    N[i] += deviations[i];
  }
  if (!is_inside(N, X)) {
    return open("no box around the guess passed Newton's test");
  }
  return {Verdict::proved(), WorkingPrecision::bits(), N, X, linear->return_map()};
}

}  // namespace

ChainProof newton_test(const MachineQuestion& question, const Nodes& m, long exponent) {
  return test(Chain(question), m, exponent);
}

ChainProof prove_chain(const MachineQuestion& question, const Nodes& guess, long bits, long most_bits) {
  ChainProof proof = open("Newton's method leads to no closed motion from there");
  Nodes nodes = guess;
  Chains chains(question);
  for (long precision = std::max(bits, fewest_bits); precision <= most_bits; precision *= 4) {
    const Approach approach = approximate(chains, nodes, precision);
    if (approach.astray) {
      break;
    }
    if (!approach.nodes) {
      continue;
    }
    nodes = *approach.nodes;
    const WorkingPrecision scope(precision);
    // Wide boxes have much of the motion's surroundings in them, narrow ones are the easiest.
    for (const long exponent : {-precision * 3 / 4, -precision * 7 / 8}) {
      proof = test(chains.now(), nodes, exponent);
      if (proof.verdict.truth == Truth::proved) {
        return proof;
      }
    }
  }
  return proof;
}

namespace {

// Twice as wide as the deviations, about 0.
Nodes room_for(const Nodes& deviations) {
  const double least = std::exp2(-static_cast<double>(WorkingPrecision::bits()) / 2);
  Nodes room = deviations;
  for (Node& u : room) {
    u = u.unaryExpr([&](const Ball& x) { return scalars::within(Ball(2) * abs(x) + Ball(least)); });
  }
  return room;
}

}  // namespace

std::optional<Nodes> approximate_chain(const MachineQuestion& question, const Nodes& guess) {
  Chains chains(question);
  return approximate(chains, midpoints(guess), WorkingPrecision::bits()).nodes;
}

// Newton's method on polynomials, degree after degree: of those below none is left in the conditions.
std::optional<NodesInData> approximate_chains(const Chain& chain, const Chain& in_middle,
                                              const Nodes& middle) {
  const std::vector<Link> links = links_of(in_middle, midpoints(middle));
  const auto linear = LinearChain::of(links);
  if (!linear) {
    return std::nullopt;
  }
  const std::size_t count = monomials(chain.data());
  NodesInData nodes;
  for (const Node& u : middle) {
    nodes.emplace_back(zeros::midpoints(Matrix(u))).c.resize(count);
  }
  for (std::size_t degree = 1; degree <= highest_degree; ++degree) {
    std::vector<InData<Matrix>> F;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      F.push_back(chain.conditions(nodes, i));
      F.back().c.resize(count);
    }
    for (std::size_t place = 0; place < count; ++place) {
      if (monomial(place).degree() != degree) {
        continue;
      }
      Nodes g;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Matrix& of_monomial = F[i].c[place];
        g.push_back(zeros::midpoints(is_none(of_monomial) ? Node::Constant(middle[i].size(), Ball(0))
                                                          : links[i].response(of_monomial)));
      }
      const Nodes deviations = linear->deviations(g);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        nodes[i].c[place] = zeros::midpoints(deviations[i]);
      }
    }
  }
  return nodes;
}

// What Newton's test takes of the derivatives of the conditions by the nodes, their means between two points
// of the box for one s, lies in the balls for the box.
ChainProof prove_chains(const Chain& chain, const NodesInData& nodes, const std::vector<Known>& known) {
  constexpr int attempts = 3;
  std::vector<Link> links = links_of(chain, nodes);
  const Nodes F = conditions_of(links);
  auto linear = LinearChain::of(links);
  for (int attempt = 0; attempt < attempts && linear; ++attempt) {
    const Nodes room = room_for(linear->deviations(responses(links, F)));
    NodesInData X = nodes;
    for (std::size_t i = 0; i < X.size(); ++i) {
      X[i].rest = room[i];
    }
    links = links_of(chain, X);
    linear = LinearChain::of(links);
    const Nodes image = linear ? linear->deviations(responses(links, F)) : room;
    if (!is_inside(image, room)) {
      continue;
    }
    for (const Known& one : known) {
      const std::vector<Ball> s(one.s.begin(), one.s.end());
      for (std::size_t i = 0; i < X.size(); ++i) {
        if (!zeros::is_interior<Eigen::Dynamic>(Node(one.proof.nodes[i] - nodes[i].at(s)), room[i])) {
          return open("a known motion is not among those");
        }
      }
    }
    ChainProof proof{Verdict::proved(), WorkingPrecision::bits(), {}, {}, linear->return_map()};
    for (std::size_t i = 0; i < X.size(); ++i) {
      proof.unique.emplace_back(X[i].all());
      X[i].rest = image[i];
      proof.nodes.emplace_back(X[i].all());
    }
    proof.in_data = X;
    return proof;
  }
  return open("no box around the motions passed Newton's test");
}

namespace {

// What is known of "the chain is a shorter one, taken d times": each node is the one 1/d of the way later.
Truth is_repetition(const MachineQuestion& q, const ChainProof& proof, std::size_t d) {
  const WorkingPrecision scope(proof.bits);
  const std::size_t count = q.pieces.size(), step = count / d;
  const bool autonomous = q.machine.oscillator.is_autonomous();
  const Ball turn =
      autonomous ? Ball(0) : Ball(2 * q.periods) * Ball::pi() / oscillator_as<Ball>(q.machine).omega;
  bool same = true;
  for (std::size_t i = 0; i < count; ++i) {
    Node later = proof.nodes[(i + step) % count];
    later(0) += turn * Ball(i + step >= count ? 1 : 0) - turn / Ball(static_cast<long>(d));
    for (Eigen::Index j = 0; j < later.size(); ++j) {
      if (!later(j).overlaps(proof.nodes[i](j))) {
        return Truth::refuted;
      }
      same = same && later(j).is_interior_to(proof.unique[i](j));
    }
  }
  // Motions are motions a whole period of the load later.
  const bool is_closed = autonomous || q.periods % static_cast<long>(d) == 0;
  return same && is_closed ? Truth::proved : Truth::undecided;
}

}  // namespace

std::pair<long, Verdict> repetition(const MachineQuestion& question, const ChainProof& proof) {
  const std::vector<Piece>& pieces = question.pieces;
  for (std::size_t d = pieces.size(); d > 1; --d) {
    const auto step = static_cast<std::ptrdiff_t>(pieces.size() / d);
    if (pieces.size() % d != 0 || !std::equal(pieces.begin() + step, pieces.end(), pieces.begin())) {
      continue;
    }
    const Truth repeats = is_repetition(question, proof, d);
    if (repeats != Truth::refuted) {
      return {static_cast<long>(d),
              repeats == Truth::proved
                  ? Verdict::proved()
                  : Verdict::undecided(fmt::format("the motion may be a shorter one taken {} times", d))};
    }
  }
  return {1, Verdict::proved()};
}

}  // namespace stickslip::numeric::machines
