#include "proofs/pascal2012/paper.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;

const std::vector<Place>& places() {
  static const std::vector<Place> all{
      {"sec2", "Section 2: the model", "section2", section2},
      {"sec3", "Section 3: closed-form phases", "section3", section3},
      {"sec4", "Section 4: symmetric orbits", "section4", section4},
      {"sec5", "Section 5: orbits with an overshooting part", "section5", section5},
      {"sec6", "Section 6: orbits that never stick", "section6", section6},
      {"sec7", "Abstract and conclusion", "section7", section7},
      {"A1", "Appendix 1: modes, H and Gamma", "appendix1", appendix1},
      {"A2", "Appendix 2: the symmetry of the orbits of Section 4", "appendix2", appendix2},
      {"A3", "Appendix 3: the coefficients of (21)", "appendix3", appendix3},
      {"A4", "Appendix 4: the symmetry of the orbits of Section 6", "appendix4", appendix4},
      {"A5", "Appendix 5: two transitions per period", "appendix5", appendix5},
      {"red", "The equations that the proofs of orbits solve", "reduced", reduced},
  };
  return all;
}

std::vector<Claim> paper() {
  std::vector<Claim> all;
  for (const Place& place : places()) {
    for (Claim& claim : place.claims()) {
      all.push_back(std::move(claim));
    }
  }
  return all;
}

std::set<std::string> ids_named(const std::vector<Claim>& claims, const std::string& word) {
  std::set<std::string> ids;
  for (const Claim& claim : claims) {
    if (claim.id == word || claim.place == word || claim.id.starts_with(word + ".") ||
        to_string(claim.kind) == word) {
      ids.insert(claim.id);
    }
  }
  if (word.empty() || ids.empty()) {
    std::vector<std::string> known;
    for (const Place& place : places()) {
      known.push_back(place.id);
    }
    throw UsageError(fmt::format(
        "there is no claim '{}': name an equation such as 40, a claim such as 44.H, a kind such as "
        "theorem, a status such as refuted, or one of the places {}",
        word, fmt::join(known, ", ")));
  }
  return ids;
}

}  // namespace stickslip::proofs::pascal2012
