#include "report/orbits/motions_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/parallel.hpp"

namespace stickslip::report::orbits {

using namespace tools;

Json page_on_motions(const PageFrame& frame, const std::string& title, const std::string& command, int digits,
                     const std::string& of_period, const std::string& pictures) {
  Json data = page_data(
      frame, title, command,
      fmt::format(
          "motions are followed in floating point; periodic ones are then proved in balls, their values "
          "enclosed to {} significant digits, and computed with more bits wherever a verdict needs them",
          digits));
  data["attractors"] = Json::array();
  data["of_period"] = of_period;
  data["pictures"] = pictures;
  data["along"] = nullptr;
  data["basins"] = nullptr;
  data["data_file"] = "";
  return data;
}

void add_motions(Json& data, std::vector<File>& files, std::size_t count,
                 const std::function<MotionOnPage(std::size_t)>& of) {
  struct Drawn {
    Json data;
    std::vector<File> pictures;
  };
  for (Drawn& one : parallel_map(count, [&](std::size_t i) {
         const MotionOnPage motion = of(i);
         Drawn result{{{"number", i + 1},
                       {"name", motion.name},
                       {"tone", motion.tone},
                       {"tell", motion.tell},
                       {"rows", rows_data(motion.rows)},
                       {"picture", nullptr},
                       {"picture_in_words", ""}},
                      {}};
         if (motion.portrait) {
           const std::string stem = fmt::format("portrait-{}", i + 1);
           result.data["picture"] = stem;
           result.data["picture_in_words"] = picture_in_words(*motion.portrait, motion.labels);
           result.pictures = screen_pictures(
               [&](PlotFormat format, PlotShape shape) {
                 return plot_script(*motion.portrait, format, shape, motion.labels);
               },
               stem);
         }
         return result;
       })) {
    data["attractors"].push_back(std::move(one.data));
    std::ranges::move(one.pictures, std::back_inserter(files));
  }
}

Row row_of_starts(const numeric::attractors::Ending& a) {
  return {{"starts"},
          {fmt::format("{}: {:.1f} %, within {:.1f} and {:.1f} %", a.count, 100 * a.share, 100 * a.least,
                       100 * a.most)}};
}

}  // namespace stickslip::report::orbits
