// The machines in SI units that an atlas is made of, for its reports.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/ball.hpp"
#include "numeric/atlas/question.hpp"

namespace stickslip::report::atlas {

struct Machine {
  // As they were given, by their names: numbers or ranges. Empty where the data were given themselves.
  std::vector<std::pair<std::string, std::string>> values;
  bool holds_more = false;  // the box holds more than the data of these machines
  // What a datum is of the machine, by the datum's name: so many times the datum.
  struct InSI {
    std::string name;
    Ball factor;
  };
  std::map<std::string, InSI> axes;

  // What stands at that place of a box: its name, and a value of it to 15 digits, exactly where it is no
  // multiple.
  [[nodiscard]] std::string name_of(const numeric::atlas::Question& question, std::size_t place) const;
  [[nodiscard]] std::string text_of(const numeric::atlas::Question& question, std::size_t place,
                                    const Rational& value) const;
  [[nodiscard]] double value_of(const numeric::atlas::Question& question, std::size_t place,
                                const Rational& value) const;
};

}  // namespace stickslip::report::atlas
