// What can go wrong on the caller's side, one type per exit code. Mathematics never throws: it returns
// verdicts.
#pragma once

#include <stdexcept>
#include <string>

namespace stickslip {

enum ExitCode : int {
  exit_decided = 0,
  exit_refuted = 1,
  exit_undecided = 2,
  exit_usage = 64,
  exit_domain = 65,
  exit_internal = 70,
  exit_io = 74,
  exit_interrupted = 130,
};

class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

// The command line or a file says something that cannot be understood.
struct UsageError : Error {
  explicit UsageError(const std::string& message) : Error(exit_usage, message) {}
};

// A parameter is understood but outside the domain of the model; the message names the parameter, its value
// and the allowed range.
struct DomainError : Error {
  DomainError(const std::string& name, const std::string& value, const std::string& range);
};

// A file or directory cannot be read or written.
struct InputOutputError : Error {
  explicit InputOutputError(const std::string& message) : Error(exit_io, message) {}
};

// A fault of the program itself: two engines disagree, a proof uses itself, an unknown symbol in a statement.
struct InternalError : Error {
  explicit InternalError(const std::string& message) : Error(exit_internal, message) {}
};

}  // namespace stickslip
