// What simulations write for --csv, line by line while a motion is followed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cli/arguments/arguments.hpp"
#include "report/tools/files.hpp"

namespace stickslip::cli {

// "-": on standard output, in place of the report.
[[nodiscard]] bool are_for_output(const SimulateOptions& options);

// Before long work: all that is asked for can be written. Throws InputOutputError, and UsageError where two
// are for standard output.
void require_places(const SimulateOptions& options);

class SampleLines {
 public:
  // Nowhere without --csv. Throws InputOutputError where they cannot go.
  SampleLines(const SimulateOptions& options, const std::string& names);
  [[nodiscard]] bool wanted() const { return file_ || to_output_; }
  void add(std::string_view line);
  // No more come; then, once all else is written, the file takes its place.
  void complete();
  void take_place();

 private:
  std::optional<report::tools::PendingFile> file_;
  bool to_output_;
  std::string output_;
};

}  // namespace stickslip::cli
