#include "proofs/methods/paper.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"

namespace stickslip::proofs::methods {

const PrintedResult& Example::result(const std::string& result_name) const {
  const auto found = std::ranges::find(results, result_name, &PrintedResult::name);
  if (found == results.end()) {
    throw InternalError(fmt::format("example {} prints no {}", name, result_name));
  }
  return *found;
}

std::set<std::string> ids_named(const std::vector<Claim>& claims, const std::string& word) {
  std::set<std::string> ids;
  std::vector<std::string> places;
  for (const Claim& claim : claims) {
    if (claim.id == word || claim.place == word || claim.id.starts_with(word + ".") ||
        to_string(claim.kind) == word) {
      ids.insert(claim.id);
    }
    if (places.empty() || places.back() != claim.place) {
      places.push_back(claim.place);
    }
  }
  if (word.empty() || ids.empty()) {
    const std::string part = id_of_a_part(claims);
    throw UsageError(fmt::format(
        "there is no claim '{}': name an equation such as {}, a claim such as {}, a kind such as theorem, a "
        "status such as refuted, or one of the places {}",
        word, part.substr(0, part.find('.')), part, fmt::join(places, ", ")));
  }
  return ids;
}

std::string id_of_a_part(const std::vector<Claim>& claims) {
  const auto found = std::ranges::find_if(
      claims, [](const Claim& claim) { return claim.id.find('.') != std::string::npos; });
  return found == claims.end() ? "" : found->id;
}

const Example& example_named(const std::vector<Example>& examples, const std::string& name) {
  const auto found = std::ranges::find(examples, name, &Example::name);
  if (found == examples.end()) {
    throw UsageError(fmt::format("there is no example '{}': the paper's are {}", name, names_of(examples)));
  }
  return *found;
}

std::string names_of(const std::vector<Example>& examples) {
  std::string names;
  for (const Example& example : examples) {
    const bool last = &example == &examples.back();
    names += (names.empty() ? "" : last ? " or " : ", ") + example.name;
  }
  return names;
}

}  // namespace stickslip::proofs::methods
