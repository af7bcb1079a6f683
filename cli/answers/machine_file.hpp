// A file of parameters: dimensionless ones, or a machine in SI units.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/arguments.hpp"
#include "numeric/machine_along.hpp"
#include "numeric/orbits.hpp"
#include "report/orbits/machine.hpp"
#include "report/tools/json.hpp"

namespace stickslip::cli {

// What is given: in the file, and beside it.
struct ParameterFile {
  TypedParameters typed;                      // these go before the file, which goes before the example's
  std::string example;                        // of the paper; empty if there is none
  std::string name;                           // of the file, likewise
  TypedParameters parameters;                 // dimensionless, without phi for a machine
  std::optional<numeric::DataTaken> machine;  // in SI units
  TypedParameters in_SI;                      // of the machine, as they stand in the file
  int digits = 0;                             // of a machine, that its texts have at most
  std::vector<std::string> left_out;          // a sentence for each
};

// What is in the file, or given in place of one; nothing if its name is empty. Throws InputOutputError when
// the file cannot be read, and as parse_parameters does.
[[nodiscard]] TypedParameters contents_of(const GivenFile& file);

enum class FrictionAtRest { needed, optional };

// The machine of which these are the parameters. Throws UsageError naming all that is missing and what does
// not go together, DomainError as numeric::data_taken does.
[[nodiscard]] numeric::MachineInSI machine_in_SI(const TypedParameters& parameters, const std::string& file,
                                                 FrictionAtRest at_rest);

// The same with options: these replace values of a machine in SI units under the names that they have in the
// file; no other option but phi goes with one, and no example. Throws as contents_of and machine_in_SI do.
// `one_of`: a machine among those that the values of one in SI units stand for; by default these are numbers.
[[nodiscard]] ParameterFile read_parameters(
    const GivenMachine& given, FrictionAtRest at_rest,
    const std::function<TypedParameters(const TypedParameters&)>& one_of = std::identity());

// The machine of the file, with the friction at rest if that is not left out, where one of its values varies:
// its data as functions of it. Throws as machine_in_SI does, UsageError for the load's phase, which moves
// none.
[[nodiscard]] numeric::MachineAlong machine_between(const ParameterFile& file, const std::string& name,
                                                    const Rational& from, const Rational& to);

// The error about a datum that was taken for a machine in SI units, with the key and value of its file before
// it; the same error if there is no such file.
[[nodiscard]] Error in_keys_of(const GivenFile& file, const DomainError& error);

// --digits, of each value of a result, 20 by default. For a machine in SI units texts then have as many;
// without --digits they have as many as the file's data deserve, two more than the one with the most, at
// least six.
[[nodiscard]] int digits_of(std::optional<int> asked, ParameterFile& file);

// Leaves out what is a result of the question, if it is in the file: one file serves every question about its
// machine. Throws UsageError for what is no number.
void leave_out(ParameterFile& file, const std::string& parameter, const std::string& why);
// The same for phi and ur where they are results of this family.
void leave_results_out(ParameterFile& file, const numeric::Family& family);

// What goes into the JSON of a report as "machine": nothing for dimensionless parameters.
[[nodiscard]] report::tools::Json with_machine(report::tools::Json json, const ParameterFile& file);

// What --units says: si, or those of (2); states that are typed are in them, too. Throws UsageError for si
// without a machine in SI units, and with JSON, which says in any case what its units are.
[[nodiscard]] report::orbits::Units units_of(bool si, const ParameterFile& file, bool json);
// A state that is typed in these units in those of (2).
[[nodiscard]] model::Vector4<double> in_data(const std::string& name, const State& state,
                                             const report::orbits::Units& units);

}  // namespace stickslip::cli
