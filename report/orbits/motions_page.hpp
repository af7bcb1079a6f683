// Pages on motions that were followed, one after the other with what is known of them and portraits: of any
// oscillator.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/kind.hpp"
#include "report/orbits/page.hpp"
#include "report/orbits/portraits.hpp"

namespace stickslip::report::orbits {

// What all have, for the template attractors.html; what a period is, and what pictures show, in words.
[[nodiscard]] tools::Json page_on_motions(const PageFrame& frame, const std::string& title,
                                          const std::string& command, int digits,
                                          const std::string& of_period, const std::string& pictures);
// A motion on it: its heading, its rows, and its portrait, if there is one.
struct MotionOnPage {
  std::string name, tone, tell;
  std::vector<tools::Row> rows;
  std::optional<Portrait> portrait;
  PortraitLabels labels = {};
};
// The motions that `of` makes of 0, 1, ...
void add_motions(tools::Json& data, std::vector<tools::File>& files, std::size_t count,
                 const std::function<MotionOnPage(std::size_t)>& of);
// How many of them have a picture.
inline constexpr std::size_t most_pictured = 24;
// "12: 2.4 %, within 1.4 and 4.2 %".
[[nodiscard]] tools::Row row_of_starts(const numeric::attractors::Ending& ending);

}  // namespace stickslip::report::orbits
