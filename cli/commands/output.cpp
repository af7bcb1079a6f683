#include "cli/commands/output.hpp"

#include <flint/flint.h>
#include <fmt/format.h>
#include <gmp.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <system_error>

#include "core/error.hpp"
#include "proofs/methods/prover.hpp"
#include "report/audit/summary.hpp"
#include "report/orbits/page.hpp"

namespace stickslip::cli {

namespace {

std::string_view variable(const char * name) {
  const char * value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

// Columns of a terminal: tables have no room in fewer, sentences are hard to read in more.
constexpr std::size_t narrowest = 60;
constexpr std::size_t widest = 140;

constexpr std::chrono::milliseconds patience{1000};
constexpr std::chrono::milliseconds beat{200};

}  // namespace

void print(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, text.data(), text.size());
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
      continue;
    }
    const int error = errno;
    if (error == EPIPE) {
      throw ReaderGone("the reader of standard output is gone");
    }
    if (error != EINTR) {
      throw InputOutputError(
          fmt::format("cannot write to standard output: {}", std::generic_category().message(error)));
    }
  }
}

void tell(std::string_view line) noexcept {
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fputc('\n', stderr);
}

Progress::Progress(const std::string& line) : terminal_(::isatty(STDERR_FILENO) != 0), line_(line) {
  if (terminal_) {
    writer_ = std::jthread([this](const std::stop_token& stop) {
      std::unique_lock hold(lock_);
      for (auto pause = patience; !over_.wait_for(hold, stop, pause, [&] { return stop.stop_requested(); });
           pause = beat) {
        fmt::print(stderr, "\r\x1b[K{}", line_);
        shown_ = true;
      }
    });
  }
}

Progress::~Progress() {
  if (terminal_) {
    writer_.request_stop();
    writer_.join();
    if (shown_) {
      std::fputs("\r\x1b[K", stderr);
    }
  }
}

void Progress::show(const std::string& line) {
  const std::lock_guard hold(lock_);
  line_ = line;
}

void Progress::show(const char * doing, double share) {
  const auto now = std::chrono::steady_clock::now();
  if (terminal_ && now - last_ >= beat) {
    last_ = now;
    show(fmt::format("{} {:.0f} %", doing, 100 * share));
  }
}

void tell_left_out(const ParameterFile& file) {
  for (const std::string& sentence : file.left_out) {
    tell(sentence);
  }
}

std::string machine_report(const ParameterFile& file) {
  return file.machine ? report::orbits::terminal_report(*file.machine, terminal_style(),
                                                        std::min(file.digits, numeric::DataTaken::digits))
                      : "";
}

proofs::methods::Audit prove(const std::vector<proofs::methods::Claim>& claims,
                             const std::set<std::string>& ids) {
  Progress progress("proving ...");
  return proofs::methods::audit(claims, ids,
                                [&progress](const std::string& id, std::size_t done, std::size_t all) {
                                  progress.show(fmt::format("proving {} of {}: {}", done + 1, all, id));
                                });
}

ExitCode exit_of(const proofs::methods::Audit& audit, bool refuted) {
  const std::vector<std::string> unexpected = report::audit::unexpected(audit);
  for (const std::string& sentence : unexpected) {
    tell("stickslip: " + sentence + ".");
  }
  if (refuted || !unexpected.empty()) {
    return exit_refuted;
  }
  return report::audit::all_decided(audit) ? exit_decided : exit_undecided;
}

std::string report_line(const std::string& directory, const std::string& name,
                        const report::audit::Report& report) {
  const std::string pdf = report.note.empty() ? fmt::format(" {}.pdf,", name) : "";
  return fmt::format("The report is in {0}: index.html,{1} {2}.tex and {2}.json.{3}", directory, pdf, name,
                     report.note.empty() ? "" : " " + report.note);
}

void require_page(const std::string& directory) {
  report::tools::require_writable(directory);
  report::orbits::require_page_tools();
}

report::tools::Style terminal_style() {
  report::tools::Style style;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    style.width = std::clamp<std::size_t>(size.ws_col, narrowest, widest);
  }
  style.colour = ::isatty(STDOUT_FILENO) != 0 && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
  return style;
}

namespace {

[[noreturn]] void end() {
  tell(out_of_memory);
  ::_exit(exit_internal);
}

// NOLINTBEGIN(cppcoreguidelines-owning-memory): what malloc and free are called by
extern "C" {

void * allocate(std::size_t size) {
  void * block = std::malloc(size);
  return block != nullptr || size == 0 ? block : (end(), nullptr);
}
void * allocate_zeros(std::size_t count, std::size_t size) {
  void * block = std::calloc(count, size);
  return block != nullptr || count == 0 || size == 0 ? block : (end(), nullptr);
}
void * reallocate(void * block, std::size_t size) {
  void * larger = std::realloc(block, size);
  return larger != nullptr || size == 0 ? larger : (end(), nullptr);
}
void * reallocate_known(void * block, std::size_t /*old_size*/, std::size_t size) {
  return reallocate(block, size);
}
void release(void * block) {
  std::free(block);
}
void release_known(void * block, std::size_t /*size*/) {
  std::free(block);
}

}  // extern "C"
// NOLINTEND(cppcoreguidelines-owning-memory)

}  // namespace

void end_in_words_without_memory() {
  mp_set_memory_functions(allocate, reallocate_known, release_known);
  __flint_set_memory_functions(allocate, allocate_zeros, reallocate, release);
  std::set_new_handler(end);  // mimalloc throws nothing, it ends the program without a word
}

}  // namespace stickslip::cli
