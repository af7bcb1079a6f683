#include "report/audit/coq_output.hpp"

#include <cstdlib>
#include <sstream>

#include "report/tools/files.hpp"

namespace stickslip::report::audit {

namespace fs = std::filesystem;

const std::map<std::string, std::string>& allowed_axioms() {
  static const std::map<std::string, std::string> axioms{
      {"ClassicalDedekindReals.sig_not_dec", "forall P : Prop, {~ ~ P} + {~ P}"},
      {"ClassicalDedekindReals.sig_forall_dec",
       "forall P : nat -> Prop, (forall n : nat, {P n} + {~ P n}) -> {n : nat | ~ P n} + {forall n : nat, P "
       "n}"},
      {"FunctionalExtensionality.functional_extensionality_dep",
       "forall (A : Type) (B : A -> Type) (f g : forall x : A, B x), (forall x : A, f x = g x) -> f = g"},
      {"Classical_Prop.classic", "forall P : Prop, P \\/ ~ P"}};
  return axioms;
}

std::map<std::string, std::string> axioms_in(const std::string& printed) {
  std::map<std::string, std::string> axioms;
  std::istringstream lines(printed);
  bool inside = false;
  std::string name;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Axioms:" || line.starts_with("Closed under the global context")) {
      inside = true;
      name.clear();
      continue;
    }
    if (!inside || line.empty()) {
      continue;
    }
    std::istringstream words(line);
    std::string word;
    if (line.front() != ' ') {
      words >> name;
      axioms[name];
    }
    while (words >> word) {
      if (!(axioms[name].empty() && word == ":")) {
        axioms[name] += (axioms[name].empty() ? "" : " ") + word;
      }
    }
  }
  return axioms;
}

std::string seconds_in(const fs::path& log) {
  std::error_code error;
  std::istringstream lines(fs::exists(log, error) ? tools::read_file(log) : "");
  std::string seconds;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("seconds ")) {
      seconds = line.substr(8);
    }
  }
  return seconds;
}

std::size_t line_in(const std::string& complaint) {
  const std::size_t at = complaint.find("line ");
  return at == std::string::npos ? 0 : std::strtoul(complaint.c_str() + at + 5, nullptr, 10);
}

std::string error_in(const std::string& complaint) {
  const std::size_t at = complaint.find("Error:");
  std::istringstream words(at == std::string::npos ? complaint : complaint.substr(at + 6));
  std::string line;
  for (std::string word; words >> word && line.size() < 200;) {
    line += (line.empty() ? "" : " ") + word;
  }
  return line;
}

std::vector<std::string> required_by(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("From Stickslip Require ")) {
      std::istringstream words(line.substr(23));
      for (std::string word; words >> word;) {
        if (word != "Import" && word != "Export") {
          names.push_back(word.ends_with('.') ? word.substr(0, word.size() - 1) : word);
        }
      }
    }
  }
  return names;
}

}  // namespace stickslip::report::audit
