// Machines of the benchmarks, in tables and the paper's as such.
#pragma once

#include <string>

#include "bench/examples.hpp"
#include "cli/answers/machine_tables.hpp"
#include "report/tools/files.hpp"

namespace stickslip::bench {

[[nodiscard]] inline numeric::machines::Machine as_machine(const char * example, const char * ur) {
  return {model::friction_oscillator<Rational>(data(example), parse_rational(ur))};
}

// "two": example O with dampers beside its springs; "five": a damped chain of five masses on friction that
// falls in three pieces, whose orbit has 8 of them.
[[nodiscard]] inline numeric::machines::Machine machine_named(const std::string& name) {
  const std::string path = STICKSLIP_ROOT + std::string(name == "two" ? "/examples/machines/damped_O.toml"
                                                                      : "/bench/five_masses.toml");
  return cli::machine_in_tables(report::tools::read_file(path), path).value().machine;
}
// From where the motion settles on its orbit.
[[nodiscard]] inline Eigen::VectorXd begins_at(const std::string& name) {
  return name == "two" ? Eigen::VectorXd(Eigen::Vector4d(1.344, 3.70, -0.41, 0.99))
                       : Eigen::VectorXd(Eigen::VectorXd::Zero(10));
}

}  // namespace stickslip::bench
