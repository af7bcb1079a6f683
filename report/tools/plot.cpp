#include "report/tools/plot.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

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
