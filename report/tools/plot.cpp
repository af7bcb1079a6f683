#include "report/tools/plot.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/error.hpp"
#include "report/tools/files.hpp"
#include "report/tools/process.hpp"

namespace stickslip::report::tools {
namespace {

namespace fs = std::filesystem;

const Tool& plotter() {
  static const Tool tool{"gnuplot", "gnuplot-nox", "draw a plot"};
  return tool;
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
  if (!text.ends_with("</svg>") && !text.ends_with("%%EOF")) {
    throw InputOutputError("cannot draw a plot: what gnuplot drew is not whole");
  }
  return picture;
}

void write_plot(const fs::path& file, const std::string& script) {
  write_file(file, gnuplot(script));
}

}  // namespace stickslip::report::tools
