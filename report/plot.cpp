#include "report/plot.hpp"

#include <fmt/format.h>

#include <system_error>

#include "core/error.hpp"
#include "report/files.hpp"
#include "report/process.hpp"

namespace stickslip::report {
namespace {

namespace fs = std::filesystem;

const Tool& plotter() {
  static const Tool tool{"gnuplot", "gnuplot-nox", "draw a plot"};
  return tool;
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
  require_gnuplot();
}

void require_gnuplot() {
  require(plotter());
}

std::string gnuplot_version() {
  return version_in(run(plotter(), {"--version"}));
}

std::string gnuplot(const std::string& script) {
  return run(plotter(), {}, script);
}

void write_plot(const fs::path& file, const std::string& script) {
  const std::string picture = gnuplot(script);
  if (picture.empty()) {
    throw InputOutputError(fmt::format("cannot write {}: gnuplot drew nothing", file.string()));
  }
  write_files(directory_of(file), {{file.filename().string(), picture}});
}

}  // namespace stickslip::report
