#include "numeric/machines/phases/numbers_in_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "core/domain.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::machines {

namespace {

std::size_t place_of_product(std::size_t j, std::size_t k) {
  return j < k ? k * (k - 1) / 2 + j : j * (j - 1) / 2 + k;
}

// Whether the loads are the same but for their sizes.
bool have_same_loads(const model::FrictionOscillator<Rational>& a,
                     const model::FrictionOscillator<Rational>& b) {
  return std::ranges::equal(a.loads, b.loads, [](const auto& one, const auto& other) {
    return one.mass == other.mass && one.k == other.k;
  });
}

// Whether friction at rest and the first one when sliding are equal, at both sides.
std::pair<bool, bool> drops(const model::FrictionOscillator<Rational>& o) {
  const auto drops = [](const model::FrictionLaw<Rational>& law) {
    return law.sliding.front().force != law.at_rest;
  };
  return {drops(o.forward), drops(o.backward)};
}

// Whether the laws are smooth, and fall, alike.
bool are_alike(const model::FrictionLaw<Rational>& a, const model::FrictionLaw<Rational>& b) {
  return a.sliding.size() == b.sliding.size() && a.smooth.has_value() == b.smooth.has_value() &&
         (!a.smooth || a.smooth->fall == b.smooth->fall);
}

bool have_same_shape(const model::FrictionOscillator<Rational>& a,
                     const model::FrictionOscillator<Rational>& b) {
  return a.size() == b.size() && a.rubbing == b.rubbing && have_same_loads(a, b) && drops(a) == drops(b) &&
         are_alike(a.forward, b.forward) && are_alike(a.backward, b.backward);
}

// f of each two.
template <class F>
Values each(const Values& a, const Values& b, const F& f) {
  Values result;
  std::ranges::transform(a, b, std::back_inserter(result), f);
  return result;
}

}  // namespace

ValuesInBox ValuesInBox::between(const Values& low, const Values& high) {
  return {each(low, high, [](const Rational& a, const Rational& b) { return Rational((a + b) / 2); }),
          each(low, high, [](const Rational& a, const Rational& b) { return Rational((b - a) / 2); })};
}
Values ValuesInBox::at(const Values& s) const {
  return each(middle, each(s, half, std::multiplies<Rational>()), std::plus<Rational>());
}
Values ValuesInBox::s_of(const Values& values) const {
  return each(each(values, middle, std::minus<Rational>()), half, std::divides<Rational>());
}

// Coordinates 0, 1, -1, 1/2, in this order, of the points (s_1, s_2, …): the places of all are together at
// most three. A polynomial of the third degree that is 0 at all of them is 0.
class NumbersInData::Points {
 public:
  explicit Points(std::size_t data) : data_(data) { add(std::vector<int>(data, 0), 0, highest_degree); }

  [[nodiscard]] const std::vector<Values>& all() const { return all_; }

  // A sum of products with these values, or else a quotient of linear functions.
  [[nodiscard]] std::optional<Quotient> through(const Values& values) const {
    const Quotient polynomial = polynomial_through(values);
    if (holds(polynomial, values)) {
      return polynomial;
    }
    const Quotient quotient = quotient_through(values);
    return holds(quotient, values) ? std::optional(quotient) : std::nullopt;
  }

 private:
  void add(std::vector<int> places, std::size_t from, std::size_t left) {
    static const Values coordinates{0, 1, -1, Rational(1, 2)};
    numbers_[places] = all_.size();
    std::ranges::transform(places, std::back_inserter(all_.emplace_back()),
                           [](int place) { return coordinates[static_cast<std::size_t>(place)]; });
    for (std::size_t k = from; k < data_; ++k) {
      for (std::size_t place = 1; place <= left; ++place) {
        std::vector<int> more = places;
        more[k] = static_cast<int>(place);
        add(more, k + 1, left - place);
      }
    }
  }
  [[nodiscard]] const Rational& at(const Values& values,
                                   const std::vector<std::pair<std::size_t, int>>& of) const {
    std::vector<int> places(data_, 0);
    for (const auto& [k, place] : of) {
      places[k] = place;
    }
    return values[numbers_.at(places)];
  }

  [[nodiscard]] bool holds(const Quotient& q, const Values& values) const {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const Rational bottom = q.bottom(all_[i]);
      if (bottom == 0 || q.top(all_[i]) != values[i] * bottom) {
        return false;
      }
    }
    return !has_poles(q);
  }
  [[nodiscard]] Quotient polynomial_through(const Values& values) const {
    Quotient q{values[0], {}, {}, {}};
    if (std::ranges::all_of(values, [&](const Rational& x) { return x == q.constant; })) {
      return q;
    }
    for (std::size_t k = 0; k < data_; ++k) {
      q.linear.emplace_back(at(values, {{k, 1}}) - q.constant);
      for (std::size_t j = 0; j < k; ++j) {
        q.products.emplace_back(at(values, {{j, 1}, {k, 1}}) - q.constant - q.linear[j] - q.linear[k]);
      }
    }
    return q;
  }
  // With f(0) = a, f(s) (1 + d s) = a + b s along each s_k: at 1 and -1 that is b = f(1) (1 + d) - a and
  // d (f(1) - f(-1)) = 2 a - f(1) - f(-1). Where f is a there, b = a d; then 1 + d_j + d_k times f at s_j =
  // s_k = 1 tells d_k, if f changes along s_j.
  [[nodiscard]] Quotient quotient_through(const Values& values) const {
    const Rational& a = values[0];
    Quotient q{a, Values(data_), {}, Values(data_)};
    std::vector<std::size_t> changing;
    for (std::size_t k = 0; k < data_; ++k) {
      const Rational &high = at(values, {{k, 1}}), &low = at(values, {{k, 2}});
      if (high != low) {
        q.below[k] = (2 * a - high - low) / (high - low);
        q.linear[k] = high * (1 + q.below[k]) - a;
        changing.push_back(k);
      }
    }
    for (std::size_t k = 0; k < data_; ++k) {
      for (const std::size_t j : changing) {
        const Rational& both = at(values, {{j, 1}, {k, 1}});
        if (std::ranges::find(changing, k) == changing.end() && both != a) {
          q.below[k] = (a + q.linear[j] - both * (1 + q.below[j])) / (both - a);
          q.linear[k] = a * q.below[k];
          break;
        }
      }
    }
    return q;
  }

  std::size_t data_;
  std::vector<Values> all_;
  std::map<std::vector<int>, std::size_t> numbers_;  // of points, by the places of their coordinates
};

Rational NumbersInData::Quotient::top(const Values& s) const {
  Rational sum = constant;
  for (std::size_t k = 0; k < linear.size(); ++k) {
    Rational factor = linear[k];
    for (std::size_t j = 0; j < k && !products.empty(); ++j) {
      factor += products[place_of_product(j, k)] * s[j];
    }
    sum += factor * s[k];
  }
  return sum;
}

Rational NumbersInData::Quotient::bottom(const Values& s) const {
  Rational sum = 1;
  for (std::size_t k = 0; k < below.size(); ++k) {
    sum += below[k] * s[k];
  }
  return sum;
}

bool NumbersInData::has_poles(const Quotient& q) {
  Rational least = 1;
  for (const Rational& x : q.below) {
    least -= abs(x);
  }
  return least <= 0;
}

InData<Ball> NumbersInData::Quotient::over(const ValuesInBox& part) const {
  const auto& [middle, half] = part;
  const std::size_t data = middle.size();
  InData<Ball> f(Ball(top(middle)));
  if (!linear.empty()) {
    f.c.resize(monomials(data));
  }
  for (std::size_t k = 0; k < linear.size(); ++k) {
    Rational slope = linear[k];
    for (std::size_t j = 0; j < data && !products.empty(); ++j) {
      if (j != k) {
        slope += products[place_of_product(j, k)] * middle[j];
      }
      if (j < k) {
        const Monomial both{{0, j + 1, k + 1}};
        f.c[both.place()] = Ball(Rational(products[place_of_product(j, k)] * half[j] * half[k]));
      }
    }
    f.c[place_of(k + 1)] = Ball(Rational(slope * half[k]));
  }
  if (below.empty()) {
    return f;
  }
  InData<Ball> g(Ball(bottom(middle)));
  g.c.resize(monomials(data));
  for (std::size_t k = 0; k < data; ++k) {
    g.c[place_of(k + 1)] = Ball(Rational(below[k] * half[k]));
  }
  return f * reciprocal(g);
}

NumbersInData::NumbersInData(const std::function<Machine(const Values&)>& at, const Values& low,
                             const Values& high) {
  const std::size_t data = low.size();
  require(data > 0 && data <= most_data, "the data of a box", fmt::format("{} of them", data),
          fmt::format("1 to {}", most_data));
  box_ = ValuesInBox::between(low, high);
  const auto machine_at = [&](const Values& s) {
    Machine machine = at(box_.at(s));
    require_machine(machine);
    return machine;
  };
  for (std::size_t corner = 0; corner < (std::size_t{1} << data); ++corner) {
    Values s(data);
    for (std::size_t k = 0; k < data; ++k) {
      s[k] = (corner >> k) % 2 == 0 ? -1 : 1;
    }
    (void)machine_at(s);
  }
  const Points points(data);
  std::vector<Machine> machines;
  for (const Values& s : points.all()) {
    Machine& machine = machines.emplace_back(machine_at(s));
    for (auto * law : {&machine.oscillator.forward, &machine.oscillator.backward}) {
      if (law->smooth) {  // the pieces near it are no part of what is proved
        law->sliding = {{0, law->smooth->first, 0}};
      }
    }
  }
  find(machines, points);
}

// What machines are in order by their numbers at the corners are so in between: a number is monotone with
// each datum. So is the difference of two polynomials; those that the law compares have to be such. That the
// law's pieces meet is, with the pieces' slopes, a polynomial of the third degree that is 0. A load's
// multiple that is the same at all points is so at all, for then its frequency is the only one that varies,
// or all do.
void NumbersInData::find(const std::vector<Machine>& machines, const Points& points) {
  const auto& in_middle = machines.front().oscillator;
  const char * const others = "a number of the machine is no quotient of linear functions of the data";
  std::vector<Values> numbers;  // of all points
  for (const Machine& machine : machines) {
    if (!have_same_shape(machine.oscillator, in_middle)) {
      why_not_ = "the machine changes its shape with the data";
      return;
    }
    Values& at_point = numbers.emplace_back();
    (void)model::mapped<Rational>(machine.oscillator,
                                  [&](const Rational& x) { return at_point.emplace_back(x); });
  }
  std::size_t number = 0;
  in_turns_ = machines.front().in_turns;
  oscillator_ = model::mapped<Quotient>(in_middle, [&](const Rational&) {
    Values values;
    std::ranges::transform(numbers, std::back_inserter(values),
                           [&](const Values& at_point) { return at_point[number]; });
    ++number;
    const auto found = points.through(values);
    why_not_ = found ? why_not_ : others;
    return found.value_or(Quotient{});
  });
  for (const auto * law : {&oscillator_.forward, &oscillator_.backward}) {
    const auto is_polynomial = [](const Quotient& q) { return q.below.empty(); };
    const bool all = is_polynomial(law->at_rest) && std::ranges::all_of(law->sliding, [&](const auto& piece) {
                       return is_polynomial(piece.from) && is_polynomial(piece.force);
                     });
    why_not_ = all ? why_not_ : others;
  }
}

OscillatorInData NumbersInData::over(const ValuesInBox& part) const {
  const ValuesInBox of_s{box_.s_of(part.middle), each(part.half, box_.half, std::divides<Rational>())};
  auto numbers = model::mapped<InData<Ball>>(oscillator_, [&](const Quotient& q) { return q.over(of_s); });
  if (in_turns_) {
    numbers.omega = numbers.omega * (Ball(2) * Ball::pi());
  }
  return {part.half.size(), numbers};
}

}  // namespace stickslip::numeric::machines
