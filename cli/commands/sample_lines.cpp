#include "cli/commands/sample_lines.hpp"

#include "cli/commands/answer.hpp"
#include "core/error.hpp"

namespace stickslip::cli {

bool are_for_output(const SimulateOptions& options) {
  return options.csv == "-";
}

void require_places(const SimulateOptions& options) {
  Outputs files = options;
  if (are_for_output(options)) {
    if (options.json) {
      throw UsageError("--csv - and --json do not go together: both are for standard output");
    }
    files.csv.reset();
  }
  if (options.csv == "") {
    throw UsageError("csv: '' is not the name of a file");
  }
  require_outputs(files);
}

SampleLines::SampleLines(const SimulateOptions& options, const std::string& names)
    : to_output_(are_for_output(options)) {
  if (options.csv && !to_output_) {
    file_.emplace(*options.csv);
  }
  if (wanted()) {
    add(names);
  }
}

void SampleLines::add(std::string_view line) {
  constexpr std::size_t chunk = 1 << 16;
  if (file_) {
    file_->append(line);
    return;
  }
  output_ += line;
  if (output_.size() >= chunk) {
    print(output_);
    output_.clear();
  }
}

void SampleLines::complete() {
  if (to_output_) {
    print(output_);
  }
  if (file_) {
    file_->complete();
  }
}

void SampleLines::take_place() {
  if (file_) {
    file_->take_place();
  }
}

}  // namespace stickslip::cli
