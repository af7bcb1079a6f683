// Where all motions from a box of starts are after some time.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "numeric/machines/basins/set_of_motions.hpp"

namespace stickslip::numeric::machines {

struct SetAfterQuestion {
  Machine machine;
  Eigen::VectorXd middle, half;  // of (x, x') at time 0; half >= 0, 0 for a number that all have in common
  double theta = 0;              // the load's phase then
  double time = 0;               // > 0, exact
  long most_parts = 2000;        // that are followed
};

struct SetAfter {
  SetAfterQuestion question;
  // Of the box, with all events in one order.
  struct Part {
    Eigen::VectorXd middle, half;
    std::vector<Piece> pieces;  // one after the other
    Vector states;              // contains (x, x') of all of its motions then

    // One letter for each phase, also where it goes through several pieces of the law.
    [[nodiscard]] std::string phases() const;
  };
  std::vector<Part> parts;
  std::map<std::string, double> open;  // why the rest is not decided, with the shares of the box
  bool interrupted = false;

  // Of the box, that the parts make up.
  [[nodiscard]] double share(const Part& part) const;
  [[nodiscard]] double proved() const;
  // Contains (x, x') of all motions from the parts; nothing without a part.
  [[nodiscard]] Vector hull() const;
};

// Each part is halved until all of its motions have their events in one order, by its side along which the
// derivative changes most. Throws DomainError for sizes that do not fit, a time that is not positive, and as
// require_machine does.
[[nodiscard]] SetAfter set_after(const SetAfterQuestion& question);

}  // namespace stickslip::numeric::machines
