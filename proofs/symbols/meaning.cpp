#include "proofs/symbols/meaning.hpp"

#include <map>

#include "proofs/symbols/abbreviations.hpp"

namespace stickslip::proofs::symbols {

std::set<std::string> definitions_in(const Term& term) {
  static const std::map<std::string, std::string> defined_in{
      {"H", "6.H"},        {"H1", "38"},        {"H2", "38"},         {"H3", "38"},
      {"B1", "38"},        {"B2", "38"},        {"B3", "38"},         {"Lambda", "38"},
      {"psi1", "39"},      {"psi2", "39"},      {"K", "39"},          {"Gamma", "10.Gamma"},
      {"Gamma1", "41"},    {"Gamma2", "41"},    {"Gamma3", "41"},     {"gamma1", "41"},
      {"gamma2", "41"},    {"gamma3", "41"},    {"Sigma", "41"},      {"F", "5.F"},
      {"F0", "5.F"},       {"R", "5.F"},        {"L", "8.L"},         {"FB", "28.F"},
      {"X0", "52.X"},      {"XB", "52.X"},      {"x0", "52.X"},       {"xB", "52.X"},
      {"delta0", "52.X"},  {"Zbar0", "55.bar"}, {"ZbarB", "55.bar"},  {"zbar0", "55.bar"},
      {"zbarB", "55.bar"}, {"xi1", "57"},       {"xi2", "57"},        {"X1", "57"},
      {"Y1", "57"},        {"X2", "57"},        {"Y2", "57"},         {"P1", "63.P"},
      {"P2", "63.P"},      {"P", "64.P"},       {"Ptilde", "70.rho"},
  };
  std::set<std::string> result;
  if (const auto found = defined_in.find(term.name()); found != defined_in.end()) {
    result.insert(found->second);
  }
  if (const auto meaning = term.op() == Op::symbol ? abbreviated(term.name()) : std::nullopt) {
    result.merge(definitions_in(*meaning));
    result.insert(abbreviation_defined_in(term.name()));
    result.erase("");
  }
  for (const Term& argument : term.arguments()) {
    result.merge(definitions_in(argument));
  }
  return result;
}

}  // namespace stickslip::proofs::symbols
