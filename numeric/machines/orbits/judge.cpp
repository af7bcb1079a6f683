#include "numeric/machines/orbits/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numeric/machines/phases/passage.hpp"
#include "numeric/machines/phases/smooth_phase.hpp"
#include "numeric/zeros/linear_solve.hpp"

namespace stickslip::numeric::machines {

using scalars::anything;
using scalars::HardwareBall;
using scalars::within;
using zeros::product;

namespace {

// More than what is lost below the range of doubles.
constexpr double tiny = 1e-290;
constexpr std::array<int, 5> factorial{1, 1, 2, 6, 24};

// Not less than the size of any member.
double most(const Ball& x) {
  mag_t size;
  mag_init(size);
  arb_get_mag(size, x.raw());
  const double result = mag_get_d(size);
  mag_clear(size);
  return result;
}

// The largest size, from above.
Ball largest(const Vector& v, const Vector& weights) {
  Ball most(0);
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    const Ball size = abs(v(i) * weights(i));
    arb_max(most.raw(), most.raw(), size.raw(), WorkingPrecision::bits());
  }
  return most.upper();
}

}  // namespace

Watched::Watched(const LinearPhases& phases, Piece piece, const InData<Matrix>& w, const Ball& T,
                 bool reversed)
    : phases_(phases), piece_(piece), reversed_(reversed), covers_(false) {
  if (phases.is_smooth(piece)) {
    if (phases.is_over_data()) {
      follow<InData<Ball>>(entries(w), T);
    } else {
      follow<Ball>(w.all(), T);
    }
    return;
  }
  watch_ = &phases.watch(piece, reversed);
  constexpr double most_stretches = 1e7;
  const double stretches = std::ceil(T.approximate() / watch_->length * (1 + 1e-9));
  if (stretches > 1 && stretches < most_stretches) {
    count_ = static_cast<std::size_t>(stretches);
  }
  covers_ = !(Ball(static_cast<double>(count_) * watch_->length) - T).lower().is_negative();
  stretches_.push_back({0, watch_->length, w, {}, {}, {}, {}, {}});
}

template <class S>
void Watched::follow(const model::VectorX<S>& w, const Ball& T) {
  const SmoothPhaseOf<S> phase(phases_, piece_.side(), w, S(T), reversed_, false);
  for (const auto& step : phase.steps()) {
    model::VectorX<InData<Ball>> speeds(static_cast<Eigen::Index>(step.w.size()));
    for (Eigen::Index k = 0; k < speeds.size(); ++k) {
      speeds(k) = InData<Ball>(step.w[static_cast<std::size_t>(k)](phases_.speed_row()));
    }
    const InData<Vector> terms = mapped(together(speeds), [](const Matrix& x) { return Vector(x); });
    stretches_.push_back({step.start, step.length * phase.longer, {}, terms, {}, {}, {}, {}});
    finish(stretches_.back());
  }
  count_ = stretches_.size();
  covers_ = count_ > 0 &&
            !(Ball(stretches_.back().start) + Ball(stretches_.back().length) - T).lower().is_negative();
}

// row B^m w/m!.
InData<Vector> Watched::terms_at(const InData<Matrix>& w) const {
  if (!phases_.is_over_data()) {
    return mapped(w, [&](const Matrix& one) { return Vector(product(watch_->rows, one)); });
  }
  const Eigen::Index count = watch_->rows.rows();
  const InData<Matrix> B = phases_.drift_in_data(piece_) * Ball(reversed_ ? -1 : 1);
  const InData<Matrix> row = phases_.watched(piece_);
  InData<Matrix> term = w;
  InData<Vector> terms;
  for (Eigen::Index m = 0; m < count; ++m) {
    terms += mapped(row * term, [&](const Matrix& x) { return placed(x(0, 0), m, count); });
    term = product(B, term, sparse_product<Matrix>) * (Ball(1) / Ball(static_cast<long>(m + 1)));
  }
  return terms;
}

const Watched::Stretch& Watched::stretch(std::size_t k) const {
  // From one to the next balls grow; so every now and then from the first, and of many machines always.
  constexpr std::size_t most_in_a_row = 16;
  while (stretches_.size() <= k) {
    const std::size_t n = stretches_.size();
    const double start = static_cast<double>(n) * watch_->length;
    const Ball t(reversed_ ? -start : start);
    const InData<Matrix>& first = stretches_[0].w;
    InData<Matrix> w;
    if (phases_.is_over_data()) {
      w = phases_.flow(piece_, InData<Ball>(t)) * first;
    } else if (n % most_in_a_row == 0) {
      w = InData<Matrix>(Matrix(phases_.after(piece_, t, Vector(first.all()))));
    } else {
      w = InData<Matrix>(Matrix(product(watch_->flow, stretches_.back().w.all())));
    }
    stretches_.push_back({start, watch_->length, w, {}, {}, {}, {}, {}});
  }
  Stretch& found = stretches_[k];
  if (found.guess.size() > 0) {
    return found;
  }
  found.terms = terms_at(found.w);
  const Ball of_w = watch_->size * largest(found.w.all(), watch_->balance);
  for (std::size_t i = 0; i < found.rest.size(); ++i) {
    found.rest[i] = most(of_w * watch_->rest[i]);
  }
  finish(found);
  return found;
}

void Watched::finish(Stretch& stretch) const {
  const InData<Vector>& terms = stretch.terms;
  if (terms.c.size() == 1 && is_none(terms.rest) && WorkingPrecision::bits() <= few_bits) {
    stretch.quick = terms.c[0].unaryExpr([](const Ball& x) { return HardwareBall(x); });
    stretch.guess = stretch.quick.unaryExpr([](const HardwareBall& x) { return x.approximate(); });
    stretch.most =
        stretch.guess.cwiseAbs() + stretch.quick.unaryExpr([](const HardwareBall& x) { return x.radius(); });
  } else {
    stretch.guess = zeros::in_double(terms.c[0]);
    stretch.most = terms.all().unaryExpr([](const Ball& x) { return most(x); });
  }
}

std::size_t Watched::stretch_of(double s) const {
  if (watch_ == nullptr) {
    const auto after = std::ranges::upper_bound(stretches_, s, {}, &Stretch::start);
    return after == stretches_.begin() ? 0 : static_cast<std::size_t>(after - stretches_.begin()) - 1;
  }
  const double k = std::floor(s / watch_->length);
  return k > 0 ? std::min(static_cast<std::size_t>(k), count_ - 1) : 0;
}

namespace {

// The first derivatives, each over i!, of the polynomial with these coefficients.
template <std::size_t N, class S>
std::array<S, N> horner(const model::VectorX<S>& terms, const S& r, std::size_t count) {
  std::array<S, N> d{};
  for (Eigen::Index m = terms.size(); m-- > 0;) {
    for (std::size_t i = count - 1; i > 0; --i) {
      d[i] *= r;
      d[i] += d[i - 1];
    }
    d[0] *= r;
    d[0] += terms(m);
  }
  return d;
}

// The first derivatives of the polynomial with these terms: in hardware, or of functions of data for all of
// them, of each monomial by itself, in which the terms go together.
template <std::size_t N>
std::array<Ball, N> derivatives(const model::VectorX<HardwareBall>& terms, const Ball& r, std::size_t count) {
  const auto d = horner<N>(terms, HardwareBall(r), count);
  std::array<Ball, N> result;
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = (d[i] * HardwareBall(factorial[i])).ball();
  }
  return result;
}
template <std::size_t N>
std::array<Ball, N> derivatives(const InData<Vector>& terms, const Ball& r, std::size_t count) {
  std::array<Ball, N> sum;
  const auto add = [&](const Vector& of_one, const Ball& range) {
    if (of_one.size() > 0) {
      const auto d = horner<N>(of_one, r, count);
      for (std::size_t i = 0; i < count; ++i) {
        add_product(sum[i], d[i], range * Ball(factorial[i]));
      }
    }
  };
  for (std::size_t i = 0; i < terms.c.size(); ++i) {
    add(terms.c[i], monomial(i).range());
  }
  add(terms.rest, Ball(1));
  return sum;
}

// All terms but the first, those of the derivative before, as often as these are derived.
template <class S>
model::VectorX<S> without_first(const model::VectorX<S>& terms, Eigen::Index first) {
  model::VectorX<S> later = terms.tail(terms.size() - first);
  for (Eigen::Index m = 0; m < later.size(); ++m) {
    for (Eigen::Index i = 0; i + 1 < first; ++i) {
      later(m) *= S(static_cast<int>(m + first - i));
    }
  }
  return later;
}

}  // namespace

std::array<Ball, 4> Watched::at(const Ball& s, std::size_t derivative, const InData<Ball>& offset) const {
  std::array<Ball, 4 + most_derivatives> d;
  const std::size_t count = 4 + derivative;
  bool is_inside = false;
  if (count_ > 0) {
    const Stretch& here = stretch(stretch_of(s.approximate()));
    const Ball r = s - Ball(here.start);
    is_inside = !r.lower().is_negative() && !(Ball(here.length) - r).lower().is_negative();
    if (here.quick.size() > 0) {
      d = derivatives<4 + most_derivatives>(here.quick, r, count);
      d[0] += offset.all();
    } else {
      InData<Vector> terms = here.terms;
      terms += mapped(offset, [&](const Ball& x) { return placed(x, 0, here.guess.size()); });
      d = derivatives<4 + most_derivatives>(terms, r, count);
    }
    for (std::size_t i = 0; i < count; ++i) {
      d[i] += within(Ball(here.rest[i]));
    }
  }
  std::array<Ball, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] = is_inside ? d[i + derivative] : anything();
  }
  return result;
}

std::array<double, 4> Watched::guess_at(double s, std::size_t derivative) const {
  std::array<double, 4 + most_derivatives> d{};
  if (count_ > 0) {
    const Stretch& here = stretch(stretch_of(s));
    d = horner<4 + most_derivatives>(here.guess, s - here.start, d.size());
  }
  std::array<double, 4> result{};
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] = d[i + derivative] * factorial[i + derivative];
  }
  return result;
}

// What the terms leave out is 0 at 0, too: divided by s it is a mean of its derivative.
std::optional<std::array<Ball, 3>> Watched::quotient_at(double s, std::size_t derivative) const {
  if (watch_ == nullptr || !(s > 0) || !(s <= watch_->length)) {
    return std::nullopt;
  }
  const Stretch& here = stretch(0);
  const auto first = static_cast<Eigen::Index>(derivative) + 1;
  const auto later = [&](const auto& terms) { return without_first(terms, first); };
  std::array<Ball, 3> d = here.quick.size() > 0 ? derivatives<3>(later(here.quick), Ball(s), 3)
                                                : derivatives<3>(mapped(here.terms, later), Ball(s), 3);
  for (std::size_t i = 0; i < d.size(); ++i) {
    d[i] += within(Ball(here.rest[derivative + i + 1]) / Ball(static_cast<long>(i + 1)));
  }
  return d;
}

motion::DerivativeBounds Watched::bounds(std::size_t derivative) const {
  const motion::DerivativeBounds unknown{anything(), anything()};
  if (!covers_) {
    return unknown;
  }
  const std::size_t lowest = 3 + derivative;
  // Sums of positive numbers in double, each a little more than it is.
  constexpr double rounding = 1 + 1e-12;
  double third = 0, fourth = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const Stretch& here = stretch(k);
    Ball power(1);  // length^(m - lowest), which may be no double
    double of_third = here.rest[lowest], of_fourth = here.rest[lowest + 1];
    for (std::size_t m = lowest; m < static_cast<std::size_t>(here.most.size()); ++m) {
      double size = most(Ball(here.most(static_cast<Eigen::Index>(m))) * power);
      for (std::size_t i = 0; i < lowest; ++i) {
        size *= static_cast<double>(m - i);
      }
      of_third += size;
      of_fourth += size * static_cast<double>(m - lowest) / here.length;
      power *= Ball(here.length);
    }
    if (!std::isfinite(of_third) || !std::isfinite(of_fourth)) {
      return unknown;
    }
    third = std::max(third, of_third);
    fourth = std::max(fourth, of_fourth);
  }
  return {Ball(third * rounding + tiny), Ball(fourth * rounding + tiny)};
}

// Derivatives by the time as those by s.
template <class S>
std::array<S, 4> AffineCourse::seen(std::array<S, 4> d) const {
  int sign = sign_;
  for (S& number : d) {
    number *= S(sign);
    sign *= view_.direction;
  }
  return d;
}

std::array<Ball, 4> AffineCourse::at(double s) const {
  return seen(f_.at(Ball(view_.origin) + Ball(view_.direction * s), view_.derivative, offset_));
}

std::array<double, 4> AffineCourse::guess_at(double s) const {
  std::array<double, 4> d = seen(f_.guess_at(view_.origin + view_.direction * s, view_.derivative));
  d[0] += sign_ * offset_.c[0].approximate();
  return d;
}

std::array<Ball, 3> AffineCourse::quotient_at(double s) const {
  const bool is_whole = view_.origin == 0 && view_.direction == 1;
  auto d = is_whole ? f_.quotient_at(s, view_.derivative) : std::nullopt;
  for (std::size_t i = 0; d && i < d->size(); ++i) {
    d->at(i) *= Ball(sign_);
  }
  return d ? *d : Course::quotient_at(s);
}

using motion::Condition;
using motion::PhaseKind;
using motion::Touches;

namespace {

class Judge {
 public:
  Judge(std::vector<Condition>& list, const LinearPhases& phases,
        const model::FrictionOscillator<Rational>& exact, const JudgedPhase& phase)
      : list_(list),
        linear_(phases),
        exact_(exact),
        phase_(phase),
        forward_(phases, phase.piece, phase.begin, phase.duration, false),
        backward_(phases, phase.piece, phase.end, phase.duration, true),
        bounds_(forward_.bounds()) {}

  void stick() {
    constexpr const char * premise = "$r = ur$ at the end of the stick";
    along("stick.upper", "$r < ur$ while it sticks", -1,
          in_data([](const auto& o) { return o.forward.at_rest; }),
          {false, phase_.after && phase_.after->kind == PhaseKind::slip}, premise);
    along("stick.lower", "$r > -ur$ while it sticks", 1,
          in_data([](const auto& o) { return o.backward.at_rest; }),
          {false, phase_.after && phase_.after->kind == PhaseKind::overshoot}, premise);
  }

  void slide() {
    const Piece& piece = phase_.piece;
    const bool slips = piece.kind == PhaseKind::slip;
    const model::FrictionOscillator<Ball>& o = linear_.oscillator();
    const bool from_stick = phase_.before && phase_.before->kind == PhaseKind::stick;
    if (phase_.before && phase_.before->kind != piece.kind && !from_stick) {
      crossing(slips);
    }
    const auto number = static_cast<std::size_t>(piece.number);
    // Which neighbour is on the other side of the upper end of the piece; a phase of another kind is on that
    // of the lower one.
    const auto is_above = [&](const std::optional<Piece>& other) {
      return other && other->kind == piece.kind && other->number > piece.number;
    };
    const auto is_below = [&](const std::optional<Piece>& other) { return other && !is_above(other); };
    constexpr const char * premise =
        "the velocity of the belt or of the law's next piece at an end of the phase";
    const int side = piece.side();
    // side V minus the relative velocity at which a piece begins.
    const auto from_belt = [&](std::size_t one) {
      return in_data([&](const auto& all) { return all.V * Ball(side) - all.law(side).sliding[one].from; });
    };
    const model::FrictionLaw<Rational>& exact = exact_.law(side);
    const bool slowly = number == 0 && from_stick && exact.sliding.front().force == exact.at_rest;
    const double from = slowly ? leaves_slowly(side) : 0;
    along(slips ? "slip" : "overshoot",
          number == 0 ? (slips ? "$x' < V$ while it slips" : "$x' > V$ while it overshoots")
                      : fmt::format("the relative velocity is above that where piece {} begins", number + 1),
          -side, from_belt(number), {!slowly && is_below(phase_.before), is_below(phase_.after)}, premise,
          from);
    if (number + 1 < o.law(side).pieces()) {
      along(slips ? "slip.piece" : "overshoot.piece",
            fmt::format("the relative velocity is below that where piece {} begins", number + 2), side,
            from_belt(number + 1) * Ball(-1), {is_above(phase_.before), is_above(phase_.after)}, premise);
    }
  }

 private:
  void add(const char * id, const std::string& statement) {
    list_.push_back({id, statement, {}, {}, {}, {}});
    list_.back().at = phase_.start;
  }

  [[nodiscard]] InData<Ball> in_data(const auto& of) const { return linear_.number(of); }

  void along(const char * id, const std::string& statement, int sign, const InData<Ball>& offset,
             Touches touches, const char * premise, double from = 0) {
    add(id, statement);
    judge_along(list_.back(),
                {AffineCourse(forward_, sign, offset, {0, from, 1}), AffineCourse(backward_, sign, offset),
                 bounds_, phase_.start + Ball(from), phase_.duration - Ball(from), touches, premise, true});
  }

  void crossing(bool slips) {
    add("crossing", "$|r| > ur$ where a slip and an overshoot meet");
    InData<Ball> distance = mapped(linear_.watched({PhaseKind::stick}) * phase_.begin,
                                   [&](const Matrix& r) { return Ball(Ball(slips ? 1 : -1) * r(0, 0)); });
    distance -= in_data([&](const auto& o) { return o.law(slips ? 1 : -1).at_rest; });
    judge(list_.back(), distance.all(), true, "the distance");
    if (list_.back().verdict.truth == Truth::refuted) {
      list_.back().violation = motion::Violation{phase_.start, *list_.back().margin};
    }
  }

  // Where the friction drops by nothing the mass leaves the belt with x'' = 0: the distance grows as the
  // square of the time. Until the time that is returned its rate is judged in its place.
  double leaves_slowly(int side) {
    constexpr int parts = 64;
    const double T = phase_.duration.approximate();
    double turns = T / parts;
    while (turns < T && -side * forward_.guess_at(turns)[1] > 0) {
      turns += T / parts;
    }
    const double until = turns / 2;
    add("leaves", "the mass falls behind the belt, or gets ahead of it, faster and faster at first");
    const AffineCourse rate(forward_, -side, InData<Ball>(Ball(0)), {1, 0, 1});
    const AffineCourse reversed(forward_, -side, InData<Ball>(Ball(0)), {1, until, -1});
    judge_along(list_.back(), {rate,
                               reversed,
                               forward_.bounds(1),
                               phase_.start,
                               Ball(until),
                               {true, false},
                               "$r = ur$ at the end of the stick",
                               true});
    if (list_.back().verdict.truth == Truth::refuted) {
      list_.back().verdict = Verdict::undecided("its velocity turns early: " + list_.back().verdict.reason);
      list_.back().violation.reset();
    }
    return until;
  }

  std::vector<Condition>& list_;
  const LinearPhases& linear_;
  const model::FrictionOscillator<Rational>& exact_;
  const JudgedPhase& phase_;
  Watched forward_, backward_;  // what ends the phase
  motion::DerivativeBounds bounds_;
};

}  // namespace

void judge_phase(std::vector<Condition>& list, const LinearPhases& phases,
                 const model::FrictionOscillator<Rational>& exact, const JudgedPhase& phase) {
  list.push_back({"duration", "each phase lasts", {}, {}, {}, {}});
  list.back().at = phase.start;
  judge(list.back(), phase.duration, true, "the duration");
  Judge judge(list, phases, exact, phase);
  phase.piece.kind == PhaseKind::stick ? judge.stick() : judge.slide();
}

}  // namespace stickslip::numeric::machines
