#include "numeric/machines/chain_proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "numeric/zeros/krawczyk.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using zeros::in_double;
using zeros::product;
using Matrix = model::MatrixX<Ball>;

namespace {

Matrix middles(const Matrix& A) {
  return A.unaryExpr([](const Ball& x) { return x.midpoint(); });
}

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

namespace {

// A matrix that depends on s, -1 <= s <= 1, as a polynomial; empty coefficients are zero.
using OfS = std::array<Matrix, 3>;
const Matrix zero;

void add(Matrix& sum, const Matrix& a, const Matrix& b) {
  if (a.size() == 0 || b.size() == 0) {
    return;
  }
  if (sum.size() == 0) {
    sum = product(a, b);
  } else {
    sum += product(a, b);
  }
}

// (a + s a_rate) b, what s³ multiplies being in the constant.
OfS times(const Matrix& a, const Matrix& a_rate, const OfS& b) {
  OfS result;
  Matrix cubic;
  for (std::size_t i = 0; i < b.size(); ++i) {
    add(result.at(i), a, b.at(i));
    add(i + 1 < b.size() ? result.at(i + 1) : cubic, a_rate, b.at(i));
  }
  if (cubic.size() > 0) {
    result[0] += cubic * Ball::hull(Ball(-1), Ball(1));
  }
  return result;
}

// For all s.
Matrix all_of(const OfS& a) {
  Matrix all = a[0];
  if (a[1].size() > 0) {
    all += a[1] * Ball::hull(Ball(-1), Ball(1));
  }
  if (a[2].size() > 0) {
    all += a[2] * Ball::hull(Ball(0), Ball(1));
  }
  return all;
}

// Contains the solutions of C(s) x = v, C = 1 - P: with Y(s) = Y + s Y P1 Y near the inverse and |1 - Y(s)
// C(s)| = e < 1 they are within e/(1 - e) |Y(s) v| of Y(s) v.
std::optional<Node> solved(const OfS& P, const Node& v) {
  const Matrix C = Matrix(Matrix::Identity(v.size(), v.size())) - P[0];
  const auto Y = is_finite(C) ? zeros::row_combinations(C) : std::nullopt;
  if (!Y) {
    return std::nullopt;
  }
  OfS E;  // Y(s) P - Y(s) + 1
  const Matrix Y1 = P[1].size() > 0 ? middles(product(*Y, Matrix(product(P[1], *Y)))) : zero;
  E = times(*Y, Y1, P);
  E[0] += Matrix(Matrix::Identity(v.size(), v.size())) - *Y;
  if (Y1.size() > 0) {
    E[1] -= Y1;
  }
  Ball e(0);
  for (const Matrix& part : E) {
    e += part.size() > 0 ? zeros::norm(part) : Ball(0);
  }
  const Ball room = Ball(1) - e;
  if (!room.is_positive()) {
    return std::nullopt;
  }
  Node x = product(all_of({*Y, Y1, zero}), v);
  Ball largest(0);
  for (const Ball& entry : x) {
    arb_max(largest.raw(), largest.raw(), abs(entry).upper().raw(), WorkingPrecision::bits());
  }
  const Ball most = Ball(largest * e / room).upper();
  for (Ball& entry : x) {
    entry += Ball::hull(-most, most);
  }
  return x;
}

// Powers of two, as exponents, in which the links are balanced.
std::vector<long> units_of(const std::vector<Link>& links) {
  Eigen::MatrixXd sizes = in_double(links.front().M).cwiseAbs();
  for (std::size_t i = 1; i < links.size(); ++i) {
    sizes += in_double(links[i].M).cwiseAbs();
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

std::optional<Sweep> sweep(std::vector<Link> links, const Nodes& g) {
  const bool finite = std::all_of(links.begin(), links.end(),
                                  [](const Link& l) { return is_finite(l.M) && is_finite(l.M_rate); });
  if (!finite) {
    return std::nullopt;
  }
  const std::vector<long> units = units_of(links);
  for (Link& link : links) {
    scale(link.M, units);
    scale(link.M_rate, units);
  }
  const std::size_t count = links.size();
  const std::vector<Matrix> Q = frames(links);
  const Eigen::Index n = links.front().M.rows();
  // e_i = P_i e_0 + h_i.
  std::vector<OfS> P{{Matrix::Identity(n, n), zero, zero}};
  Nodes h{Node::Constant(n, Ball(0))};
  for (std::size_t i = 0; i < count; ++i) {
    const Matrix to = Q[(i + 1) % count].transpose();
    Matrix R, R_rate;
    add(R, to, product(links[i].M, Q[i]));
    add(R_rate, to, links[i].M_rate.size() > 0 ? Matrix(product(links[i].M_rate, Q[i])) : zero);
    P.emplace_back(times(R, R_rate, P[i]));
    const Node passed = product(R_rate.size() > 0 ? all_of({R, R_rate, zero}) : R, h[i]);
    h.emplace_back(passed + product(to, scaled(g[i], units, 1)));
  }
  const auto first = solved(P.back(), h.back());
  if (!first) {
    return std::nullopt;
  }
  Sweep result{{}, all_of(P.back())};
  for (std::size_t i = 0; i < count; ++i) {
    const Node deviation = product(Q[i], Node(product(all_of(P[i]), *first) + h[i]));
    result.deviations.emplace_back(scaled(deviation, units, -1));
  }
  return result;
}

namespace {

constexpr long fewest_bits = 128;
// From where on Newton's method does not come back, as a power of two: states of a motion in units of its
// own lengths.
constexpr long far_away = 20;

ChainProof open(const char * reason) {
  return {Verdict::undecided(reason), 0, {}, {}, {}};
}

std::vector<Link> links_of(const Chain& chain, const Nodes& nodes) {
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
  long gain = 0;  // of a step over the one before, as a power of two: the step where the links are
  for (int k = 0; k < most_steps; ++k) {
    const WorkingPrecision scope(precision);
    const Chain& chain = chains.now();
    const bool fresh = gain > near_enough;
    if (fresh) {
      links = links_of(chain, nodes);
    }
    const Nodes g = midpoints(responses(links, conditions_of(chain, nodes)));
    const auto found = sweep(links, g);
    if (!found) {
      return {};
    }
    const long size = exponent(found->deviations);
    if (size > far_away) {
      return {{}, true};
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes[i] = midpoint(nodes[i] + found->deviations[i]);
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

ChainProof test(const Chain& chain, const Nodes& m, long exponent) {
  const Nodes X = boxes(m, exponent);
  const std::vector<Link> links = links_of(chain, X);
  const auto image = sweep(links, responses(links, conditions_of(chain, m)));
  if (!image) {
    return open("an event of the motion may not be transversal, or 1 may be a multiplier");
  }
  Nodes N = m;
  for (std::size_t i = 0; i < N.size(); ++i) {
    N[i] += image->deviations[i];
    if (!zeros::is_interior<Eigen::Dynamic>(N[i], X[i])) {
      return open("no box around the guess passed Newton's test");
    }
  }
  return {Verdict::proved(), WorkingPrecision::bits(), N, X, image->return_map};
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

Nodes moved(Nodes nodes, const Nodes& by, const Ball& s) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i] += by[i] * s;
  }
  return nodes;
}

// Twice as wide as the deviations, about 0.
Nodes room_for(const Nodes& deviations) {
  const double least = std::exp2(-static_cast<double>(WorkingPrecision::bits()) / 2);
  Nodes room = deviations;
  for (Node& u : room) {
    u = u.unaryExpr([&](const Ball& x) {
      const Ball most = Ball(Ball(2) * abs(x) + Ball(least)).upper();
      return Ball::hull(-most, most);
    });
  }
  return room;
}

bool is_inside(const Nodes& nodes, const Nodes& room) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!zeros::is_interior<Eigen::Dynamic>(nodes[i], room[i])) {
      return false;
    }
  }
  return true;
}

}  // namespace

// In a box about the curve the derivatives of the conditions by the nodes are those about m at s = 0 and s
// times how they change along the curve; what Newton's test takes of them, their means between two points of
// the box for one s, lies in the same balls.
ChainProof prove_curve(const MachineQuestion& question, const ChainProof& low, const ChainProof& high,
                       long bits) {
  constexpr int attempts = 3;
  MachineQuestion thin = question;
  thin.ends.reset();
  const WorkingPrecision scope(bits);
  Chains chains(thin);
  const Nodes first = midpoints(low.nodes), last = midpoints(high.nodes);
  const Nodes tangent = midpoints(moved(moved(last, last, Ball(-0.5)), first, Ball(-0.5)));
  const Approach approach = approximate(chains, midpoints(moved(first, tangent, Ball(1))), bits);
  if (!approach.nodes) {
    return open("Newton's method leads to no closed motion from there");
  }
  const Nodes& m = *approach.nodes;
  const Chain& one = chains.now();
  const Chain chain(question);
  const Curve curve{m, tangent,
                    midpoints(moved(moved(moved(m, m, Ball(-2)), last, Ball(0.5)), first, Ball(0.5)))};
  const Nodes all = curve.all(), rates = curve.rates();
  Nodes F;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    F.push_back(chain.conditions(curve, i));
  }
  const std::vector<Link> near = links_of(one, m);
  auto image = sweep(near, responses(near, F));
  for (int attempt = 0; attempt < attempts && image; ++attempt) {
    const Nodes room = room_for(image->deviations);
    const Nodes about = moved(m, room, Ball(1)), unique = moved(all, room, Ball(1));
    std::vector<Link> links = links_of(chain, unique);
    const Nodes g = responses(links, F);
    for (std::size_t i = 0; i < links.size(); ++i) {
      links[i].M = one.link(about, i).M;
      links[i].M_rate = chain.link_by_datum(unique, rates, i);
    }
    image = sweep(links, g);
    if (!image || !is_inside(image->deviations, room)) {
      continue;
    }
    const Nodes ends = moved(about, curve.bend, Ball(1));
    if (!is_inside(low.nodes, moved(ends, tangent, Ball(-1))) ||
        !is_inside(high.nodes, moved(ends, tangent, Ball(1)))) {
      return open("the curve does not end at the motions on both sides");
    }
    return {Verdict::proved(), bits, moved(all, image->deviations, Ball(1)), unique, image->return_map};
  }
  return open("no box around the curve passed Newton's test");
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
