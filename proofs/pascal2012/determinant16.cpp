// (16) as linear equations for z1(0), z2(0) and z1'(0): where their determinant vanishes, and where that is
// an orbit.
#include "proofs/pascal2012/determinant16.hpp"
#include "proofs/methods/implications.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace determinant16;

Term entry_of(const Term& matrix, int row, int column) {
  const auto unit = [](int which) {
    std::vector<Term> entries(4, Term(0));
    entries[static_cast<std::size_t>(which)] = 1;
    return entries;
  };
  return block(1, unit(row)) * matrix * symbols::column(unit(column));
}
const Term unknowns = column({z10, z20, zdot10, 1});

std::vector<Claim> factors() {
  const Term cosines = block(2, {Lambda * diagonal(2 * cos(alpha1) / omega1, 2 * cos(alpha2) / omega2),
                                 zero(2, 2), zero(2, 2), Sigma * diagonal(2 * cos(half_T), 1)});
  const Term common = 8 * (lambda2 - lambda1) / (omega1 * omega2) * cos(alpha1) * cos(alpha2) * cos(half_T);
  return {
      {.id = "16.rows",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(of_16, cosines * of_halves)},
       .words = "each equation of (16), mode by mode, has a cosine for a factor",
       .prove = by_normal_form()},
      {.id = "16.det",
       .kind = Kind::theorem,
       .origin = Origin::new_result,
       .printed = {equation(determinant(of_16), common * determinant(of_halves))},
       .words =
           "the determinant of (16), as equations for $z_1(0)$, $z_2(0)$, $z_1'(0)$, vanishes with each of "
           "$cos(omega_1 tau/2)$, $cos(omega_2 tau/2)$ and $cos(T/2)$, whatever the load, and otherwise "
           "with that of the equations without these factors",
       .prove = by_normal_form()},
  };
}

// The cofactors of the last column: with the unknowns' 1 in the last place they make the determinant.
Term cofactors(const Term& matrix) {
  std::vector<Term> row;
  for (int left_out = 0; left_out < 4; ++left_out) {
    std::vector<Term> entries;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; i != left_out && j < 3; ++j) {
        entries.push_back(entry_of(matrix, i, j));
      }
    }
    const Term minor = determinant(block(3, entries));
    row.push_back(left_out % 2 == 0 ? -minor : minor);
  }
  return block(1, row);
}

std::vector<Claim> necessity() {
  const Term slip = diagonal(omega1 * cos(alpha1) / 2, omega2 * cos(alpha2) / 2) * inverse(Lambda),
             slip_speed = -diagonal(sin(alpha1) / 2, sin(alpha2) / 2) * inverse(Lambda),
             stick = -diagonal(cos(half_T) / 2, 1) * inverse(Sigma),
             stick_speed = diagonal(sin(half_T) / 2, 0) * inverse(Sigma), nothing = zero(2, 2);
  const Assumption slip16{
      "16.slip",
      equation((H1(tau) + I2) * (z0 - slip_load) + H2(tau) * (zdot0 + slip_load_speed), zero(2, 1))},
      stick16{"16.stick", equation((Gamma1(T) + I2) * z0 - Gamma2(T) * zdot0, zero(2, 1))};
  const std::vector<Assumption> orbit{time_lag,  slips_below,      begins,    slip_takes_time,
                                      slip_ends, starts_with_belt, stick_ends};
  return {
      {.id = "16.zeros",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(determinant(of_16), 0)},
       .words = "(16) has solutions only where its determinant vanishes",
       .assumptions = {starts_with_belt, slip16, stick16},
       .prove = by_combination({{{assuming("16.slip"), 0, cofactors(of_16) * column({I2, zero(2, 2)})},
                                 {assuming("16.stick"), 0, cofactors(of_16) * column({zero(2, 2), I2})}}})},
      {.id = "16.halves",
       .kind = Kind::step,
       .origin = Origin::auxiliary,
       .printed = {equation(of_halves * unknowns, zero(4, 1))},
       .words = "(13) and (15) give the equations (16) without the cosines",
       .assumptions = orbit,
       .prove = by_combination({{{from("13.slip"), 0, block(2, {slip, slip_speed, nothing, nothing})},
                                 {assuming("15"), 0, block(2, {nothing, nothing, stick, stick_speed})}}})},
      {.id = "16.orbits",
       .kind = Kind::theorem,
       .origin = Origin::new_result,
       .printed = {equation(determinant(of_halves), 0)},
       .words = "so an orbit needs a zero of the last factor of 16.det: where only a cosine is zero, the "
                "determinant of (16) vanishes and there is no orbit",
       .assumptions = orbit,
       .prove = by_combination({{{from("16.halves"), 0, cofactors(of_halves)}}})},
  };
}

}  // namespace

std::vector<Claim> determinant_of_16() {
  return joined({factors(), necessity(), {zeros_of_16_at_S()}});
}

}  // namespace stickslip::proofs::pascal2012
