// Standard output, checked to the last byte; progress on standard error.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include "cli/answers/machine_file.hpp"
#include "core/error.hpp"
#include "report/audit/pages.hpp"
#include "report/audit/table.hpp"

namespace stickslip::cli {

// The reader of standard output is gone (stickslip check | head): nothing to say, and nobody to say it to.
struct ReaderGone : InputOutputError {
  using InputOutputError::InputOutputError;
};

// Writes the text and waits until the system has taken it. Throws ReaderGone or, if standard output is closed
// or full, InputOutputError.
void print(std::string_view text);

// A line on standard error, for a person; whether it arrives does not matter.
void tell(std::string_view line) noexcept;

// A line on a terminal's standard error while an object of this type lives and the work takes over a second;
// on anything else nothing.
class Progress {
 public:
  explicit Progress(const std::string& line);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Another line in its place; one with the share of the work that is done, no more often than it is written.
  void show(const std::string& line);
  void show(const char * doing, double share);

 private:
  bool terminal_;
  bool shown_ = false;
  std::string line_;
  std::chrono::steady_clock::time_point last_{};  // when a share was shown
  std::mutex lock_;
  std::condition_variable_any over_;
  std::jthread writer_;
};

// Says on standard error what was left out, and why; once there is an answer.
void tell_left_out(const ParameterFile& file);

// What goes before a report; nothing for dimensionless parameters.
[[nodiscard]] std::string machine_report(const ParameterFile& file);

// The audit of these claims, with its progress.
[[nodiscard]] proofs::methods::Audit prove(const std::vector<proofs::methods::Claim>& claims,
                                           const std::set<std::string>& ids);

// How a command about claims ends: 1 where a status is not the expected one, which is said on standard error;
// else 1 if `refuted`, 2 if something is undecided, 0.
[[nodiscard]] ExitCode exit_of(const proofs::methods::Audit& audit, bool refuted);

// "The report is in DIR: index.html, NAME.tex, ..." and what could not be made.
[[nodiscard]] std::string report_line(const std::string& directory, const std::string& name,
                                      const report::audit::Report& report);

// Before long work whose result is a page in the directory: throws InputOutputError unless the page can be
// made and written.
void require_page(const std::string& directory);

// As wide as the terminal, within bounds, eighty columns elsewhere; coloured on a terminal, unless NO_COLOR
// is set to something or the terminal is dumb.
[[nodiscard]] report::tools::Style terminal_style();

// The C libraries below know no exceptions: where they find no memory, they would abort. So does the
// allocator.

inline constexpr const char * out_of_memory = "stickslip: out of memory.";

// From now on `new`, GMP and FLINT, with Arb and CLN on top of GMP, end the program with a sentence and
// exit_internal when there is no memory left. To be called before any number is made.
void end_in_words_without_memory();

}  // namespace stickslip::cli
