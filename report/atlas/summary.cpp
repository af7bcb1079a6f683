#include "report/atlas/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
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

namespace {

std::string percent(std::uint64_t volume) {
  return fmt::format("{:.4f} %", 100 * share(volume).get_d());
}

std::string in_words(const Tally::Counts& c) {
  return fmt::format("{} orbit{}, {} admissible, {} stable", c.orbits, c.orbits == 1 ? "" : "s", c.admissible,
                     c.stable);
}

// Largest first.
template <class Key>
std::vector<std::pair<Key, std::uint64_t>> by_volume(const std::map<Key, std::uint64_t>& volumes) {
  std::vector<std::pair<Key, std::uint64_t>> rows(volumes.begin(), volumes.end());
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return rows;
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
  std::string text = tools::columns_of({{{"Atlas: " + q.family->title, orbits::bold(style)}}}, style.width) +
                     tools::columns_of(head, style.width);
  std::vector<tools::Row> rows{{{"share"}, {"proved in every point of it"}}};
  for (const auto& [counts, v] : by_volume(all.counts)) {
    rows.push_back({{percent(v)}, {in_words(counts)}});
  }
  if (rows.size() > 1) {
    text += "\n" + tools::columns_of(rows, style.width);
  }
  rows = {{{"share"}, {"left open"}}};
  for (const auto& [reason, v] : by_volume(all.reasons)) {
    rows.push_back({{percent(v)}, {sentence_of(*q.family, static_cast<std::uint8_t>(reason))}});
  }
  if (rows.size() > 1) {
    text += "\n" + tools::columns_of(rows, style.width);
  }
  return text;
}

namespace {

Json question_json(const Question& q, const std::string& command) {
  Json json = tools::provenance(command);
  json["family"] = q.family->name;
  json["axes"] = axis_names(q);
  for (std::size_t i = 0; i < q.region.size(); ++i) {
    json["parameters"][names_of(q)[i]] = q.region[i].text();
  }
  if (q.is_in_SI()) {
    json["units"] = "si";
  }
  return json;
}

}  // namespace

Json to_json(const Question& q, const std::vector<Leaf>& leaves) {
  const Tally all = tally(q, leaves);
  const auto exact = [](std::uint64_t v) { return share(v).get_str(); };
  Json json = question_json(q, "stickslip atlas " + text_of(q));
  json["resolution"] = q.resolution;
  json["boxes"] = all.leaves;
  json["volume"] = {{"decided", exact(all.decided)},
                    {"outside", exact(all.outside)},
                    {"open", exact(all.open)},
                    {"not_examined", exact(volume(whole) - all.covered())}};
  json["counts"] = tools::list_of(by_volume(all.counts), [&](const auto& row) {
    return Json{{"orbits", row.first.orbits},
                {"admissible", row.first.admissible},
                {"stable", row.first.stable},
                {"volume", exact(row.second)}};
  });
  json["reasons"] = tools::list_of(by_volume(all.reasons), [&](const auto& row) {
    return Json{{"reason", plain(sentence_of(*q.family, static_cast<std::uint8_t>(row.first)))},
                {"volume", exact(row.second)}};
  });
  return json;
}

std::string terminal_report(const Question& q, const Verification& found) {
  return fmt::format(
      "{} boxes, of which {} were proved again: {} confirmed, {} contradicted, {} not decided again\n{}",
      found.boxes, found.proved_again(), found.confirmed, found.contradicted.size(), found.not_decided_again,
      found.contradicted.empty() ? "" : to_csv(q, found.contradicted));
}

Json to_json(const Question& q, const Verification& found, const std::string& command) {
  Json json = question_json(q, command);
  json["boxes"] = found.boxes;
  json["proved_again"] = found.proved_again();
  json["confirmed"] = found.confirmed;
  json["not_decided_again"] = found.not_decided_again;
  json["contradicted"] = tools::list_of(found.contradicted, [&](const Leaf& leaf) {
    Json one{{"box", Json::object()}};
    const Box box = box_of(q, leaf.tile);
    for (const std::size_t axis : q.axes) {
      one["box"][names_of(q)[axis]] = {to_string(box[axis].lower), to_string(box[axis].upper)};
    }
    const Finding& f = leaf.finding;
    for (const auto& [name, count] :
         {std::pair("orbits", f.orbits), {"admissible", f.admissible}, {"stable", f.stable}}) {
      if (count >= 0) {
        one[name] = count;
      }
    }
    if (!f.is_decided()) {
      one["reason"] = sentence_of(*q.family, f.reason);
    }
    return one;
  });
  return json;
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
