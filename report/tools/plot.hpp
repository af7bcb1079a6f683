// Programs that draw, typeset and compile; pictures by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip::report::tools {

// Programs that draw, typeset and compile.

// A program, the Debian package that has it, and what it is wanted for: "draw a plot".
struct Tool {
  std::string program;
  std::string package;
  std::string purpose;
};

// Whether the program is found on the PATH.
[[nodiscard]] bool is_there(const Tool& tool);

// Throws InputOutputError naming the program and its package unless it is found on the PATH.
void require(const Tool& tool);

// What the program writes to its standard output for these arguments and this standard input, run in the
// directory if one is named. Throws InputOutputError when it is not there, or when it fails, with the first
// line of its complaint.
[[nodiscard]] std::string run(const Tool& tool, const std::vector<std::string>& arguments,
                              const std::string& input = {}, const std::filesystem::path& directory = {});

// What a program wrote, whether or not it failed.
struct Ran {
  bool succeeded = false;
  std::string output, complaints;  // to its standard output, and to standard error
};
// The same of a program that may fail. Throws InputOutputError when it is not there.
[[nodiscard]] Ran attempt(const Tool& tool, const std::vector<std::string>& arguments,
                          const std::string& input = {}, const std::filesystem::path& directory = {});

// The version in what a program says about itself: from the first digit to the end of the line.
[[nodiscard]] std::string version_in(const std::string& text);

// A directory for other programs to work in.

// A directory of its own, gone with all that is in it.
class Workshop {
 public:
  // Throws InputOutputError, which says what it was for ("compile LaTeX"), if none can be made.
  explicit Workshop(const std::string& purpose);
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // Of a file in it; empty if it is not there.
  [[nodiscard]] std::string content(const std::string& file) const;

 private:
  std::filesystem::path path_;
};

// Pictures by gnuplot.

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
