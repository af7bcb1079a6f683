#include "report/orbits/pictures.hpp"

#include "report/orbits/orbits_plot.hpp"
#include "report/tools/katex.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace tools;

namespace {

// cairo dates every PDF, and no setting of it leaves that out; spaces in its place keep all offsets.
std::string undated(std::string pdf) {
  const std::string key = "/CreationDate (";
  for (std::size_t start = pdf.find(key); start != std::string::npos; start = pdf.find(key, start)) {
    const std::size_t end = pdf.find(')', start) + 1;
    pdf.replace(start, end - start, end - start, ' ');
  }
  return pdf;
}

}  // namespace

std::vector<File> screen_pictures(const ScriptOf& script, const std::string& stem) {
  const std::string wide = script(PlotFormat::svg, PlotShape::wide);
  if (wide.empty()) {
    return {};
  }
  return {{stem + ".svg", gnuplot(wide)},
          {stem + "-narrow.svg", gnuplot(script(PlotFormat::svg, PlotShape::narrow))}};
}

std::vector<File> pictures(const ScriptOf& script, const std::string& stem) {
  std::vector<File> files = screen_pictures(script, stem);
  if (!files.empty()) {
    files.push_back({stem + ".pdf", undated(gnuplot(script(PlotFormat::pdf, PlotShape::wide)))});
  }
  return files;
}

std::vector<File> pictures(const OrbitList& list, const std::string& stem, std::optional<std::size_t> only) {
  return pictures([&](PlotFormat format, PlotShape shape) { return plot_script(list, format, shape, only); },
                  stem);
}

void require_page_tools() {
  require_katex();
  require_gnuplot();
}

Json drawn_by() {
  return {{{"name", "gnuplot"}, {"version", gnuplot_version()}}};
}

}  // namespace stickslip::report::orbits
