#include "proofs/certificates/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <cctype>

#include "core/error.hpp"
#include "proofs/certificates/coq_terms.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::certificates {

using namespace kernel;

namespace {

// What stands in a comment of Coq.
std::string comment(std::string text) {
  for (const char * mark : {"*)", "(*"}) {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at)) {
      text.insert(at + 1, " ");
    }
  }
  std::erase(text, '"');
  return text;
}

// "Section 3", "Appendix 1", of "sec3", "A1".
std::string place_text(const std::string& place) {
  return place.starts_with("sec") ? "Section " + place.substr(3)
         : place.starts_with("A") ? "Appendix " + place.substr(1)
                                  : place;
}

}  // namespace

Stated stated(const Theorem& theorem, const std::function<std::string(const Formula&)>& premise) {
  Stated result{
      .variables = {}, .hypotheses = {theorem.hypotheses().begin(), theorem.hypotheses().end()}, .text = {}};
  Variables variables = theorem.conclusion().variables();
  for (const Formula& hypothesis : result.hypotheses) {
    variables.insert(hypothesis.variables().begin(), hypothesis.variables().end());
  }
  result.variables.assign(variables.begin(), variables.end());
  // What is short, as 0 < omega1, first.
  std::stable_sort(
      result.hypotheses.begin(), result.hypotheses.end(),
      [](const Formula& a, const Formula& b) { return coq_premise(a).size() < coq_premise(b).size(); });
  if (!result.variables.empty()) {
    result.text = fmt::format("  forall {},\n", binders(result.variables));
  }
  for (const Formula& hypothesis : result.hypotheses) {
    result.text += fmt::format("  {} ->\n", premise ? premise(hypothesis) : coq_premise(hypothesis));
  }
  result.text += "  " + coq_statement(theorem.conclusion());
  return result;
}

void collect_definitions(const Theorem& theorem, std::vector<Definition>& found) {
  std::vector<Formula> said(theorem.hypotheses().begin(), theorem.hypotheses().end());
  said.push_back(theorem.conclusion());
  const Formula whole = all(said);
  collect_definitions(whole, found);
  if (const std::string name = hidden_definition(whole); !name.empty()) {
    throw KernelError("a variable has the name of the definition " + name);
  }
}

bool is_immediate(const Theorem& theorem) {
  const Formula& said = theorem.conclusion();
  if (theorem.hypotheses().contains(said)) {
    return true;
  }
  if (said.kind() != Kind::equal) {
    return false;
  }
  const Definitions all = tactics::definitions_in({said});
  return unfold(said.parts()[0], all) == unfold(said.parts()[1], all);
}

std::vector<NamedTheorem> named_theorems(const methods::Record& record) {
  const methods::Claim& claim = record.claim;
  std::vector<NamedTheorem> result;
  const auto add = [&](const char * part, const char * said, const methods::Outcome& outcome) {
    const std::size_t count = outcome.theorems.size();
    for (std::size_t k = 1; k <= count; ++k) {
      const std::string& words =
          result.size() < claim.parts.size() ? claim.parts[result.size()] : claim.words;
      result.push_back(
          {.name = fmt::format("{}_{}_{}", part, file_name(claim.id).substr(6), k),
           .about = comment(fmt::format("{}, {}{}{}: {}", claim.id, place_text(claim.place), said,
                                        count > 1 ? fmt::format(", part {} of {}", k, count) : "", words)),
           .theorem = outcome.theorems[k - 1]});
    }
  };
  const bool refuted = record.outcome.verdict.truth == Truth::refuted;
  add("claim", refuted ? ", which is refuted" : "", record.outcome);
  if (record.corrected) {
    add("corrected", ", corrected", *record.corrected);
  }
  if (record.converse) {
    add("converse", ", the other direction", *record.converse);
  }
  if (!claim.parts.empty() && !result.empty() && claim.parts.size() != result.size()) {
    throw InternalError(fmt::format("claim {} has words for {} theorems, and {} theorems", claim.id,
                                    claim.parts.size(), result.size()));
  }
  return result;
}

std::string without_theorem(const methods::Record& record) {
  if (record.claim.kind == methods::Kind::check) {
    return "a check in floating point, which proves nothing";
  }
  if (record.status == methods::Status::model) {
    return record.outcome.verdict.reason;
  }
  const Truth truth = record.outcome.verdict.truth;
  return truth == Truth::proved || truth == Truth::refuted ? "decided in balls, outside the kernel"
         : record.outcome.verdict.reason.empty()           ? "no theorem of the kernel"
                                                           : record.outcome.verdict.reason;
}

std::string fingerprint(const std::string& text) {
  return boost::uuids::to_string(boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(text));
}

std::string fingerprint(const methods::Record& record) {
  static const std::string foundations = [] {
    std::string all;
    for (const auto& [name, text] : prelude()) {
      all += text;
    }
    return fingerprint(all);
  }();
  std::string text = foundations;
  std::vector<Definition> definitions;
  for (const NamedTheorem& one : named_theorems(record)) {
    collect_definitions(one.theorem, definitions);
    text += one.name + " :\n" + stated(one.theorem).text + ".\n";
  }
  for (const Definition& definition : definitions) {
    text += coq_definition(definition);
  }
  return fingerprint(text);
}

std::string file_name(const std::string& id) {
  std::string name = "Claim_";
  for (const unsigned char c : id) {
    name += std::isalnum(c) != 0 ? std::string(1, static_cast<char>(c))
            : c == '.'           ? "_"
                                 : fmt::format("_{:x}_", c);
  }
  return name;
}

}  // namespace stickslip::proofs::certificates
