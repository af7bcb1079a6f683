#include "report/orbits/attractors/many_starts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/scalars/scalars.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/prose.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace tools;

namespace {

constexpr std::array colours{"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e", "#9467bd",
                             "#8c564b", "#e377c2", "#17becf", "#bcbd22", "#7f7f7f"};
constexpr std::array kinds{Kind::periodic, Kind::quasi_periodic, Kind::irregular, Kind::slides,
                           Kind::stuck,    Kind::grows,          Kind::unsettled};

const char * colour(std::size_t k) {
  return colours[k % colours.size()];
}

const char * stable(const ToldEnding& a) {
  const motion::StabilityKind kind = a.stability ? a.stability->kind : motion::StabilityKind::undecided;
  return kind == motion::StabilityKind::stable ? "yes" : kind == motion::StabilityKind::unstable ? "no" : "";
}

// "x1,x2,x1',x2'", with their units.
std::string states_named(const SeenOscillator& o) {
  return enumerated(o.coordinates, named, ",");
}

// Kind, period, word, as a table for programs has them.
std::string kind_of(const Ending& a) {
  const bool periodic = a.kind == Kind::periodic;
  return fmt::format("{},{},{}", to_string(a.kind), periodic ? std::to_string(a.periods) : "", a.word);
}

// "54 % OTS (1), 46 % quasi-periodic".
std::string shares(const std::vector<ToldEnding>& all, int decimals) {
  return enumerated(
      all, [&](const ToldEnding& a) { return fmt::format("{:.{}f} % {}", 100 * a.share, decimals, a.name); });
}

// A line of a diagram's table: the value, and what the starts end on there.
Row line_of(const PointAlong<ToldEnding, Eigen::VectorXd>& point) {
  return {{fmt::format("{:.6g}", point.value.get_d())},
          {point.outside.empty() ? shares(point.attractors, 0) : point.outside}};
}

Eigen::Index place(const SeenOscillator& o) {
  return static_cast<Eigen::Index>(o.drawn);
}

std::array<std::size_t, 2> places(const ToldPlane& b) {
  return {static_cast<std::size_t>(b.across[0]), static_cast<std::size_t>(b.across[1])};
}

// What the picture along a number shows.
std::string drawn_in_words(const ToldAlong& d) {
  return d.oscillator.coordinates[d.oscillator.drawn].name +
         (d.oscillator.has_load ? " once a period of the load" : " where the phases begin");
}

std::string plane_in_words(const ToldPlane& b) {
  const std::vector<Coordinate>& all = b.oscillator.coordinates;
  const bool in_SI = !all.front().unit.empty();
  return fmt::format("{},{} from {} to {}{}, {} x {} starts{}", all[places(b)[0]].name,
                     all[places(b)[1]].name, comma_separated(b.starts.front()),
                     comma_separated(b.starts.back()), in_SI ? " in m and m/s" : "", b.pixels[0], b.pixels[1],
                     b.interrupted ? "; interrupted" : "");
}

std::string proved_in_words(const ToldPlane& b) {
  return fmt::format(
      "of {} of {} pixels, {} %: all of their starts converge to the orbit; of the others the middles are "
      "followed in floating point",
      std::ranges::count(*b.proved, char{1}), b.proved->size(), below(100 * b.proved_share, 4));
}

// With what it is about.
std::string titled(const std::string& title, const SeenOscillator& o, const std::vector<Row>& question,
                   const Style& style) {
  std::vector<Row> rows = o.rows;
  rows.insert(rows.end(), question.begin(), question.end());
  return headed(title, rows, style) + "\n";
}

}  // namespace

Eigen::VectorXd told(const Eigen::VectorXd& X, const std::vector<Coordinate>& coordinates) {
  Eigen::VectorXd result = X;
  for (Eigen::Index k = 0; k < X.size(); ++k) {
    result(k) *= coordinates[static_cast<std::size_t>(k)].factor;
  }
  return result;
}

std::string comma_separated(const Eigen::VectorXd& X) {
  return enumerated(
      X, [](double x) { return fmt::format("{:.17g}", x); }, ",");
}

std::string short_name(const Ending& a, bool has_load) {
  return a.kind != Kind::periodic ? to_string(a.kind)
         : has_load               ? fmt::format("{} ({})", shortened(a.word), a.periods)
                                  : shortened(a.word);
}

std::string remark_on_others(const Ending& a, bool has_load) {
  switch (a.kind) {
    case Kind::irregular:
    case Kind::quasi_periodic:
      return fmt::format("Lyapunov exponent {:.2g} per period of the load", a.lyapunov.value_or(0));
    case Kind::slides:
      return "no contact with the belt any more";
    case Kind::stuck:
      return "does not leave the belt any more";
    case Kind::grows:
      return "proved: omega is a natural frequency, and pi p > 4 eta ur";
    case Kind::unsettled:
      return a.is_too_slow
                 ? "a period of the load takes more than two million steps of simulation: too slow to be "
                   "followed"
             : has_load ? "within the periods allowed"
                        : "within the events allowed";
    case Kind::periodic:
      break;
  }
  throw InternalError("a periodic motion is none of the others");
}

std::string remark_on_periodic(const Verdict& existence, const Verdict& admissible,
                               const std::string& otherwise,
                               const std::optional<motion::Stability>& stability) {
  if (existence.truth != Truth::proved) {
    return "not proved" + (existence.reason.empty() ? "" : ": " + plain(existence.reason));
  }
  if (admissible.truth != Truth::proved || !stability) {
    return admissible.truth != Truth::proved ? otherwise + ": " + plain(admissible.reason) : "proved";
  }
  const std::string radius =
      stability->multipliers.empty() ? "" : fmt::format(", |mu| = {}", spectral_radius(*stability));
  const std::string why = stability->reason.empty() ? "" : ": " + stability->reason;
  return fmt::format("proved, {}{}{}", to_string(stability->kind), why, radius);
}

std::string table_of(const std::vector<ToldEnding>& endings, const std::string& period,
                     WithInterval with_interval, const Style& style) {
  std::vector<Row> rows{{{"   "}, {"share"}, {"95 %"}, {"motion"}, {period}, {"word"}, {""}}};
  for (std::size_t i = 0; i < endings.size(); ++i) {
    const ToldEnding& a = endings[i];
    rows.push_back({{std::to_string(i + 1)},
                    {fmt::format("{:.1f} %", 100 * a.share)},
                    {fmt::format("{:.1f}-{:.1f}", 100 * a.least, 100 * a.most)},
                    {to_string(a.kind)},
                    {a.period},
                    {shortened(a.word)},
                    {a.remark}});
  }
  for (Row& row : rows) {
    if (with_interval == WithInterval::no) {
      row.erase(row.begin() + 2);
    }
  }
  return columns_of(rows, style.width);
}

std::string neighbourhoods_of(const std::vector<ToldEnding>& endings,
                              const std::vector<Coordinate>& coordinates, const Style& style) {
  std::string text;
  for (std::size_t k = 0; k < endings.size(); ++k) {
    if (endings[k].neighbourhood) {
      text += fmt::format("\n{} {}\n", k + 1, endings[k].name) +
              columns_of(neighbourhood_rows(*endings[k].neighbourhood, coordinates), style.width);
    }
  }
  return text;
}

std::string starts_in_words(long starts, std::uint64_t seed, long most_periods, bool has_load) {
  return fmt::format("{} at random, seed {}, each followed until it has settled or for {} {}", starts, seed,
                     most_periods, has_load ? "periods of the load" : "events");
}

std::string interruption_in_words(bool interrupted, long followed) {
  return interrupted
             ? fmt::format("; interrupted when {} of them were done, of which the shares are", followed)
             : "";
}

std::vector<Row> question_rows(const ToldAlong& d) {
  return {{{"along"},
           {fmt::format("{} from {} to {}, {} values", d.with_unit, to_string(d.from), to_string(d.to),
                        d.values)}},
          {{"starts"},
           {fmt::format("{} at random, seed {}, at each value{}", d.starts, d.seed,
                        d.interrupted ? "; interrupted" : "")}}};
}

std::vector<Row> question_rows(const ToldPlane& b) {
  std::vector<Row> rows{{{"plane"}, {plane_in_words(b)}}};
  if (b.proved) {
    rows.push_back({{"proved"}, {proved_in_words(b)}});
  }
  return rows;
}

std::string terminal_report(const ToldAlong& d, const Style& style) {
  std::vector<Row> rows{{{d.with_unit}, {"share, word (period)"}}};
  for (const auto& point : d.points) {
    rows.push_back(line_of(point));
  }
  return titled("What the machine does along " + d.number, d.oscillator, question_rows(d), style) +
         columns_of(rows, style.width);
}

std::string terminal_report(const ToldPlane& b, const Style& style) {
  const std::string recover = neighbourhoods_of(b.endings, b.oscillator.coordinates, style);
  return titled("Where starts in a plane end", b.oscillator, question_rows(b), style) +
         table_of(b.endings, b.oscillator.period, WithInterval::no, style) + recover +
         (recover.empty() ? "" : "\n" + labelled(0, "recovers", meaning_of_neighbourhood(), style.width));
}

std::string to_csv(const ToldAlong& d) {
  std::string text = fmt::format("{},attractor,share,kind,{},word,stable,{}\n", d.with_unit, d.oscillator.n,
                                 states_named(d.oscillator));
  for (const auto& point : d.points) {
    // To the nearest double, not towards zero.
    const std::string value = fmt::format("{:.17g}", scalars::scalar<double>(point.value));
    if (!point.outside.empty()) {
      text += value + ",,,outside the domain,,," + std::string(d.oscillator.coordinates.size(), ',') + "\n";
    }
    for (std::size_t k = 0; k < point.attractors.size(); ++k) {
      const ToldEnding& a = point.attractors[k];
      for (const Eigen::VectorXd& X : point.once[k]) {
        text += fmt::format("{},{},{:.17g},{},{},{}\n", value, k + 1, a.share, kind_of(a), stable(a),
                            comma_separated(X));
      }
    }
  }
  return text;
}

std::string to_csv(const ToldPlane& b) {
  std::string text = fmt::format("{},attractor,kind,{},word\n", states_named(b.oscillator), b.oscillator.n);
  for (std::size_t i = 0; i < b.starts.size() && !b.endings.empty(); ++i) {
    text +=
        fmt::format("{},{},{}\n", comma_separated(b.starts[i]), b.ends[i] + 1, kind_of(b.endings[b.ends[i]]));
  }
  return text;
}

std::string plot_script(const ToldAlong& d, PlotFormat format) {
  Json data = {{"terminal", terminal(format, 1000, 600)}};
  data["kinds"] = Json::array();
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    std::string table;
    for (const auto& point : d.points) {
      for (std::size_t i = 0; i < point.attractors.size(); ++i) {
        for (const Eigen::VectorXd& X : point.once[i]) {
          table += point.attractors[i].kind == kinds[k]
                       ? fmt::format("{:.8g} {:.8g}\n", point.value.get_d(), X(place(d.oscillator)))
                       : "";
        }
      }
    }
    if (!table.empty()) {
      const bool dense = kinds[k] == Kind::irregular || kinds[k] == Kind::quasi_periodic;
      data["kinds"].push_back({{"block", fmt::format("$kind{}", k)},
                               {"kind", to_string(kinds[k])},
                               {"colour", colour(k)},
                               {"size", dense ? "0.15" : "0.3"},
                               {"table", table},
                               {"first", data["kinds"].empty()}});
    }
  }
  if (data["kinds"].empty()) {
    return "";
  }
  data["parameter"] = d.with_unit;
  data["title"] = drawn_in_words(d) + ": " + d.oscillator.title;
  data["place"] = named(d.oscillator.coordinates[d.oscillator.drawn]);
  data["from"] = fmt::format("{:.8g}", d.from.get_d());
  data["to"] = fmt::format("{:.8g}", d.to.get_d());
  return render_file("diagram.gp", data, plain_format);
}

std::string plot_script(const ToldPlane& b, PlotFormat format) {
  if (b.endings.empty()) {
    return "";
  }
  const std::array<std::size_t, 2> at = places(b);
  Json data = {{"terminal", terminal(format, 900, 760)}};
  std::string table;
  for (std::size_t k = 0; k < b.starts.size(); ++k) {
    table += fmt::format("{:.8g} {:.8g} {}\n", b.starts[k](b.across[0]), b.starts[k](b.across[1]), b.ends[k]);
  }
  data["table"] = table;
  std::string open;
  for (std::size_t k = 0; b.proved && k < b.proved->size(); ++k) {
    open += (*b.proved)[k] != 0
                ? ""
                : fmt::format("{:.8g} {:.8g}\n", b.starts[k](b.across[0]), b.starts[k](b.across[1]));
  }
  if (!open.empty()) {
    data["open"] = {{"table", open}, {"words", "dots: followed in floating point; all else is proved"}};
  }
  data["attractors"] = Json::array();
  std::string palette;
  for (std::size_t k = 0; k < b.endings.size(); ++k) {
    data["attractors"].push_back({{"colour", colour(k)}, {"words", shares({b.endings[k]}, 1)}});
    palette += fmt::format("{}{} \"{}\"", k == 0 ? "" : ", ", k, colour(k));
  }
  // A palette has two colours at least.
  data["palette"] = b.endings.size() == 1 ? palette + fmt::format(", 1 \"{}\"", colour(0)) : palette;
  data["count"] = std::max<std::size_t>(b.endings.size(), 2);
  data["last"] = fmt::format("{}.5", std::max<std::size_t>(b.endings.size(), 2) - 1);
  data["parameters"] = b.oscillator.title;
  data["x"] = named(b.oscillator.coordinates[at[0]]);
  data["y"] = named(b.oscillator.coordinates[at[1]]);
  // To the outer edges of the pixels.
  const std::array<std::array<const char *, 2>, 2> edges{{{"left", "right"}, {"bottom", "top"}}};
  for (std::size_t k = 0; k < 2; ++k) {
    const double first = b.starts.front()(b.across[k]), last = b.starts.back()(b.across[k]);
    const double margin = (last - first) / static_cast<double>(std::max(b.pixels[k] - 1, 1L)) / 2;
    data[edges[k][0]] = fmt::format("{:.8g}", first - margin);
    data[edges[k][1]] = fmt::format("{:.8g}", last + margin);
  }
  return render_file("basins.gp", data, plain_format);
}

void add_along(Json& data, std::vector<File>& files, const ToldAlong& d) {
  data["along"] = {{"heading", "Along " + d.number},
                   {"parameter", d.with_unit},
                   {"picture", nullptr},
                   {"picture_in_words", drawn_in_words(d) + " against " + d.with_unit +
                                            "; the table below says what the starts end on"},
                   {"what_is_drawn", drawn_in_words(d) + ", of each motion that starts end on."},
                   {"points", list_of(d.points, [](const auto& point) {
                      const Row line = line_of(point);
                      return Json{{"value", line[0].text}, {"ends", line[1].text}};
                    })}};
  if (const std::string script = plot_script(d, PlotFormat::svg); !script.empty()) {
    data["along"]["picture"] = "diagram.svg";
    files.push_back({"diagram.svg", gnuplot(script)});
  }
}

void add_plane(Json& data, std::vector<File>& files, const ToldPlane& b) {
  if (const std::string script = plot_script(b, PlotFormat::svg); !script.empty()) {
    const std::string plane = plane_in_words(b);
    data["basins"] = {
        {"words", "Where starts in the plane of " + plane + " end." +
                      (b.proved ? " Proved " + proved_in_words(b) + "." : "")},
        {"picture_in_words", fmt::format("Starts in the plane of {}: {}.", plane, shares(b.endings, 1))}};
    files.push_back({"basins.svg", gnuplot(script)});
  }
}

void write_share(Object& json, const Ending& a) {
  json.has("share", a.share, {{"minimum", 0}, {"maximum", 1}});
  json.has(
      "share_interval", std::array{a.least, a.most},
      with({{"items", {{"type", "number"}, {"minimum", 0}, {"maximum", 1}}}}, "Wilson's interval of 95 %."));
  json.has("count", a.count, with({{"minimum", 1}}, "Of the starts."));
}

void write_lyapunov(Object& json, const Ending& a) {
  json.has("lyapunov", a.lyapunov, "Per period of the load, in the mean over the starts: a check, no proof.");
}

std::vector<std::vector<std::size_t>> rows_of_pixels(const std::vector<std::size_t>& ends, long columns,
                                                     std::size_t first) {
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (k % static_cast<std::size_t>(columns) == 0) {
      rows.emplace_back();
    }
    rows.back().push_back(ends[k] + first);
  }
  return rows;
}

void write_ends(Object& json, const std::vector<std::size_t>& ends, long columns) {
  json.has("at", rows_of_pixels(ends, columns),
           with({{"items", {{"type", "array"}, {"items", {{"type", "integer"}, {"minimum", 1}}}}}},
                "Of each row from below: on which attractor, 1, 2, ..., each start ends."));
}

}  // namespace stickslip::report::orbits
