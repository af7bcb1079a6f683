#include "proofs/symbols/abbreviations.hpp"

#include <algorithm>
#include <map>

#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::symbols {
namespace {

using namespace symbols::vocabulary;

// The 4×4 matrices by their letters in Appendix 3.
const std::map<std::string, Term>& matrices() {
  static const std::map<std::string, Term> known{
      {"H", H(tau)}, {"h", H(tau1)}, {"Htilde", H(tau + tau1)}, {"Gamma", Gamma(T)}};
  return known;
}

struct Entry {
  std::string letter;
  int row, column;
};

std::optional<Entry> entry_named(const std::string& name) {
  if (name.size() < 3) {
    return std::nullopt;
  }
  const std::string letter = name.substr(0, name.size() - 2);
  const int row = name[name.size() - 2] - '0';
  const int column = name[name.size() - 1] - '0';
  const auto is_index = [](int i) { return 1 <= i && i <= 4; };
  if (!matrices().contains(letter) || !is_index(row) || !is_index(column)) {
    return std::nullopt;
  }
  return Entry{letter, row, column};
}

std::vector<Term> unit(int index) {
  std::vector<Term> result(4, Term(0));
  result[static_cast<std::size_t>(index - 1)] = 1;
  return result;
}

const std::map<std::string, Term>& others() {
  static const std::map<std::string, Term> known{{"phiB", omega * tau + phi},
                                                 {"phiC", omega * tau + phi + omega * tau1},
                                                 {"Delta", determinant_of_columns({"a", "b", "c"})},
                                                 {"Delta1", determinant_of_columns({"-d", "b", "c"})},
                                                 {"Delta2", determinant_of_columns({"d", "a", "c"})},
                                                 {"Delta3", determinant_of_columns({"d", "b", "a"})}};
  return known;
}

}  // namespace

Term Entries::operator()(int row, int column) const {
  return scalar(letter + std::to_string(row) + std::to_string(column));
}

Term coefficient(char letter, int equation) {
  return scalar(std::string(1, letter) + "_" + std::to_string(equation));
}

Term determinant_of_columns(const std::array<std::string, 3>& columns) {
  std::vector<Term> entries;
  for (int row = 1; row <= 3; ++row) {
    for (const std::string& column : columns) {
      const Term entry = coefficient(column.back(), row);
      entries.push_back(column.front() == '-' ? -entry : entry);
    }
  }
  return determinant(block(3, std::move(entries)));
}

std::optional<Term> abbreviated(const std::string& name) {
  if (const auto entry = entry_named(name)) {
    return block(1, unit(entry->row)) * matrices().at(entry->letter) * column(unit(entry->column));
  }
  const auto found = others().find(name);
  return found == others().end() ? std::nullopt : std::optional(found->second);
}

std::string abbreviation_defined_in(const std::string& name) {
  if (entry_named(name)) {
    return {};  // the matrix has its own definition
  }
  return name.starts_with("Delta") ? "22.Delta" : "51.phi";
}

std::vector<std::string> entry_siblings(const std::string& name) {
  const auto entry = entry_named(name);
  if (!entry) {
    return {};
  }
  std::vector<std::string> result;
  for (int i = 1; i <= 4; ++i) {
    result.push_back(entry->letter + std::to_string(i) + std::to_string(entry->column));
    result.push_back(entry->letter + std::to_string(entry->row) + std::to_string(i));
  }
  if (entry->letter != "Gamma") {
    for (const char * letter : {"H", "h", "Htilde"}) {
      result.push_back(letter + std::to_string(entry->row) + std::to_string(entry->column));
    }
  }
  std::erase(result, name);
  return result;
}

}  // namespace stickslip::proofs::symbols
