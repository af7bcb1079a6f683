#include "numeric/branches/resonance.hpp"

#include <fmt/format.h>

#include <cmath>

#include "numeric/atlas/symmetric_orbit.hpp"
#include "numeric/branches/setting.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::branches {

using namespace motion;
using namespace zeros;

namespace {

// A time is the first variable, the branch's parameter the second.
using Form = scalars::Form<Ball, 2>;
using Orbit = atlas::SymmetricOrbit<Form>;

// How short pieces of a phase are looked at, as shares of it.
constexpr double least_piece = 0x1p-12;

std::optional<Orbit> orbit_of(const ParametricProof& proof, const MotionOf<ParameterJet>& jets,
                              const Motion& middle) {
  const Ball radius = abs(proof.spread(0)).upper();
  const auto form = [&](const ParameterJet& g, const Ball& at_middle) {
    Form x;
    x.at = at_middle;
    x.over = proof.over_box(g, at_middle);
    x.slopes[1] = g.partial(0) * radius;
    return x;
  };
  const model::Parameters<ParameterJet>& a = jets.oscillator.data;
  const model::Parameters<Ball>& b = middle.oscillator.data;
  const model::Parameters<Form> data{form(a.chi, b.chi), form(a.eta, b.eta),     form(a.us, b.us),
                                     form(a.V, b.V),     form(a.omega, b.omega), form(a.p, b.p)};
  const Form pi(Ball::pi());
  const Form tau = form(jets.phases[0].duration, middle.phases[0].duration);
  const Ball at_half = middle.phases[0].load + b.omega * middle.phases[0].duration / Ball(2);
  const int sign = sin(at_half).is_positive() ? 1 : -1;
  return Orbit::at({atlas::Sheet::Kind::symmetric, sign}, atlas::setting_of<Form>(data, pi),
                   Form(tau * data.omega / Form(Form(2) * pi)), {});
}

}  // namespace

bool is_near_resonance(const Motion& motion) {
  const model::Modes<Ball>& m = motion.oscillator.modes;
  const double omega = motion.oscillator.data.omega.approximate();
  return std::abs(m.omega1.approximate() / omega - 1) < 0.01 ||
         std::abs(m.omega2.approximate() / omega - 1) < 0.01;
}

void decide_without_response(const ParametricProof& proof, const MotionOf<ParameterJet>& jets,
                             const Motion& middle, const Requirements& requirements,
                             std::vector<Condition>& conditions) {
  const std::optional<Orbit> orbit = orbit_of(proof, jets, middle);
  if (!orbit || conditions.size() != requirements.size()) {
    return;
  }
  std::vector<Condition> decided = conditions;
  bool all = true;
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    if (conditions[k].verdict.truth != Truth::undecided) {
      continue;
    }
    atlas::Times open{{0, 1}};
    const Truth truth = orbit->holds(requirements[k], least_piece, open).truth;
    if (truth == Truth::refuted) {
      conditions[k].verdict = Verdict::refuted("some time has a negative distance");
      return;
    }
    all = all && truth == Truth::proved;
    decided[k].verdict = Verdict::proved();  // perhaps because it follows from the others
  }
  if (all) {
    conditions = decided;
  }
}

namespace {

constexpr int most_stretches = 1 << 14;

// A frequency of the free motion, of which the multiples of omega from k = least on are left out.
struct Frequency {
  const char * name;
  Ball (*of)(const model::Modes<Ball>& modes);
  double least;
};

// Where the family's equations are singular, and how near to it, relatively, they are not looked into.
struct Singular {
  std::vector<Frequency> frequencies;
  double nearness;
};

Singular singular(const OrbitQuestion& orbits) {
  constexpr double narrow = 0x1p-17, wide = 0x1p-11;
  const families::Family& family = *orbits.family;
  std::vector<Frequency> all;
  if (const double least = family.first_singular; least > 0) {
    all = {{"omega1", [](const model::Modes<Ball>& m) { return m.omega1; }, least},
           {"omega2", [](const model::Modes<Ball>& m) { return m.omega2; }, least}};
  }
  if (family.is_singular_with_m1) {
    all.push_back({"1", [](const model::Modes<Ball>&) { return Ball(1); }, 1});
  }
  return {all, has_stick(family) && orbits.ur ? wide : narrow};
}

class Finder {
 public:
  explicit Finder(const BranchQuestion& question)
      : question_(question),
        singular_(singular(question.orbits)),
        curve_(curve_of(question, families::NonstickingClosing{})) {}

  std::vector<Multiple> run() {
    look(question_.from, question_.to);
    if (looks_ > most_stretches ||
        (found_.size() == 1 && found_[0].from == question_.from && found_[0].to == question_.to)) {
      return {};
    }
    std::vector<Multiple> all;
    for (const Near& one : found_) {
      const char * name = singular_.frequencies[one.place].name;
      all.push_back({one.k == 1 ? fmt::format("omega = {}", name) : fmt::format("{} omega = {}", one.k, name),
                     one.from, one.to, zero(one)});
    }
    return all;
  }

 private:
  struct Near {
    Rational from, to;
    std::size_t place;  // of the frequency
    double k;
  };

  // Of the frequencies to omega.
  [[nodiscard]] std::vector<Ball> ratios(const Ball& value) const {
    const zeros::Vector p = curve_.data_at(value);
    const model::Modes<Ball> m = model::modes<Ball>(p(0), p(1));
    std::vector<Ball> all;
    for (const Frequency& frequency : singular_.frequencies) {
      all.push_back(frequency.of(m) / p(4));
    }
    return all;
  }

  // Adds what is near in these parts of the interval, from the left to the right.
  void look(const Rational& from, const Rational& to) {
    if (++looks_ > most_stretches) {
      return;
    }
    const std::vector<Ball> ratio = ratios(between(from, to));
    const double nearness = singular_.nearness;
    bool is_free = true;
    for (std::size_t place = 0; place < ratio.size(); ++place) {
      const auto [low, high] = scalars::ends(ratio[place]);
      const double k = std::max(singular_.frequencies[place].least, std::ceil(low / (1 + nearness)));
      if (k <= high / (1 - nearness)) {
        if (high - low < k * nearness / 2) {
          return add({from, to, place, k});
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
    if (!found_.empty() && found_.back().to == one.from && found_.back().place == one.place &&
        found_.back().k == one.k) {
      found_.back().to = one.to;
    } else {
      found_.push_back(one);
    }
  }

  // Bisected as far as the signs are known.
  [[nodiscard]] std::optional<Ball> zero(const Near& one) const {
    const auto sign = [&](const Rational& value) {
      return scalars::sign_of(Ball(ratios(Ball(value))[one.place] - Ball(one.k)));
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
  Singular singular_;
  Curve curve_;
  int looks_ = 0;
  std::vector<Near> found_;
};

}  // namespace

std::vector<Multiple> multiples_in(const BranchQuestion& question) {
  return question.word || singular(question.orbits).frequencies.empty() ? std::vector<Multiple>{}
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
