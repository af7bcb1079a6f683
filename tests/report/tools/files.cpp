#include "report/tools/files.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <csignal>

#include "core/error.hpp"
#include "tests/report/temporary.hpp"

using namespace stickslip;
using namespace stickslip::report::tools;

namespace {

// The message of the InputOutputError that the call throws; empty if it throws none.
template <class Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const InputOutputError& error) {
    return error.what();
  }
  return {};
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("files are written whole, and the directory is created") {
  const TemporaryDirectory temporary;
  const auto out = temporary.path() / "out";
  write_files(out, {{"a", "one"}, {"b", std::string(100000, 'x')}});
  CHECK(read_file(out / "a") == "one");
  CHECK(read_file(out / "b").size() == 100000);
  write_files(out.string() + "/", {{"a", ""}});
  CHECK(read_file(out / "a").empty());
  CHECK(temporary.count() == 3);
}

TEST_CASE("a directory whose parent is missing is not created") {
  const TemporaryDirectory temporary;
  const auto out = temporary.path() / "missing" / "out";
  const std::string message = complaint([&] { write_files(out, {{"a", "one"}}); });
  CHECK(mentions(message, out.string()));
  CHECK(mentions(message, (temporary.path() / "missing").string() + " is not an existing directory"));
  CHECK(temporary.count() == 0);
}

TEST_CASE("a file in the place of the directory is left alone") {
  const TemporaryDirectory temporary;
  write_files(temporary.path(), {{"file", "content"}});
  const auto file = temporary.path() / "file";
  CHECK(mentions(complaint([&] { write_files(file, {{"a", "one"}}); }), file.string()));
  CHECK(mentions(complaint([&] { write_files(file / "out", {{"a", "one"}}); }), file.string()));
  CHECK(mentions(complaint([&] { require_writable(file); }), file.string()));
  CHECK(read_file(file) == "content");
  CHECK(temporary.count() == 1);
}

TEST_CASE("a directory that takes no files is named") {
  // The kernel's own directory: not even root can create files there.
  CHECK(mentions(complaint([] { write_files("/proc/stickslip", {{"a", "one"}}); }), "/proc/stickslip"));
  CHECK(mentions(complaint([] { require_writable(""); }), "without a name"));
}

TEST_CASE("if one file cannot take its place, nothing is changed") {
  const TemporaryDirectory temporary;
  const auto out = temporary.path() / "out";
  write_files(out, {{"a", "old"}});
  std::filesystem::create_directory(out / "b");
  const std::string message = complaint([&] { write_files(out, {{"a", "new"}, {"b", "new"}}); });
  CHECK(mentions(message, (out / "b").string()));
  CHECK(read_file(out / "a") == "old");
  CHECK(temporary.count() == 3);
}

TEST_CASE("a disk that is full leaves no part of a file and no directory") {
  const TemporaryDirectory temporary;
  const auto out = temporary.path() / "out";
  // Files of this process may not grow beyond 1000 bytes: the system's refusal comes in the middle of a
  // write.
  rlimit previous{};
  getrlimit(RLIMIT_FSIZE, &previous);
  const auto previous_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{1000, previous.rlim_max};
  setrlimit(RLIMIT_FSIZE, &tight);
  const std::string message = complaint([&] {
    write_files(out, {{"a", "one"}, {"b", std::string(5000, 'x')}});
  });
  setrlimit(RLIMIT_FSIZE, &previous);
  std::signal(SIGXFSZ, previous_handler);
  CHECK(mentions(message, (out / "b").string()));
  CHECK(temporary.count() == 0);
}

TEST_CASE("a missing file is named") {
  const TemporaryDirectory temporary;
  const auto file = temporary.path() / "none";
  CHECK(mentions(complaint([&] { static_cast<void>(read_file(file)); }), file.string()));
  CHECK(mentions(complaint([&] { static_cast<void>(read_file(temporary.path())); }),
                 temporary.path().string()));
}
