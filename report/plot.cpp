#include "report/plot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "core/error.hpp"
#include "report/files.hpp"

extern "C" char** environ;  // NOLINT: POSIX's

namespace stickslip::report {
namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
// A file without a name, gone when closed: gnuplot can read and write without waiting for this program.
using Scratch = std::unique_ptr<std::FILE, Close>;

Scratch scratch() {
  Scratch file(std::tmpfile());
  if (!file) {
    throw InputOutputError(
        fmt::format("cannot create a temporary file: {}", std::generic_category().message(errno)));
  }
  return file;
}

std::string content(std::FILE* file) {
  std::rewind(file);
  std::string text;
  char buffer[1 << 16];
  for (std::size_t count = 0; (count = std::fread(buffer, 1, sizeof buffer, file)) > 0;) {
    text.append(buffer, count);
  }
  return text;
}

std::string first_line(const std::string& text) {
  const std::size_t start = text.find_first_not_of(" \n\t");
  return start == std::string::npos ? "it says nothing" : text.substr(start, text.find('\n', start) - start);
}

fs::path directory_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

}  // namespace

PlotFormat plot_format(const fs::path& file) {
  if (file.extension() == ".svg") {
    return PlotFormat::svg;
  }
  if (file.extension() == ".pdf") {
    return PlotFormat::pdf;
  }
  throw UsageError(fmt::format("plot: the name '{}' ends in neither .svg nor .pdf", file.string()));
}

void require_plot(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_directory(directory_of(file), ignored)) {
    throw InputOutputError(fmt::format("cannot write {}: {} is not an existing directory", file.string(),
                                       directory_of(file).string()));
  }
  if (fs::is_directory(file, ignored)) {
    throw InputOutputError(fmt::format("cannot write {}: it is a directory", file.string()));
  }
  require_writable(directory_of(file));
  (void)gnuplot("");
}

std::string gnuplot(const std::string& script) {
  const Scratch input = scratch();
  const Scratch output = scratch();
  const Scratch complaints = scratch();
  std::fwrite(script.data(), 1, script.size(), input.get());
  std::rewind(input.get());
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ::fileno(input.get()), 0);
  posix_spawn_file_actions_adddup2(&actions, ::fileno(output.get()), 1);
  posix_spawn_file_actions_adddup2(&actions, ::fileno(complaints.get()), 2);
  char name[] = "gnuplot";
  char* const arguments[] = {name, nullptr};
  pid_t process = 0;
  const int error = ::posix_spawnp(&process, name, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (error == 0) {
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
  }
  if (error != 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 127)) {
    throw InputOutputError(
        "cannot draw a plot: the program gnuplot is not there (Debian has it in gnuplot-nox)");
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw InputOutputError("cannot draw a plot: gnuplot failed: " + first_line(content(complaints.get())));
  }
  return content(output.get());
}

void write_plot(const fs::path& file, const std::string& script) {
  const std::string picture = gnuplot(script);
  if (picture.empty()) {
    throw InputOutputError(fmt::format("cannot write {}: gnuplot drew nothing", file.string()));
  }
  write_files(directory_of(file), {{file.filename().string(), picture}});
}

}  // namespace stickslip::report
