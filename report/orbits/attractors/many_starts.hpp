// What many starts end on, along a number and over a plane, for readers and as pictures: of any oscillator.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "numeric/attractors/many_starts.hpp"
#include "numeric/motion/stability.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
#include "report/orbits/page.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/plot.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// An oscillator as readers see it.
struct SeenOscillator {
  std::vector<tools::Row> rows;         // what it is, a label and a sentence each
  std::string title;                    // the same in pictures
  std::vector<Coordinate> coordinates;  // of (x, x')
  std::size_t drawn = 0;                // which of them stands for the motion in a diagram
  bool has_load = true;
  std::string period = "period";  // what stands over periods, and over n in tables for programs
  const char * n = "period";
};

// What starts end on, and what is known of that.
struct ToldEnding : numeric::attractors::Ending {
  std::string name;    // "OTS (1)", or its kind
  std::string period;  // as a table has it; empty where it is not known
  std::string remark;  // "proved, stable, |mu| = 0.6545"
  std::optional<numeric::motion::Stability> stability;
  std::shared_ptr<const numeric::machines::Neighbourhood> neighbourhood;
};

// Along a number. States are in the units of the coordinates.
struct ToldAlong {
  SeenOscillator oscillator;
  std::string number, with_unit;  // its name
  Rational from, to;
  long values = 0, starts = 0;
  std::uint64_t seed = 1;
  std::vector<numeric::attractors::PointAlong<ToldEnding, Eigen::VectorXd>> points;
  bool interrupted = false;
};

// Over a plane.
struct ToldPlane {
  SeenOscillator oscillator;
  std::array<int, 2> across{0, 1};
  std::array<long, 2> pixels{};
  std::vector<Eigen::VectorXd> starts;  // row by row
  std::vector<ToldEnding> endings;
  std::vector<std::size_t> ends;                 // on which of them each start ends
  std::optional<std::vector<char>> proved = {};  // which pixels are, if that was asked
  double proved_share = 0;
  bool interrupted = false;
};

// The numbers in the units of the coordinates.
[[nodiscard]] Eigen::VectorXd told(const Eigen::VectorXd& X, const std::vector<Coordinate>& coordinates);
// "1,2,3,4", with 17 digits.
[[nodiscard]] std::string comma_separated(const Eigen::VectorXd& X);

// "OTS (1)", "OTS" without a load, or its kind.
[[nodiscard]] std::string short_name(const numeric::attractors::Ending& ending, bool has_load = true);
// What is known of a motion that is not periodic.
[[nodiscard]] std::string remark_on_others(const numeric::attractors::Ending& ending, bool has_load = true);
// Of a periodic one, with what is said of its orbit if that exists and is not admissible.
[[nodiscard]] std::string remark_on_periodic(const Verdict& existence, const Verdict& admissible,
                                             const std::string& otherwise,
                                             const std::optional<numeric::motion::Stability>& stability);

// A line for each: number, share, with Wilson's interval where that is asked for, motion, period under this
// name, word, what is known.
enum class WithInterval { no, yes };
[[nodiscard]] std::string table_of(const std::vector<ToldEnding>& endings, const std::string& period,
                                   WithInterval with_interval, const tools::Style& style);
// The neighbourhoods of those that have one.
[[nodiscard]] std::string neighbourhoods_of(const std::vector<ToldEnding>& endings,
                                            const std::vector<Coordinate>& coordinates,
                                            const tools::Style& style);
// "500 at random, seed 1, each followed until it has settled or for 20000 periods of the load".
[[nodiscard]] std::string starts_in_words(long starts, std::uint64_t seed, long most_periods, bool has_load);
// Behind it: nothing, unless it was interrupted.
[[nodiscard]] std::string interruption_in_words(bool interrupted, long followed);

// A line for each value: the shares of what the starts end on. The plane, then a line for each of what they
// end on.
[[nodiscard]] std::string terminal_report(const ToldAlong& along, const tools::Style& style);
[[nodiscard]] std::string terminal_report(const ToldPlane& plane, const tools::Style& style);

// Names, then a line for each state that is drawn of each attractor: the number, attractor (1, 2, ... at this
// value), share, kind, period, word, stable (yes, no or empty), the state; a value outside the domain has its
// own line with that as the kind. Numbers with 17 digits.
[[nodiscard]] std::string to_csv(const ToldAlong& along);
// Names, then a line for each start: the state, attractor (1, 2, ...), kind, period, word.
[[nodiscard]] std::string to_csv(const ToldPlane& plane);

// Scripts for gnuplot: the coordinate that is drawn against the number, and the plane in a colour for each
// attractor. Empty where there is nothing to draw.
[[nodiscard]] std::string plot_script(const ToldAlong& along, tools::PlotFormat format);
[[nodiscard]] std::string plot_script(const ToldPlane& plane, tools::PlotFormat format);

// The same of a result that is told so, in these units if it has several.
template <class Result, class... Units>
concept OnManyStarts = requires(const Result& result, const Units&... units) {
  told(result, units...);
};
template <class Result, class... Units>
requires OnManyStarts<Result, Units...>
[[nodiscard]] std::string terminal_report(const Result& result, const tools::Style& style,
                                          const Units&... units) {
  return terminal_report(told(result, units...), style);
}
template <class Result, class... Units>
requires OnManyStarts<Result, Units...>
[[nodiscard]] std::string to_csv(const Result& result, const Units&... units) {
  return to_csv(told(result, units...));
}
template <class Result, class... Units>
requires OnManyStarts<Result, Units...>
[[nodiscard]] std::string plot_script(const Result& result, tools::PlotFormat format, const Units&... units) {
  return plot_script(told(result, units...), format);
}

// For the page: the question; the table and the picture along a number; the picture of a plane in words. The
// pictures are put to the files, if there is something to draw.
[[nodiscard]] std::vector<tools::Row> question_rows(const ToldAlong& along);
[[nodiscard]] std::vector<tools::Row> question_rows(const ToldPlane& plane);
void add_along(tools::Json& data, std::vector<tools::File>& files, const ToldAlong& along);
void add_plane(tools::Json& data, std::vector<tools::File>& files, const ToldPlane& plane);

// As JSON: "share", "share_interval", "count"; "lyapunov".
void write_share(tools::Object& json, const numeric::attractors::Ending& ending);
void write_lyapunov(tools::Object& json, const numeric::attractors::Ending& ending);

// The points of a diagram, each attractor, with its point, by `write`.
template <class Point, class Write>
void write_points(tools::Object& json, const std::vector<Point>& points, const char * once,
                  const Write& write) {
  json.list("points", points, [&](tools::Object& here, const Point& point) {
    here.has("value", point.value);
    using Attractor = typename decltype(point.attractors)::value_type;
    std::vector<std::pair<Attractor, typename decltype(point.once)::value_type>> found;
    for (std::size_t k = 0; k < point.attractors.size(); ++k) {
      found.emplace_back(point.attractors[k], point.once[k]);
    }
    here.list("attractors", found, [&](tools::Object& one, const auto& attractor) {
      write(one, attractor.first, point);
      one.has("once", attractor.second, once);
    });
    here.has("outside", point.outside.empty() ? std::nullopt : std::optional(point.outside),
             "Of the domain, in one sentence; nothing else is known then.");
  });
}

// "pixels", "from", "to" of a plane; "at", the attractors on which starts end, row by row.
void write_pixels(tools::Object& json, const std::array<long, 2>& pixels, const auto& starts) {
  json.has("pixels", pixels,
           tools::with({{"items", {{"type", "integer"}, {"minimum", 2}}}}, "Columns and rows."));
  json.has("from", starts.front(), "The first start.");
  json.has("to", starts.back(), "The last one.");
}
[[nodiscard]] std::vector<std::vector<std::size_t>> rows_of_pixels(const std::vector<std::size_t>& ends,
                                                                   long columns, std::size_t first = 1);
void write_ends(tools::Object& json, const std::vector<std::size_t>& ends, long columns);

}  // namespace stickslip::report::orbits
