// The orbits of Figs. 2, 3 and 4 obey what claims assume: their theorems are of something.
#include "proofs/pascal2012/met_by_orbits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <sstream>

#include "proofs/methods/prover.hpp"
#include "proofs/methods/refutation.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace {

Claim claim_of(const std::string& id, const std::string& what, const std::vector<std::string>& ids,
               const Proof& prove) {
  return {.id = id,
          .kind = methods::Kind::numbers,
          .origin = Origin::auxiliary,
          .words = fmt::format("{} obeys all at once that these claims assume, which are of something: {}",
                               what, fmt::join(ids, ", ")),
          .prove = prove,
          .meets = ids};
}

Claim claim_of(const std::string& id, const Met& met) {
  return claim_of(id, "the orbit of " + example_of(met).figure + ", as one motion,", met.ids,
                  [met](Prover& prover, const Claim&) {
                    std::set<std::string> uses(met.premises.begin(), met.premises.end());
                    uses.insert(met.example + ".motion");
                    return proved_by(at_the_data(example_of(met), "each assumption, from what " +
                                                                      met.example + ".motion says"),
                                     uses, [&] { return met_theorem(prover, met); });
                  });
}

// The motion (34) of two slips of half a period each, under a load of any size and phase.
std::vector<symbols::Statement> half_periods() {
  using namespace symbols::vocabulary;
  using symbols::equation;
  const symbols::Term speed1 = -q1 * omega * sin(phi) - a1 * d01 - a2 * d02,
                      speed2 = -q2 * omega * sin(phi) - b1 * d01 - b2 * d02;
  return {equation(tau, symbols::pi() / omega),
          equation(tau1, symbols::pi() / omega),
          equation(Theta, 2 * symbols::pi() / omega),
          equation(phi, -symbols::pi() / 2),
          equation(z10, q1 * cos(phi) - d01),
          equation(z20, q2 * cos(phi) - d02),
          equation(zdot10, speed1),
          equation(zdot20, speed2),
          equation(z1B, -q1 * cos(phi) - d01),
          equation(z2B, -q2 * cos(phi) - d02),
          equation(zdot1B, -speed1),
          equation(zdot2B, -speed2)};
}

// Where the motion has a closed form, no orbit is needed: values are given.
Claim claim_of(const std::string& id, const std::string& words, const std::vector<std::string>& ids,
               const Scene& scene) {
  return claim_of(id, words, ids, [ids, scene](Prover& prover, const Claim&) {
    return proved_by({.route = "values, and the motion in closed form"}, {}, [&] {
      std::vector<symbols::Statement> holding;
      for (const std::string& one : ids) {
        for (const Assumption& assumption : prover.claim(one).assumptions) {
          holding.push_back(assumption.statement);
        }
      }
      return refutation(prover, scene, holding, {});
    });
  });
}

}  // namespace

std::vector<Claim> met_by_orbits() {
  using namespace symbols::vocabulary;
  const auto ids = [](const std::string& words) {
    std::istringstream stream(words);
    return std::vector<std::string>{std::istream_iterator<std::string>(stream), {}};
  };
  // All that moves is at rest at the time 0 under the friction that the load asks for.
  const symbols::Term friction = -p / eta * cos(phi), tenth = symbols::Term(1) / 10;
  const symbols::Replacements units{{"m1", 4},
                                    {"m2", 1},
                                    {"k1", 7 * tenth},
                                    {"k2", 3 * tenth},
                                    {"Omega", 5 * tenth},
                                    {"ttilde", 0},
                                    {"x1", 0},
                                    {"x2", 0},
                                    {"xddot1", 0},
                                    {"xddot2", 0},
                                    {"u", friction},
                                    {"Ftilde", friction},
                                    {"omegatilde", 3 * tenth},
                                    {"ptilde", p / 4}};
  return {
      claim_of("S.meets",
               {.example = "S",
                .ids = ids("12 12.back 12.begins 24 24.back 4.f.end 14 4.sticking 13.gap 13.follows"),
                .at_the_last_phase = true}),
      claim_of("S.meets.13", {"S", ids("13 13.slip 4.lag.needed 15 17.slip"), {"13.follows"}}),
      claim_of("S.meets.15",
               {"S", ids("16 16.halves 16.orbits 46.period 17.stick 17.odd"), {"13.follows", "15"}}),
      claim_of("S.meets.16", {"S", ids("16.back 16.zeros"), {"13.follows", "15", "16"}}),
      claim_of(
          "S.meets.45",
          {.example = "S", .ids = {"45"}, .premises = {"13.follows", "15", "16"}, .at_the_last_phase = true}),
      claim_of("O.meets",
               {.example = "O",
                .ids = ids("18 18.back 18.begins 20.slips 20.sticking 20 20.C 21.gap 18.speed 19.speed 21"),
                .at_the_last_phase = true}),
      claim_of("O.meets.20", {.example = "O", .ids = ids("20.back"), .premises = {"20.C"}}),
      claim_of("O.meets.21", {.example = "O", .ids = ids("21.back 22 23"), .premises = {"21"}}),
      claim_of("O.meets.22", {.example = "O", .ids = ids("23.back"), .premises = {"21", "22", "23"}}),
      claim_of("P.meets",
               {.example = "P",
                .ids = ids(
                    "2 3.domain 4.r 4.slips 25 26 25.begins 26.begins 36.load 36.square "
                    "55.B 56 56.B 57 60 62 63 64 65 65.modes 65.sharp 66 67 67.sin A5.turn A5.falls A5.down "
                    "A5.cos A5.difference A5.free "
                    "A5.half A5.second A5.theorem A5.energy A5.stable A5.sides A5.moves A5.unique "
                    "7.symmetric 7.always"),
                .values = units}),
      claim_of("P.meets.half",
               {.example = "P",
                .ids = ids("28 28.B 29 30 30.back 31 31.modes 32 33 33.symmetry 33.V 34.H 34 35 36 36.26 "
                           "36.back 35.bound "
                           "37 37.sharp 37.sharp.back 37.speed 52 53.X 54 68 69 69.X 69.motion A5.regular "
                           "A5.mirror A5.symmetry 28.reduced 28.poles"),
                .premises = {"A5.half", "A5.second"},
                .values = {{"delta", 1}},
                .goes_on_to = 3 * Theta / 2}),
      // Times of the slip at which x2' would be positive without the load's push, and would not.
      claim_of("P.meets.slip", {.example = "P",
                                .ids = ids("37.slip 37.slip.back"),
                                .premises = {"A5.half", "A5.second"},
                                .values = {{"t", 1}}}),
      claim_of("P.meets.free", {.example = "P", .ids = ids("37.slip.free"), .values = {{"t", 4}}}),
      claim_of("P.meets.35", {.example = "P", .ids = ids("33.even.start"), .premises = {"A5.half", "35"}}),
      claim_of("V.meets", {.example = "V", .ids = {"A5.longer"}}),
      claim_of("P.meets.63", {.example = "P", .ids = ids("64.back"), .premises = {"63", "64"}}),
      claim_of("17.meets", "rest at $delta_0$, under the friction $u_s$, without a load,", ids("17.free"),
               {.point = {{"tau", 1}, {"Theta", 2}, {"t", 1}, {"t1", 1}},
                .values = {symbols::equation(p, 0), symbols::equation(T, Theta - tau)},
                .state = 0}),
      // The first case of (67) is impossible where x2' < V within the slip (67.impossible): here it is not.
      claim_of("67.meets",
               "a motion (34) with $phi = -pi/2$, which passes the belt's velocity within its phases,",
               ids("67.first 67.opposite"),
               {.point = {{"omega1", Rational(2, 3)}, {"omega2", Rational(12, 5)}, {"omega", Rational(1, 2)}},
                .values = half_periods()}),
  };
}

}  // namespace stickslip::proofs::pascal2012
