#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::methods {

std::string to_string(Kind kind) {
  switch (kind) {
    case Kind::definition:
      return "definition";
    case Kind::model:
      return "model";
    case Kind::identity:
      return "identity";
    case Kind::step:
      return "step";
    case Kind::theorem:
      return "theorem";
    case Kind::condition:
      return "condition";
    case Kind::numbers:
      return "numbers";
    case Kind::check:
      return "check";
  }
  return {};
}

std::string to_string(Status status) {
  switch (status) {
    case Status::as_printed:
      return "as_printed";
    case Status::needs_hypotheses:
      return "needs_hypotheses";
    case Status::misprint_corrected:
      return "misprint_corrected";
    case Status::digits_off:
      return "digits_off";
    case Status::necessary_not_sufficient:
      return "necessary_not_sufficient";
    case Status::refuted:
      return "refuted";
    case Status::undecided:
      return "undecided";
    case Status::rests_on_unproved:
      return "rests_on_unproved";
    case Status::model:
      return "model";
    case Status::checked:
      return "checked";
  }
  return {};
}

bool is_status(const std::string& word) {
  for (int i = 0; i <= static_cast<int>(Status::checked); ++i) {
    if (to_string(static_cast<Status>(i)) == word) {
      return true;
    }
  }
  return false;
}

std::string describe(Status status) {
  switch (status) {
    case Status::as_printed:
      return "proved as printed";
    case Status::needs_hypotheses:
      return "proved under a hypothesis that the paper does not state";
    case Status::misprint_corrected:
      return "misprint: refuted as printed, the corrected form is proved";
    case Status::digits_off:
      return "printed digits are not the correctly rounded ones";
    case Status::necessary_not_sufficient:
      return "proved to be necessary, refuted to be sufficient";
    case Status::refuted:
      return "refuted";
    case Status::undecided:
      return "undecided";
    case Status::rests_on_unproved:
      return "proved, but something that it uses is not";
    case Status::model:
      return "part of the model, taken as given";
    case Status::checked:
      return "agrees with a computation in floating point, which proves nothing";
  }
  return {};
}

}  // namespace stickslip::proofs::methods
