// How the boxes of an atlas are judged, family by family.
#pragma once

#include "numeric/atlas/knowledge.hpp"
#include "numeric/atlas/question.hpp"

namespace stickslip::numeric::atlas {

// Of the family of the question, for all members of a box within its domain: what judge() returns, and what
// becomes of `known`. `last`: no box is smaller.
struct Judges {
  using Judge = Finding (*)(const Question&, const Box&, bool last, Knowledge& known);
  Judge in_doubles, in_balls;
};

}  // namespace stickslip::numeric::atlas
