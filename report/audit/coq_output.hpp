// What Coq, its compiler and `time` write, read.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace stickslip::report::audit {

// The axioms of Coq's real numbers and of classical logic, and what each says, as Coq prints it in one line:
// what a theorem may rest on.
[[nodiscard]] const std::map<std::string, std::string>& allowed_axioms();

// What Coq prints for "Print Assumptions": names and what they say, each in one line. Whatever else it prints
// there, as of checks that were switched off, stands among the names.
[[nodiscard]] std::map<std::string, std::string> axioms_in(const std::string& printed);

// The seconds that a file took, from its log; empty without one.
[[nodiscard]] std::string seconds_in(const std::filesystem::path& log);
// "… line 12, …": the number, or 0.
[[nodiscard]] std::size_t line_in(const std::string& complaint);
// What stands after "Error:", in one line of moderate length.
[[nodiscard]] std::string error_in(const std::string& complaint);
// What a file requires of its own library.
[[nodiscard]] std::vector<std::string> required_by(const std::string& text);

}  // namespace stickslip::report::audit
