// The map of an atlas with two axes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "report/atlas/summary.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/prose.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::atlas {

using namespace numeric::atlas;
using tools::Json;

namespace {

// From light to dark, then warm.
constexpr std::array palette{"#f0f9e8", "#ccebc5", "#a8ddb5", "#7bccc4", "#4eb3d3", "#2b8cbe", "#0868ac",
                             "#084081", "#fdd49e", "#fdbb84", "#fc8d59", "#e34a33", "#b30000"};
constexpr const char * open_colour = "#404040";
constexpr const char * outside_colour = "#ffffff";
constexpr int finest_drawn = 9;  // halvings of each axis

struct Kind {
  std::string words;
  std::string colour;
};

// What is seen, and by what place in that list a leaf is shown.
struct Legend {
  std::vector<Kind> kinds;
  std::map<Tally::Counts, std::size_t> counts;

  [[nodiscard]] std::size_t of(const Finding& f) const {
    if (f.is_decided()) {
      return counts.at({f.orbits, f.admissible, f.stable});
    }
    return kinds.size() - (f.reason == static_cast<std::uint8_t>(Reason::outside) ? 1 : 2);
  }
};

Legend legend_of(const Tally& all) {
  const auto percent = [](std::uint64_t v) { return 100 * share(v).get_d(); };
  Legend legend;
  for (const auto& [c, v] : tools::largest_first(all.counts)) {
    legend.counts[c] = legend.kinds.size();
    legend.kinds.push_back({fmt::format("{:.2f} %: {} orbits, {} admissible, {} stable", percent(v), c.orbits,
                                        c.admissible, c.stable),
                            palette[legend.kinds.size() % palette.size()]});
  }
  legend.kinds.push_back({fmt::format("{:.2f} %: left open", percent(all.open)), open_colour});
  legend.kinds.push_back({fmt::format("{:.2f} %: outside the domain", percent(all.outside)), outside_colour});
  return legend;
}

// What is shown in each cell of the picture: the largest leaf of it.
std::vector<std::size_t> painted(const std::vector<Leaf>& leaves, const Legend& legend, int halvings) {
  const std::size_t side = std::size_t{1} << halvings;
  std::vector<std::size_t> shown(side * side, legend.kinds.size() - 2);
  std::vector<std::uint64_t> size(side * side, 0);
  const auto range = [&](const Side& s) {
    return s.halvings <= halvings
               ? std::pair(s.place << (halvings - s.halvings), (s.place + 1) << (halvings - s.halvings))
               : std::pair(s.place >> (s.halvings - halvings), (s.place >> (s.halvings - halvings)) + 1);
  };
  for (const Leaf& leaf : leaves) {
    const auto [left, right] = range(numeric::atlas::side(leaf.tile, 0, 2));
    const auto [bottom, top] = range(numeric::atlas::side(leaf.tile, 1, 2));
    for (std::size_t y = bottom; y < top; ++y) {
      for (std::size_t x = left; x < right; ++x) {
        if (volume(leaf.tile) > size[y * side + x]) {
          size[y * side + x] = volume(leaf.tile);
          shown[y * side + x] = legend.of(leaf.finding);
        }
      }
    }
  }
  return shown;
}

// What does not vary, for the title: lines that fit.
std::string fixed(const Question& q) {
  constexpr std::size_t longest = 90;
  std::string text;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < q.region.size(); ++i) {
    if (!q.region[i].is_point()) {
      continue;
    }
    const std::string& name = names_of(q)[i];
    const std::string value = to_string(q.region[i].lower);
    const std::string one = q.is_in_SI() ? orbits::with_unit(name, value) : fmt::format("{}={}", name, value);
    text += text.empty() ? "" : ", ";
    if (q.is_in_SI() && (begin == 0 || text.size() - begin + one.size() > longest)) {
      text += "\\n";
      begin = text.size();
    }
    text += one;
  }
  return q.is_in_SI() ? text : tools::in_greek(text);
}

}  // namespace

std::string plot_script(const Question& q, const std::vector<Leaf>& leaves, tools::PlotFormat format) {
  if (q.axes.size() != 2) {
    throw UsageError("plot: a map needs two parameters that vary");
  }
  const int halvings = std::min(q.resolution, finest_drawn);
  const Legend legend = legend_of(tally(q, leaves));
  const std::vector<std::size_t> shown = painted(leaves, legend, halvings);
  const std::size_t side = std::size_t{1} << halvings;
  std::array<std::pair<double, double>, 2> ends;
  Json data{{"terminal", tools::terminal(format, 900, 860)}};
  for (std::size_t k = 0; k < 2; ++k) {
    const Interval& range = q.region[q.axes[k]];
    const std::size_t axis = q.axes[k];
    ends[k] = {range.lower.get_d(), range.upper.get_d()};
    const std::string name = k == 0 ? "x" : "y";
    const std::string said = names_of(q)[axis];
    data[name] = said + orbits::in_unit_of(said);
    data[name + "_from"] = fmt::format("{:.9g}", ends[k].first);
    data[name + "_to"] = fmt::format("{:.9g}", ends[k].second);
  }
  const auto middle = [&](std::size_t k, std::size_t i) {
    return ends[k].first +
           (ends[k].second - ends[k].first) * (static_cast<double>(i) + 0.5) / static_cast<double>(side);
  };
  std::string table;
  for (std::size_t y = 0; y < side; ++y) {
    for (std::size_t x = 0; x < side; ++x) {
      table += fmt::format("{:.9g} {:.9g} {}\n", middle(0, x), middle(1, y), shown[y * side + x]);
    }
  }
  data["table"] = table;
  data["kinds"] = Json::array();
  std::string colours;
  for (std::size_t k = 0; k < legend.kinds.size(); ++k) {
    colours += fmt::format("{}{} \"{}\"", k == 0 ? "" : ", ", k, legend.kinds[k].colour);
    if (std::find(shown.begin(), shown.end(), k) != shown.end()) {
      data["kinds"].push_back({{"colour", legend.kinds[k].colour}, {"words", legend.kinds[k].words}});
    }
  }
  data["palette"] = colours;
  data["count"] = legend.kinds.size();
  data["last"] = fmt::format("{}.5", legend.kinds.size() - 1);
  data["title"] = fmt::format("How many {} orbits there are, at {}", q.family->name, fixed(q));
  return tools::render_file("map.gp", data, tools::plain_format);
}

}  // namespace stickslip::report::atlas
