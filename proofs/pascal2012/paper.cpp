#include "proofs/pascal2012/paper.hpp"

#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/examples/examples.hpp"
#include "proofs/pascal2012/met_by_orbits.hpp"
#include "proofs/pascal2012/source.hpp"
#include "proofs/text/claims_file.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace {

text::Programs programs() {
  text::Programs result{{{"values of S", values_of_S()},
                         {"orbit of S", orbit_of_S()},
                         {"orbit of O", orbit_of_O()},
                         {"origins of O", origins_of_O()},
                         {"values of P", values_of_P()},
                         {"orbit of P", orbit_of_P()},
                         {"attractors", attractors()},
                         {"met by orbits", met_by_orbits()}}};
  for (Proofs some :
       {derived_forms(), reduced(), frequencies(), data_of_S(), against_the_list_of_S(), zeros_of_16_at_S(),
        numbers_of_O(), spurious_zero(), data_of_P(), resonances(), longer_slip(), cycles()}) {
    result.proofs.merge(some);
  }
  return result;
}

Paper assembled() {
  Paper paper{bibliography(), {}, {}, printed_examples(), {}, {}, {}, {}, abbreviations()};
  std::string all;
  for (const auto& [file, claims] : claims_text()) {
    all += claims;
  }
  const text::Programs made = programs();
  paper = text::read_claims(all, "pascal2012", paper, &made);
  for (std::size_t i = 0; i < paper.sections.size(); ++i) {
    const std::string& file = claims_text().at(i).first;
    paper.sections[i].program = file.substr(0, file.find('.'));
  }
  for (Claim& claim : paper.claims) {
    if (claim.id.find(".if.") != std::string::npos && is_stated(paper, claim.id)) {
      claim.origin = Origin::paper;  // a condition that the paper names for its example
    }
    if (const std::string lost = lost_in_source(claim.id); !lost.empty()) {
      claim.illegible = claim.illegible.empty() ? lost : lost + ", " + claim.illegible;
    }
  }
  return paper;
}

}  // namespace

const Bibliography& bibliography() {
  static const Bibliography printed{
      "M. Pascal", "New limit cycles of dry friction oscillators under harmonic load",
      "Nonlinear Dynamics 70 (2012) 1435–1443", "10.1007/s11071-012-0545-5",
      "The text read is that of HAL, whose file has lost glyphs; where a formula quoted here has lost "
      "some, these are named, and the printed page should be looked at."};
  return printed;
}

const Paper& paper() {
  static const Paper once = assembled();
  return once;
}

}  // namespace stickslip::proofs::pascal2012
