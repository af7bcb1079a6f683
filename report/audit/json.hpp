// An audit as JSON: the published form of the results, and the data that the pages are made from.
#pragma once

#include <string>
#include <vector>

#include "proofs/checks/mutants.hpp"
#include "proofs/methods/motions.hpp"
#include "report/audit/certificate_record.hpp"
#include "report/audit/summary.hpp"
#include "report/tools/schema.hpp"

namespace stickslip::report::audit {

// Every key is always there; numbers are decimal strings or balls
// {"mid", "rad"} rounded outwards, except for counts. The same audit gives the same text, always. The
// examples are empty, and the mutants null, unless they were asked for.
[[nodiscard]] tools::Json to_json(const Audited& all, const std::string& command = "stickslip audit",
                                  const std::vector<proofs::methods::ExampleOrbits>& examples = {},
                                  const std::optional<proofs::checks::Gate>& gate = {},
                                  const Certification& certificates = {});

// Of that JSON.
[[nodiscard]] tools::File schema();

}  // namespace stickslip::report::audit
