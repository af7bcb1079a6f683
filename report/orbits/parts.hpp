// The parts of an orbit that all of its reports share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numeric/attractors/attractors.hpp"
#include "numeric/orbits.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/orbits.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::orbits {

// A ball with as many digits as are worth it, at most so many; nothing of one that is unbounded; each under
// its name.
[[nodiscard]] BallText ball_text(const Ball& value, int digits);
[[nodiscard]] std::optional<BallText> ball_text(const std::optional<Ball>& value, int digits);
[[nodiscard]] Named<BallText> ball_texts(const std::vector<numeric::NamedBall>& values, int digits);
// A sentence without its marks; nothing if it is empty.
[[nodiscard]] std::optional<std::string> if_any(const std::string& sentence);

// What writes a result in the units.
template <class Result>
[[nodiscard]] auto in_units(void (*write)(tools::Object&, const Result&, const Units&),
                            const Units& units = {}) {
  return [write, units](tools::Object& json, const Result& result) { write(json, result, units); };
}

// What results share as JSON (report/tools/schema.hpp). Where they come from: the command that gives them
// again; beside them may stand the machine in SI units.
void write_origin(tools::Object& json, const std::string& command);
void write_machine(tools::Object& json, const numeric::DataTaken& taken);
void write_condition(tools::Object& json, const numeric::motion::Condition& condition);
[[nodiscard]] tools::Json to_json(const numeric::motion::Condition& condition);
// "admissible": true, false, or null when it is neither proved nor refuted.
void write_admissible(tools::Object& json, const Verdict& admissible);
// "multipliers", "stability", "stability_reason", if it is known; of a stable orbit "contact" of
// numeric/motion/stability.hpp.
void write_stability(tools::Object& json, const std::optional<numeric::motion::Stability>& stability,
                     const std::vector<numeric::motion::Condition>& conditions, int digits);
// Of an attractor, what is known of it; with how many of the starts end on it.
enum class Share { told, untold };
void write_attractor(tools::Object& json, const numeric::attractors::Attractor& attractor, int digits,
                     const Units& units, Share share = Share::told);
// "parameters": {"chi", ..., "p", "ur"}.
void write_parameters(tools::Object& json, const numeric::words::WordQuestion& machine);
// "durations" of a motion's phases.
void write_durations(tools::Object& json, const numeric::motion::Motion& motion, int digits,
                     const Units& units);
// Keywords of the schema: of a word of phases, of how many periods of the load.
[[nodiscard]] tools::Json like_word();
[[nodiscard]] tools::Json like_periods();
[[nodiscard]] tools::Json family_names();
[[nodiscard]] tools::Json like_number_or_range();

// What is known of an attractor: "proved, stable, |mu| = 0.6545, overshooting".
[[nodiscard]] std::string remark(const numeric::attractors::Attractor& attractor);
// "0.1,0.2,0.3,0.4"
[[nodiscard]] std::string state_of(const model::Vector4<double>& X);
// What was asked, and what is known of pure slip and stick.
[[nodiscard]] std::vector<tools::Row> rows_of(const numeric::attractors::AttractorList& list);
// How little it takes to leave a stable orbit; empty where that is not known.
[[nodiscard]] std::string contact_in_words(const numeric::Orbit& orbit);

// A word as a table bears it, "OSOSOSTOTSOSTOSOSO... (34)".
[[nodiscard]] std::string shortened(const std::string& word);

// The largest modulus of a multiplier, rounded up, with as many digits as tell it from 1.
[[nodiscard]] std::string spectral_radius(const numeric::motion::Stability& stability);
// Of the conditions of one kind the one with the worst verdict, then the least margin.
[[nodiscard]] std::vector<numeric::motion::Condition> worst(
    const std::vector<numeric::motion::Condition>& conditions);

// A condition's margin or its time, to a few digits; empty if it is not known.
[[nodiscard]] std::string shown(const std::optional<Ball>& margin);

// For a terminal: the escape sequences, empty without colours; lines that begin with two spaces.
[[nodiscard]] std::string bold(const tools::Style& style);
// A heading, and the rows below it.
[[nodiscard]] std::string headed(const std::string& heading, const std::vector<tools::Row>& rows,
                                 const tools::Style& style);
[[nodiscard]] std::string colour_of(Truth truth, const tools::Style& style);
[[nodiscard]] std::string condition_rows(const std::vector<numeric::motion::Condition>& conditions,
                                         const tools::Style& style);

}  // namespace stickslip::report::orbits

// Samples for schemas.
template <>
struct stickslip::report::tools::SampleOf<stickslip::numeric::DataTaken> {
  [[nodiscard]] static numeric::DataTaken made() { return numeric::data_taken({1, 1, 1, 1, 1, 2, 1, 1, 1}); }
};
template <>
struct stickslip::report::tools::SampleOf<stickslip::numeric::words::WordQuestion> {
  [[nodiscard]] static numeric::words::WordQuestion made() {
    numeric::words::WordQuestion machine;
    machine.data = SampleOf<numeric::DataTaken>::made().data;
    machine.ur = 2;
    return machine;
  }
};
template <>
struct stickslip::report::tools::SampleOf<stickslip::numeric::words::WordOrbit> {
  [[nodiscard]] static numeric::words::WordOrbit made() {
    return {.word = numeric::words::Word::parse("OTS"), .existence = {}, .orbit = {}, .asked = {}};
  }
};
