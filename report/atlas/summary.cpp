#include "report/atlas/summary.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/files.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::atlas {

using namespace numeric::atlas;
using tools::Json;
using tools::Object;

namespace {

std::string percent(std::uint64_t volume) {
  return fmt::format("{:.4f} %", 100 * share(volume).get_d());
}

std::string in_words(const Tally::Counts& c) {
  return fmt::format("{} orbit{}, {} admissible, {} stable", c.orbits, c.orbits == 1 ? "" : "s", c.admissible,
                     c.stable);
}

std::string parameters_of(const Question& q) {
  std::string text;
  for (std::size_t i = 0; i < q.region.size(); ++i) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", names_of(q)[i], q.region[i].text());
  }
  return text + (q.is_in_SI() ? " in SI units" : "");
}

}  // namespace

std::vector<std::string> all_reasons(const numeric::families::Family& family) {
  std::vector<std::string> sentences;
  const std::size_t count = static_cast<std::size_t>(Reason::condition) + family.requirements.size();
  for (std::size_t i = 0; i < count; ++i) {
    sentences.push_back(sentence_of(family, static_cast<std::uint8_t>(i)));
  }
  return sentences;
}

std::string terminal_report(const Question& q, const std::vector<Leaf>& leaves, const tools::Style& style) {
  const Tally all = tally(q, leaves);
  const std::uint64_t missing = volume(whole) - all.covered();
  std::string decided = fmt::format("{} of the volume", percent(all.decided));
  if (all.outside > 0) {
    decided += fmt::format("; {} lies outside the domain", percent(all.outside));
  }
  const std::string open =
      all.open == 0
          ? "nothing"
          : fmt::format("{}; known there in part: orbits in {} of the volume, admissible ones in {}",
                        percent(all.open), percent(all.orbits_known), percent(all.admissible_known));
  std::vector<tools::Row> head{
      {{q.is_in_SI() ? "machines" : "parameters"}, {parameters_of(q)}},
      {{"boxes"}, {fmt::format("{}, each side halved {} times at most", all.leaves, q.resolution)}},
      {{"decided"}, {decided}},
      {{"open"}, {open}}};
  if (missing > 0) {
    head.push_back(
        {{"missing"}, {fmt::format("{} was not looked at; go on with --resume", percent(missing))}});
  }
  std::string text = orbits::headed("Atlas: " + q.family->title, head, style);
  std::vector<tools::Row> rows{{{"share"}, {"proved in every point of it"}}};
  for (const auto& [counts, v] : tools::largest_first(all.counts)) {
    rows.push_back({{percent(v)}, {in_words(counts)}});
  }
  if (rows.size() > 1) {
    text += "\n" + tools::columns_of(rows, style.width);
  }
  rows = {{{"share"}, {"left open"}}};
  for (const auto& [reason, v] : tools::largest_first(all.reasons)) {
    rows.push_back({{percent(v)}, {sentence_of(*q.family, static_cast<std::uint8_t>(reason))}});
  }
  if (rows.size() > 1) {
    text += "\n" + tools::columns_of(rows, style.width);
  }
  return text;
}

namespace {

void write_question(Object& json, const Question& q, const std::string& command) {
  tools::write_provenance(json, command);
  json.has("family", q.family->name, orbits::family_names());
  json.has("axes", axis_names(q), tools::with({{"minItems", 1}, {"maxItems", 4}}, "Some of the parameters."));
  json.object(
      "parameters",
      [&](Object& to) {
        std::vector<std::pair<std::string, std::string>> ranges;
        for (std::size_t i = 0; i < q.region.size(); ++i) {
          ranges.emplace_back(names_of(q)[i], q.region[i].text());
        }
        to.each(ranges);
      },
      "Exact numbers, or A..B.");
  json.has("units", q.is_in_SI() ? std::optional("si") : std::nullopt,
           tools::with(tools::one_of({"si"}),
                       "The parameters are values of machines in SI units, under the names of their file."));
}

void write_volume(Object& json, const char * key, std::uint64_t volume) {
  json.has(key, share(volume).get_str(),
           tools::with({{"pattern", "^[0-9]+(/[0-9]+)?$"}}, "An exact fraction of the whole volume."));
}

void write_tally(Object& json, const Question& q, const Tally& all) {
  write_question(json, q, "stickslip atlas " + text_of(q));
  json.has("resolution", q.resolution,
           tools::with({{"minimum", 1}}, "Each axis is halved so many times at most."));
  json.has("boxes", all.leaves);
  json.object("volume", [&](Object& to) {
    write_volume(to, "decided", all.decided);
    write_volume(to, "outside", all.outside);
    write_volume(to, "open", all.open);
    write_volume(to, "not_examined", volume(whole) - all.covered());
  });
  json.list("counts", tools::largest_first(all.counts), [](Object& to, const auto& row) {
    const Json number = {{"minimum", 0}};
    to.has("orbits", row.first.orbits, number);
    to.has("admissible", row.first.admissible, number);
    to.has("stable", row.first.stable, number);
    write_volume(to, "volume", row.second);
  });
  json.list("reasons", tools::largest_first(all.reasons), [&](Object& to, const auto& row) {
    to.has("reason", plain(sentence_of(*q.family, static_cast<std::uint8_t>(row.first))));
    write_volume(to, "volume", row.second);
  });
}

void write_verification(Object& json, const Question& q, const Verification& found,
                        const std::string& command) {
  write_question(json, q, command);
  json.has("boxes", found.boxes);
  json.has("proved_again", found.proved_again(), "How many of them.");
  json.has("confirmed", found.confirmed, "Found to be as the atlas says.");
  json.has("not_decided_again", found.not_decided_again, "Left open this time.");
  json.list(
      "contradicted", found.contradicted,
      [&](Object& to, const Leaf& leaf) {
        const Finding& f = leaf.finding;
        to.object(
            "box",
            [&](Object& sides) {
              std::vector<std::pair<std::string, std::array<Rational, 2>>> ends;
              const Box box = box_of(q, leaf.tile);
              for (const std::size_t axis : q.axes) {
                ends.push_back({names_of(q)[axis], {box[axis].lower, box[axis].upper}});
              }
              sides.each(ends);
            },
            "The exact ends of each axis.");
        for (const auto& [name, count] :
             {std::pair("orbits", f.orbits), {"admissible", f.admissible}, {"stable", f.stable}}) {
          to.has(name, count < 0 ? std::nullopt : std::optional(count),
                 tools::with({{"minimum", 0}}, "As the atlas says; absent if not known."));
        }
        to.has("reason", f.is_decided() ? std::nullopt : std::optional(sentence_of(*q.family, f.reason)),
               "Why it is left open.");
      },
      "Boxes of which the atlas says what is false.");
}

}  // namespace

Json to_json(const Question& q, const std::vector<Leaf>& leaves) {
  return tools::written(tally(q, leaves), [&](Object& json, const Tally& all) { write_tally(json, q, all); });
}

Json to_json(const Question& q, const Verification& found, const std::string& command) {
  return tools::written(
      found, [&](Object& json, const Verification& it) { write_verification(json, q, it, command); });
}

std::vector<tools::File> schemas() {
  Question sample;
  sample.family = numeric::all_families().front();
  sample.region = {{0, 1}};
  sample.axes = {0};
  return {
      tools::schema_file(
          "atlas", "stickslip atlas: how many orbits there are over a range of parameters",
          tools::schema_by(Tally{}, [&](Object& json, const Tally& it) { write_tally(json, sample, it); })),
      tools::schema_file("verification", "stickslip atlas --verify: boxes of an atlas, proved again",
                         tools::schema_by(Verification{}, [&](Object& json, const Verification& it) {
                           write_verification(json, sample, it, "stickslip");
                         }))};
}

std::string terminal_report(const Question& q, const Verification& found) {
  return fmt::format(
      "{} boxes, of which {} were proved again: {} confirmed, {} contradicted, {} not decided again\n{}",
      found.boxes, found.proved_again(), found.confirmed, found.contradicted.size(), found.not_decided_again,
      found.contradicted.empty() ? "" : to_csv(q, found.contradicted));
}

std::string to_csv(const Question& q, const std::vector<Leaf>& leaves) {
  std::string text;
  for (const std::string& axis : axis_names(q)) {
    text += fmt::format("{0}_from,{0}_to,", axis);
  }
  text += "orbits,admissible,stable,reason\n";
  const auto count = [](std::int8_t n) { return n < 0 ? std::string() : std::to_string(n); };
  for (const Leaf& leaf : leaves) {
    const Box box = box_of(q, leaf.tile);
    for (const std::size_t axis : q.axes) {
      text += to_string(box[axis].lower) + "," + to_string(box[axis].upper) + ",";
    }
    const Finding& f = leaf.finding;
    text += fmt::format("{},{},{},{}\n", count(f.orbits), count(f.admissible), count(f.stable),
                        f.is_decided() ? "" : "\"" + sentence_of(*q.family, f.reason) + "\"");
  }
  return text;
}

std::string to_vtk(const Question& q, const std::vector<Leaf>& leaves) {
  constexpr std::array types{3, 8, 11};  // a line, a rectangle and a cuboid along the axes
  const std::size_t axes = q.axes.size();
  if (axes > types.size()) {
    throw UsageError("plot: a mesh has at most three parameters that vary");
  }
  const std::size_t corners = std::size_t{1} << axes;
  std::string text = fmt::format(
      "# vtk DataFile Version 3.0\nstickslip atlas {}\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n",
      q.family->name, corners * leaves.size());
  for (const Leaf& leaf : leaves) {
    const Box box = box_of(q, leaf.tile);
    for (std::size_t corner = 0; corner < corners; ++corner) {
      std::array<double, 3> x{};
      for (std::size_t k = 0; k < axes; ++k) {
        const Interval& side = box[q.axes[k]];
        x[k] = (((corner >> k) & 1) == 0 ? side.lower : side.upper).get_d();
      }
      text += fmt::format("{:.17g} {:.17g} {:.17g}\n", x[0], x[1], x[2]);
    }
  }
  text += fmt::format("CELLS {} {}\n", leaves.size(), (corners + 1) * leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    text += std::to_string(corners);
    for (std::size_t corner = 0; corner < corners; ++corner) {
      text += fmt::format(" {}", corners * i + corner);
    }
    text += "\n";
  }
  text += fmt::format("CELL_TYPES {}\n", leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    text += fmt::format("{}\n", types[axes - 1]);
  }
  text += fmt::format("CELL_DATA {}\n", leaves.size());
  const auto column = [&](const char * name, const auto& value) {
    text += fmt::format("SCALARS {} int 1\nLOOKUP_TABLE default\n", name);
    for (const Leaf& leaf : leaves) {
      text += fmt::format("{}\n", static_cast<int>(value(leaf.finding)));
    }
  };
  column("orbits", [](const Finding& f) { return f.orbits; });
  column("admissible", [](const Finding& f) { return f.admissible; });
  column("stable", [](const Finding& f) { return f.stable; });
  column("reason", [](const Finding& f) { return f.reason; });
  return text;
}

}  // namespace stickslip::report::atlas
