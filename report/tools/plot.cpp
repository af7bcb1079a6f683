#include "report/tools/plot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "report/tools/files.hpp"

extern "C" char ** environ;  // NOLINT: POSIX's

namespace stickslip::report::tools {

namespace fs = std::filesystem;

namespace {

struct Close {
  void operator()(std::FILE * file) const { std::fclose(file); }
};
// A file in memory, gone when closed: the other program can read and write without waiting for this one.
using Scratch = std::unique_ptr<std::FILE, Close>;

Scratch scratch() {
  const int descriptor = ::memfd_create("stickslip", MFD_CLOEXEC);
  Scratch file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "w+"));
  if (!file) {
    throw InputOutputError(
        fmt::format("cannot create a temporary file: {}", std::generic_category().message(errno)));
  }
  return file;
}

std::string content(std::FILE * file) {
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

// Runs the program to its end with these as standard input, output and error: its status as waitpid gives it,
// or nothing if it could not be started. It starts with the signals that this one ignores as the system has
// them: a full disk ends it.
std::optional<int> run_to_end(const Tool& tool, const std::vector<std::string>& arguments,
                              const std::array<std::FILE *, 3>& streams, const fs::path& directory) {
  std::vector<std::string> words{tool.program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char *> argv;
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_adddup2(&actions, ::fileno(streams.at(static_cast<std::size_t>(descriptor))),
                                     descriptor);
  }
  if (!directory.empty()) {
    posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  }
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGPIPE);
  sigaddset(&signals, SIGXFSZ);
  posix_spawnattr_t attributes{};
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, tool.program.c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  while (error == 0 && ::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return error == 0 ? std::optional(status) : std::nullopt;
}

[[noreturn]] void miss(const Tool& tool) {
  throw InputOutputError(fmt::format("cannot {}: the program {} is not there (Debian has it in {})",
                                     tool.purpose, tool.program, tool.package));
}

}  // namespace

bool is_there(const Tool& tool) {
  const char * path = std::getenv("PATH");
  std::istringstream directories(path == nullptr ? "" : path);
  for (std::string directory; std::getline(directories, directory, ':');) {
    if (::access((fs::path(directory.empty() ? "." : directory) / tool.program).c_str(), X_OK) == 0) {
      return true;
    }
  }
  return false;
}

void require(const Tool& tool) {
  if (!is_there(tool)) {
    miss(tool);
  }
}

std::string version_in(const std::string& text) {
  const std::size_t start = text.find_first_of("0123456789");
  return start == std::string::npos ? "" : text.substr(start, text.find('\n', start) - start);
}

Ran attempt(const Tool& tool, const std::vector<std::string>& arguments, const std::string& input,
            const fs::path& directory) {
  const Scratch in = scratch();
  const Scratch out = scratch();
  const Scratch complaints = scratch();
  if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() || std::fflush(in.get()) != 0) {
    throw InputOutputError(
        fmt::format("cannot {}: {}", tool.purpose, std::generic_category().message(errno)));
  }
  std::rewind(in.get());
  const std::optional<int> status =
      run_to_end(tool, arguments, {in.get(), out.get(), complaints.get()}, directory);
  constexpr int not_found = 127;
  if (!status || (WIFEXITED(*status) && WEXITSTATUS(*status) == not_found)) {
    miss(tool);
  }
  return {WIFEXITED(*status) && WEXITSTATUS(*status) == 0, content(out.get()), content(complaints.get())};
}

std::string run(const Tool& tool, const std::vector<std::string>& arguments, const std::string& input,
                const fs::path& directory) {
  Ran ran = attempt(tool, arguments, input, directory);
  if (!ran.succeeded) {
    throw InputOutputError(
        fmt::format("cannot {}: {} failed: {}", tool.purpose, tool.program, first_line(ran.complaints)));
  }
  return ran.output;
}

Workshop::Workshop(const std::string& purpose) {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "stickslip-XXXXXX").string();
  if (error || ::mkdtemp(name.data()) == nullptr) {
    throw InputOutputError(fmt::format("cannot {}: there is no temporary directory to do it in", purpose));
  }
  path_ = name;
}

Workshop::~Workshop() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string Workshop::content(const std::string& file) const {
  return fs::exists(path_ / file) ? read_file(path_ / file) : "";
}

namespace {

const Tool& plotter() {
  static const Tool tool{"gnuplot", "gnuplot-nox", "draw a plot"};
  return tool;
}

}  // namespace

PlotFormat plot_format(const fs::path& file) {
  for (const auto& [ending, format] :
       {std::pair(".svg", PlotFormat::svg), {".pdf", PlotFormat::pdf}, {".png", PlotFormat::png}}) {
    if (file.extension() == ending) {
      return format;
    }
  }
  throw UsageError(fmt::format("plot: the name '{}' ends in none of .svg, .pdf and .png", file.string()));
}

std::string terminal(PlotFormat format, int width, int height) {
  constexpr double pixels_per_inch = 96;
  constexpr int png_scale = 2;  // pixels of a PNG for each of the SVG, so that it can be printed
  constexpr const char * rest = "enhanced background rgb \"white\"";
  switch (format) {
    case PlotFormat::svg:
      return fmt::format("svg size {},{} font \"sans,13\" {}", width, height, rest);
    case PlotFormat::pdf:
      return fmt::format("pdfcairo size {:.2f}in,{:.2f}in font \"sans,11\" {}", width / pixels_per_inch,
                         height / pixels_per_inch, rest);
    case PlotFormat::png:
      return fmt::format(
          "pngcairo size {0},{1} font \"sans,10\" fontscale {2} linewidth {2} pointscale {2} {3}",
          png_scale * width, png_scale * height, png_scale, rest);
  }
  throw InternalError("a picture of no known format");
}

void require_plot(const fs::path& file) {
  (void)plot_format(file);
  require_writable_file(file);
  require_gnuplot();
}

void require_gnuplot() {
  require(plotter());
}

std::string gnuplot_version() {
  return version_in(run(plotter(), {"--version"}));
}

std::string gnuplot(const std::string& script) {
  const std::string picture = run(plotter(), {}, script);
  // gnuplot does not say when it could not write all of it.
  const std::size_t last = picture.find_last_not_of('\n');
  const std::string_view text = std::string_view(picture).substr(0, last == std::string::npos ? 0 : last + 1);
  constexpr std::string_view end_of_png = "IEND\xae\x42\x60\x82";
  if (!text.ends_with("</svg>") && !text.ends_with("%%EOF") && !text.ends_with(end_of_png)) {
    throw InputOutputError("cannot draw a plot: what gnuplot drew is not whole");
  }
  return picture;
}

void write_plot(const fs::path& file, const std::string& script) {
  write_file(file, gnuplot(script));
}

}  // namespace stickslip::report::tools
