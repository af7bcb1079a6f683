#include "numeric/machines/basins/neighbourhood.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/machines/orbits/chain_proof.hpp"
#include "numeric/scalars/scalars.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using motion::StabilityKind;
using zeros::in_double;
using zeros::product;

// With the distance d of members from the middle M in Frobenius' norm, (1 - d)² I - Mᵀ M is positive
// definite, by its elimination.
bool contracts(const Matrix& A) {
  Ball square(0);
  for (Eigen::Index i = 0; i < A.size(); ++i) {
    const Ball radius(A.data()[i].radius());
    square += radius * radius;
  }
  const Ball room = Ball(1) - sqrt(square);
  if (!room.is_positive()) {
    return false;
  }
  const Matrix M = zeros::midpoints(A);
  Matrix G = -Matrix(product(M.transpose(), M));
  for (Eigen::Index k = 0; k < G.rows(); ++k) {
    G(k, k) += room * room;
  }
  for (Eigen::Index k = 0; k < G.rows(); ++k) {
    if (!G(k, k).is_positive()) {
      return false;
    }
    for (Eigen::Index i = k + 1; i < G.rows(); ++i) {
      const Ball factor = G(i, k) / G(k, k);
      for (Eigen::Index l = k; l < G.cols(); ++l) {
        subtract_product(G(i, l), factor, G(k, l));
      }
    }
  }
  return true;
}

namespace {

constexpr long fewest_bits = 64;
constexpr int most_halvings = 1000;
// How the ball grows where it is cut into boxes, and how large these are in parts of the ball that needs
// none.
const double growth = std::exp2(0.25);
constexpr double largest_box = 4, smallest_box = 0.05;
// What is proved for the machine in tables, perhaps at ur to 17 digits, is the orbit asked about if it is as
// near as this.
constexpr double same_orbit = 1e-9;
// c from the orbit, in parts of rho.
constexpr double off_centre = 1e-3;
constexpr double very_small = 1e-60;  // in parts of the orbit

// The return map to a section, for sets of starts there.
class Return {
 public:
  Return(const Machine& machine, const MachineOrbit& orbit)
      : orbit_(orbit), autonomous_(machine.oscillator.is_autonomous()), flow_(machine) {
    const LinearPhases& phases = flow_.phases();
    const std::size_t count = orbit.phases.size();
    const auto slides = [&](std::size_t i) { return orbit.pieces[i].side() != 0; };
    const auto length = [&](std::size_t i) {
      return slides(i) ? orbit.phases[i].duration.approximate() : -1;
    };
    for (std::size_t i = 1; i < count; ++i) {
      first_ = length(i) > length(first_) ? i : first_;
    }
    if (autonomous_) {
      first_ = (first_ + 1) % count;
      centre_ = zeros::midpoints(orbit.phases[first_].state);
      rows_ = phases.rows_but_speed();
      centre_(phases.speed_row()) = Ball(speed_between(
          machine.oscillator, orbit.pieces[(first_ + count - 1) % count], orbit.pieces[first_]));
      proved_ = orbit.phases[first_].state;
      return;
    }
    const MachinePhase& phase = orbit.phases[first_];
    const Ball& omega = phases.oscillator().omega;
    const Ball begin = orbit.load / omega + phase.start;
    time_ = Ball(Ball(begin + phase.duration / Ball(2)).approximate());
    proved_ = passage(phases, phase.piece, phases.whole(phase.state, omega * begin), time_ - begin, false)
                  .reached.head(phase.state.size());
    centre_ = zeros::midpoints(proved_);
    rows_.resize(static_cast<std::size_t>(centre_.size()));
    std::iota(rows_.begin(), rows_.end(), 0);
    period_ = Ball(2 * orbit.periods) * Ball::pi() / omega;
  }

  [[nodiscard]] bool is_autonomous() const { return autonomous_; }
  [[nodiscard]] const Vector& centre() const { return centre_; }
  [[nodiscard]] const Vector& proved() const { return proved_; }  // contains the orbit's point
  [[nodiscard]] const Ball& time() const { return time_; }
  [[nodiscard]] const Piece& piece() const { return orbit_.pieces[first_]; }
  [[nodiscard]] const Piece& before() const { return cyclic(first_ + orbit_.pieces.size() - 1); }

  // z to (x, x'), and back: the numbers of z are those of the state but for one that is known.
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(rows_.size()); }
  template <class M>
  [[nodiscard]] M without_known(const M& rows) const {
    return rows(rows_, Eigen::all);
  }
  [[nodiscard]] Matrix with_known(const Matrix& rows) const {
    Matrix result = Matrix::Constant(centre_.size(), rows.cols(), Ball(0));
    result(rows_, Eigen::all) = rows;
    return result;
  }
  // Of the starts from middle + S e, e in the ball or the box.
  [[nodiscard]] std::optional<SetOfMotions> operator()(const Vector& middle, const Matrix& S,
                                                       bool round) const {
    SetOfMotions set = set_at(time_, piece(), middle, with_known(S), round);
    if (!autonomous_) {
      return flow_.follow(set, time_ + period_).truth == Truth::proved && set.piece == piece()
                 ? std::optional(set)
                 : std::nullopt;
    }
    set.before = before();
    set.timeless = true;
    for (std::size_t i = 0; i < orbit_.pieces.size(); ++i) {
      const double about = orbit_.phases[(first_ + i) % orbit_.pieces.size()].duration.approximate();
      if (flow_.to_event(set, cyclic(first_ + i + 1), about).truth != Truth::proved) {
        return std::nullopt;
      }
    }
    return set;
  }

 private:
  [[nodiscard]] const Piece& cyclic(std::size_t i) const { return orbit_.pieces[i % orbit_.pieces.size()]; }

  const MachineOrbit& orbit_;
  bool autonomous_;
  SetFlow flow_;
  std::size_t first_ = 0;
  std::vector<Eigen::Index> rows_;  // those of (x, x') that z tells
  Vector centre_, proved_;
  Ball time_, period_;
};

// S: with A in units of `scale` and gamma between its spectral radius and 1, |S⁻¹ A S| <= gamma.
std::optional<Eigen::MatrixXd> contracting(const Eigen::MatrixXd& A, const Eigen::VectorXd& scale) {
  const Eigen::MatrixXd unit = scale.asDiagonal();
  const Eigen::MatrixXd inverse = scale.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd in_units = inverse * A * unit;
  if (!in_units.allFinite()) {
    return std::nullopt;
  }
  const double radius = zeros::spectral_radius(in_units);
  if (!(radius < 1)) {
    return std::nullopt;
  }
  const double gamma = radius + (1 - radius) / 4;
  Eigen::MatrixXd P = Eigen::MatrixXd::Identity(A.rows(), A.rows()), power = in_units / gamma;
  for (int k = 0; k < 100000 && power.norm() > 1e-9; ++k) {
    P += power.transpose().lazyProduct(power);
    power = Eigen::MatrixXd(power.lazyProduct(in_units)) / gamma;
  }
  const auto root = zeros::cholesky(P);
  if (!root) {
    return std::nullopt;
  }
  Eigen::MatrixXd S = unit * zeros::inverse(root->transpose());
  return S.allFinite() ? std::optional(S) : std::nullopt;
}

// Euclid's norm, from above.
Ball norm_of(const Vector& z) {
  Ball square(0);
  for (const Ball& x : z) {
    const Ball size = abs(x).upper();
    square += size * size;
  }
  return sqrt(square);
}

struct Cell {
  Eigen::VectorXd middle, half;  // of z
};

// All members are at most, or at least, so far from 0.
double farthest(const Cell& box) {
  return (box.middle.cwiseAbs() + box.half).norm() * (1 + 1e-14);
}
double nearest(const Cell& box) {
  return (box.middle.cwiseAbs() - box.half).cwiseMax(0).norm() * (1 - 1e-14);
}

// A little less, of so few digits that the ends of boxes, and of their halves, are exact: none is missed
// between two of them.
double short_number(double x) {
  constexpr double digits = 0x1p12;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::floor(mantissa * digits) / digits, exponent);
}

std::array<Cell, 2> halves(const Cell& box, Eigen::Index k) {
  std::array<Cell, 2> both{box, box};
  for (Cell& half : both) {
    half.half(k) /= 2;
  }
  both[0].middle(k) -= both[0].half(k);
  both[1].middle(k) += both[1].half(k);
  return both;
}

class Growth {
 public:
  Growth(const Machine& machine, const MachineOrbit& orbit, const Return& returns, const Matrix& S,
         const Matrix& inverse)
      : returns_([&machine, &orbit] { return Return(machine, orbit); }),
        centre_(returns.centre()),
        S_(S),
        inverse_(inverse) {}

  // Whether the derivative of the return map contracts over the ball of that radius.
  bool ball(double radius) {
    const Return& returns = returns_.local();
    const auto set = returns(centre_, S_ * Ball(radius), true);
    return set && contracts(of_z(returns, set->all.first) * Ball(1 / Ball(radius)));
  }

  // The same over the shell between the radii, by boxes of some size; how many, or nothing.
  std::optional<long> shell(double from, double to, double size, long most) {
    std::vector<Cell> open{{Eigen::VectorXd::Zero(S_.cols()), Eigen::VectorXd::Constant(S_.cols(), to)}};
    long tried = 0;
    while (!open.empty()) {
      std::vector<Cell> ready;
      while (!open.empty()) {
        const Cell box = open.back();
        open.pop_back();
        if (nearest(box) > to || farthest(box) <= from) {
          continue;
        }
        Eigen::Index k = 0;
        if (box.half.maxCoeff(&k) > size * largest_box) {
          const auto both = halves(box, k);
          open.insert(open.end(), both.begin(), both.end());
        } else {
          ready.push_back(box);
        }
      }
      tried += static_cast<long>(ready.size());
      if (tried > most || interrupted()) {
        return std::nullopt;
      }
      const auto splits = parallel_map(ready.size(), [&](std::size_t i) { return split_of(ready[i]); });
      for (std::size_t i = 0; i < ready.size(); ++i) {
        if (!splits[i]) {
          continue;
        }
        if (ready[i].half(*splits[i]) < size * smallest_box) {
          return std::nullopt;
        }
        const auto both = halves(ready[i], *splits[i]);
        open.insert(open.end(), both.begin(), both.end());
      }
    }
    return tried;
  }

 private:
  // Of z on return, of the derivative of u there.
  [[nodiscard]] Matrix of_z(const Return& returns, const Matrix& of_u) const {
    return product(inverse_, returns.without_known(Matrix(of_u.bottomRows(centre_.size()))));
  }

  // Nothing where the derivative contracts over the box; else which of its sides is best halved, that along
  // which the derivative changes most.
  std::optional<Eigen::Index> split_of(const Cell& box) {
    const Return& returns = returns_.local();
    Matrix S = S_;
    Vector middle = centre_;
    const Matrix to_state = returns.with_known(S_);
    for (Eigen::Index k = 0; k < S.cols(); ++k) {
      S.col(k) *= Ball(box.half(k));
      middle += to_state.col(k) * Ball(box.middle(k));
    }
    Eigen::Index side = 0;
    box.half.maxCoeff(&side);
    const auto set = returns(middle, S, false);
    if (!set) {
      return side;
    }
    const auto by_z = [&](const Matrix& by_e) {
      Matrix D = of_z(returns, by_e);
      for (Eigen::Index k = 0; k < D.cols(); ++k) {
        D.col(k) /= Ball(box.half(k));
      }
      return D;
    };
    if (contracts(by_z(set->all.first))) {
      return std::nullopt;
    }
    double most = 0;
    for (std::size_t k = 0; k < set->all.second.size(); ++k) {
      const double change = in_double(by_z(set->all.derivative_of_first(k))).norm();
      if (change > most) {
        most = change;
        side = static_cast<Eigen::Index>(k);
      }
    }
    return side;
  }

  tbb::enumerable_thread_specific<Return> returns_;
  Vector centre_;
  Matrix S_, inverse_;
};

// At the working precision.
Neighbourhood found_at(const Machine& machine, const MachineOrbit& orbit, long most_phases) {
  const Return returns(machine, orbit);
  const Eigen::Index n = returns.size();
  // How large the motion is.
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(n);
  for (const MachinePhase& phase : orbit.phases) {
    const Matrix away = returns.without_known(Matrix(phase.state - returns.centre()));
    scale = scale.cwiseMax(in_double(away).cwiseAbs());
  }
  const double largest = scale.maxCoeff();
  scale = scale.cwiseMax(largest * 1e-6);
  Neighbourhood found;
  found.verdict = Verdict::undecided("the return map is not enclosed beside the orbit");
  const auto beside = returns(returns.centre(),
                              Matrix(Eigen::MatrixXd((scale * very_small).asDiagonal()).cast<Ball>()), true);
  if (!beside) {
    return found;
  }
  Matrix A = returns.without_known(Matrix(beside->middle.first.bottomRows(returns.centre().size())));
  for (Eigen::Index k = 0; k < n; ++k) {
    A.col(k) /= Ball(scale(k) * very_small);
  }
  const auto S = contracting(in_double(A), scale);
  if (!S) {
    return found;
  }
  found.S = S->cast<Ball>();
  const Matrix Y = zeros::inverse(*S).cast<Ball>();
  const auto inverse = enclosed_inverse(found.S, Y);
  if (!inverse) {
    return found;
  }
  found.inverse = *inverse;
  Growth growing(machine, orbit, returns, found.S, found.inverse);
  // The largest power of two that needs no boxes, and a little more.
  int fails = -1, holds = 0;
  while (holds <= most_halvings && !interrupted() && !growing.ball(std::exp2(-holds))) {
    fails = std::exchange(holds, std::max(1, 2 * holds));
  }
  if (holds > most_halvings || interrupted()) {
    return found;
  }
  while (holds - fails > 1) {
    const int between = (holds + fails) / 2;
    (growing.ball(std::exp2(-between)) ? holds : fails) = between;
  }
  double radius = std::exp2(-holds);
  for (const double factor : {std::sqrt(2), growth}) {
    const double larger = short_number(radius * factor);
    radius = growing.ball(larger) ? larger : radius;
  }
  const double at_once = radius;
  long most_boxes =
      most_phases * fewest_bits / (static_cast<long>(orbit.phases.size()) * WorkingPrecision::bits());
  for (double larger = short_number(radius * growth);
       const auto boxes = growing.shell(radius, larger, at_once, most_boxes);
       larger = short_number(radius * growth)) {
    radius = larger;
    found.boxes += *boxes;
    most_boxes -= *boxes;
  }
  // The orbit's own point, and where the map takes c.
  const auto is_near = [&](const Vector& state, double share) {
    const Vector z = product(found.inverse, Vector(returns.without_known(Matrix(state - returns.centre()))));
    return (Ball(radius * share) - norm_of(z)).is_positive();
  };
  if (!is_near(returns.proved(), off_centre)) {
    found.verdict = Verdict::undecided("the orbit is not known to as many digits as the set is small");
    return found;
  }
  if (!is_near(beside->middle.value.tail(returns.centre().size()), 3 * off_centre)) {
    found.verdict = Verdict::undecided("the motion does not return: it is no orbit of this machine");
    return found;
  }
  found.verdict = Verdict::proved();
  found.radius = radius * (1 - 3 * off_centre);
  found.piece = returns.piece();
  found.centre = returns.centre();
  found.period = orbit.period.approximate();
  if (returns.is_autonomous()) {
    found.before = returns.before();
  } else {
    found.time = returns.time().approximate();
    found.theta = std::fmod(oscillator_as<double>(machine).omega * found.time, 2 * std::numbers::pi);
  }
  found.S = returns.with_known(found.S);
  found.inverse = returns.with_known(Matrix(found.inverse.transpose())).transpose();
  // Rounded down.
  found.alone = found.half_widths = Eigen::VectorXd::Zero(found.centre.size());
  for (Eigen::Index i = 0; i < found.centre.size(); ++i) {
    const Vector row = found.S.row(i).transpose(), column = found.inverse.col(i);
    if (in_double(column).norm() > 0) {
      found.alone(i) = scalars::ends(Ball(Ball(found.radius) / norm_of(column))).first;
      found.half_widths(i) = scalars::ends(Ball(Ball(found.radius) * norm_of(row))).first;
    }
  }
  return found;
}

}  // namespace

Neighbourhood neighbourhood_of(const Machine& machine, const MachineOrbit& orbit, long most_phases) {
  Neighbourhood found;
  if (orbit.existence.truth != Truth::proved || orbit.admissible.truth != Truth::proved || !orbit.stability ||
      orbit.stability->kind != StabilityKind::stable) {
    found.verdict = Verdict::undecided("the orbit is not proved to be admissible and stable");
    return found;
  }
  for (const long bits : {fewest_bits, orbit.bits, 4 * orbit.bits}) {
    const WorkingPrecision scope(bits);
    found = found_at(machine, orbit, most_phases);
    if (found.verdict.truth == Truth::proved || interrupted()) {
      break;
    }
  }
  return found;
}

Neighbourhood neighbourhood_of(const words::WordQuestion& machine, const families::Orbit& orbit, long periods,
                               long most_phases) {
  const Machine same{model::friction_oscillator<Rational>(machine.data, machine.ur)};
  Neighbourhood none;
  if (orbit.motion.phases.size() < 2) {
    none.verdict = Verdict::undecided("the orbit is not proved to exist");
    return none;
  }
  const MachineGuess guess = guess_of(orbit.motion, periods);
  const MachineOrbit proved = prove_machine_orbit(same, guess);
  if (proved.existence.truth == Truth::proved && !(distance(guess_of(proved, same), guess) < same_orbit)) {
    none.verdict = Verdict::undecided("as a machine in tables another orbit is proved");
    return none;
  }
  return neighbourhood_of(same, proved, most_phases);
}

void surround(families::Orbit& orbit, const words::WordQuestion& machine, long periods) {
  if (families::is_stable(orbit) && !interrupted()) {
    orbit.neighbourhood = std::make_shared<Neighbourhood>(neighbourhood_of(machine, orbit, periods));
  }
}

bool Neighbourhood::holds(const SetOfMotions& set) const {
  if (set.piece != piece || (before && set.before != before)) {
    return false;
  }
  const Eigen::Index states = centre.size();
  const Vector z = product(inverse, Vector(set.middle.value.tail(states) - centre));
  const Matrix by_e = product(inverse, Matrix(set.all.first.bottomRows(states)));
  Vector farthest = z;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    farthest(i) += set.reach(by_e.row(i).transpose());
  }
  return (Ball(radius) - norm_of(farthest)).is_positive();
}

}  // namespace stickslip::numeric::machines
