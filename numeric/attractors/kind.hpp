// The kinds of motion that a simulation settles on, and how many of many starts end on one.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stickslip::numeric::attractors {

enum class Kind {
  periodic,        // after n periods of the load, with events in each n of them
  quasi_periodic,  // does not return, and neighbours do not leave it exponentially
  irregular,       // neighbours leave it exponentially
  slides,          // never touches the belt's speed again
  stuck,           // stays on a belt that does not move
  grows,           // beyond all bounds, proved
  unsettled,       // within the periods that were allowed
};

// "periodic", "quasi-periodic", "irregular", "slides", "stuck", "grows without bound",
// "unsettled".
[[nodiscard]] std::string to_string(Kind kind);

// What starts end on, whatever is proved of it.
struct Ending {
  Kind kind = Kind::unsettled;
  std::vector<std::size_t> members;       // which starts end on it
  long count = 0;                         // how many
  double share = 0, least = 0, most = 0;  // with Wilson's interval of 95 %
  std::string word;                       // periodic: its letters, in the first rotation
  long periods = 0;                       // periodic: n
  bool is_too_slow = false;        // unsettled: a period of the load takes too many steps to be followed
  std::optional<double> lyapunov;  // irregular, quasi-periodic: a check, the mean over its starts
};

// What many starts end on.
template <class Attractor>
struct Endings {
  // By falling count. Irregular motions are one entry, and so are those of each other kind that is not
  // periodic: a simulation cannot tell how many attractors they are.
  std::vector<Attractor> attractors;
  long simulated = 0;  // periods in all
  bool interrupted = false;
  long followed = 0;  // starts, until they had settled or for all periods; the shares are of these
};

// Wilson's interval of 95 % for a share of which `count` of `total` are a sample.
struct Interval {
  double least, most;
};
[[nodiscard]] Interval wilson(long count, long total);

}  // namespace stickslip::numeric::attractors
