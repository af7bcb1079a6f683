// Pictures by gnuplot.
#pragma once

#include <filesystem>
#include <string>

namespace stickslip::report::tools {

enum class PlotFormat { svg, pdf, png };

// Two panels beside each other, or one: for a telephone.
enum class PlotShape { wide, narrow };

// By the ending of the file's name. Throws UsageError when that is none of .svg, .pdf and .png.
[[nodiscard]] PlotFormat plot_format(const std::filesystem::path& file);

// What `set terminal` of gnuplot is given for a picture of this size in pixels of the SVG.
[[nodiscard]] std::string terminal(PlotFormat format, int width, int height);

// Throws InputOutputError unless there is a gnuplot that runs and the file can be written, UsageError as
// plot_format does. Called before long work that ends in a picture.
void require_plot(const std::filesystem::path& file);

// Throws InputOutputError unless there is a gnuplot.
void require_gnuplot();

// "5.4 patchlevel 4".
[[nodiscard]] std::string gnuplot_version();

// What gnuplot writes to its standard output for the script. Throws InputOutputError when there is none or
// when it complains.
[[nodiscard]] std::string gnuplot(const std::string& script);

// Draws the script into the file, which appears whole or not at all.
void write_plot(const std::filesystem::path& file, const std::string& script);

}  // namespace stickslip::report::tools
