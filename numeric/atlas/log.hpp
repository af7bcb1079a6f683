// The log of an atlas: a directory with the question, and a file for each process that only ever grows by
// leaves. It is the truth: whatever is killed, whenever, what stands in it was found, and counts.
//
// A file is a row of records of 16 bytes, little-endian: the tile (8), orbits, admissible, stable, reason
// (1 each), and a checksum (4) of these and of the question. Where the first record is torn or damaged the
// file ends.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "numeric/atlas/question.hpp"

namespace stickslip::numeric::atlas {

// What an answer depends on: the version of the program and the question.
[[nodiscard]] std::string identity(const Question& question, const std::string& version);

// Creates the directory, which must not exist, with the question in it. Throws InputOutputError.
void create_log(const std::filesystem::path& directory, const std::string& identity);

// Held by the first of the processes that work on a log, so that two runs do not write the same.
class LogLock {
 public:
  // Throws InputOutputError when there is no such log or another run holds it.
  explicit LogLock(const std::filesystem::path& directory);
  ~LogLock();
  LogLock(const LogLock&) = delete;
  LogLock& operator=(const LogLock&) = delete;

 private:
  int descriptor_ = -1;
};

// All leaves of a log, whose torn or damaged ends are cut off. Throws UsageError when the log is that of
// another question or version, InputOutputError when it cannot be read, or is none.
[[nodiscard]] std::vector<Leaf> read_log(const std::filesystem::path& directory, const std::string& identity);

// The file of one process, open for more. Not for several threads at once.
class Log {
 public:
  // Throws InputOutputError naming the file, as append does.
  Log(const std::filesystem::path& directory, int process, const std::string& identity);
  ~Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  // Returns when the system has taken them.
  void append(const std::vector<Leaf>& leaves);

 private:
  std::filesystem::path file_;
  std::uint32_t seed_;
  int descriptor_ = -1;
};

}  // namespace stickslip::numeric::atlas
