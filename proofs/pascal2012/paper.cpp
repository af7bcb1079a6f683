#include "proofs/pascal2012/paper.hpp"

#include "proofs/pascal2012/abbreviations.hpp"
#include "proofs/pascal2012/examples.hpp"
#include "proofs/pascal2012/judgement.hpp"
#include "proofs/pascal2012/remarks.hpp"
#include "proofs/pascal2012/source.hpp"
#include "proofs/pascal2012/statements.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

namespace {

struct Part {
  Section section;
  std::vector<Claim> (*claims)();
};

std::vector<Part> parts() {
  return {
      {{"sec2", "Section 2: the model", "section2"}, section2},
      {{"sec3", "Section 3: closed-form phases", "section3"}, section3},
      {{"sec4", "Section 4: symmetric orbits", "section4"}, section4},
      {{"sec5", "Section 5: orbits with an overshooting part", "section5"}, section5},
      {{"sec6", "Section 6: orbits that never stick", "section6"}, section6},
      {{"sec7", "Abstract and conclusion", "section7"}, section7},
      {{"A1", "Appendix 1: modes, H and Gamma", "appendix1"}, appendix1},
      {{"A2", "Appendix 2: the symmetry of the orbits of Section 4", "appendix2"}, appendix2},
      {{"A3", "Appendix 3: the coefficients of (21)", "appendix3"}, appendix3},
      {{"A4", "Appendix 4: the symmetry of the orbits of Section 6", "appendix4"}, appendix4},
      {{"A5", "Appendix 5: two transitions per period", "appendix5"}, appendix5},
      {{"red", "The equations that the proofs of orbits solve", "reduced"}, reduced},
  };
}

Paper assembled() {
  Paper paper{{"M. Pascal", "New limit cycles of dry friction oscillators under harmonic load",
               "Nonlinear Dynamics 70 (2012) 1435–1443", "10.1007/s11071-012-0545-5"},
              {},
              {},
              printed_examples(),
              judgements(),
              printed_statements(),
              remarks(),
              results(),
              abbreviations()};
  for (const Part& part : parts()) {
    paper.sections.push_back(part.section);
    for (Claim& claim : part.claims()) {
      claim.place = part.section.id;
      if (const std::string lost = lost_in_source(claim.id); !lost.empty()) {
        claim.illegible = claim.illegible.empty() ? lost : lost + ", " + claim.illegible;
      }
      paper.claims.push_back(std::move(claim));
    }
  }
  return paper;
}

}  // namespace

const Paper& paper() {
  static const Paper once = assembled();
  return once;
}

}  // namespace stickslip::proofs::pascal2012
