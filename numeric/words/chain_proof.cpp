#include "numeric/words/chain_proof.hpp"

#include <algorithm>
#include <optional>

#include "numeric/words/sweep.hpp"
#include "numeric/zeros/krawczyk.hpp"

namespace stickslip::numeric::words {

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
  explicit Chains(const ChainAt& chain_at) : chain_at_(chain_at) {}

  [[nodiscard]] const Chain& now() {
    if (bits_ != WorkingPrecision::bits()) {
      chain_ = chain_at_();
      bits_ = WorkingPrecision::bits();
    }
    return *chain_;
  }

 private:
  const ChainAt& chain_at_;
  long bits_ = 0;
  std::unique_ptr<Chain> chain_;
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

ChainProof newton_test(const ChainAt& chain_at, const Nodes& m, long exponent) {
  return test(*chain_at(), m, exponent);
}

ChainProof prove_chain(const ChainAt& chain_at, const Nodes& guess, long bits, long most_bits) {
  ChainProof proof = open("Newton's method leads to no closed motion from there");
  Nodes nodes = guess;
  Chains chains(chain_at);
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

}  // namespace stickslip::numeric::words
