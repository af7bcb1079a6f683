// Words: one for all rotations, and which texts are none.
#include "numeric/words/word.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "core/error.hpp"

using namespace stickslip;
using namespace stickslip::numeric::words;

TEST_CASE("a word is written in the rotation that comes first in the alphabet") {
  CHECK(Word::parse("SOT").letters() == "OTS");
  CHECK(Word::parse("TSO").letters() == "OTS");
  CHECK(Word::parse("STO").letters() == "OST");
  CHECK(Word::parse("TS").letters() == "ST");
  CHECK(Word::parse("OSTOSOTS").letters() == "OSOTSOST");
  CHECK(Word::parse("STO") != Word::parse("SOT"));
}

TEST_CASE("the first rotation is the least of all, and all rotations are one word") {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    std::string text = "S";
    const std::size_t length = 2 + random() % 12;
    while (text.size() < length || text.back() == text.front()) {
      text += text.back() == 'S'   ? "OT"[random() % 2]
              : text.back() == 'O' ? "ST"[random() % 2]
                                   : "SO"[random() % 2];
    }
    std::string least = text;
    std::string turned = text;
    for (std::size_t i = 0; i < text.size(); ++i) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      least = std::min(least, turned);
      CHECK(Word::parse(turned) == Word::parse(text));
    }
    CHECK(Word::parse(text).letters() == least);
  }
}

TEST_CASE("how often a word repeats a shorter one") {
  CHECK(Word::parse("ST").repetitions() == 1);
  CHECK(Word::parse("STST").repetitions() == 2);
  CHECK(Word::parse("OTSOTSOTS").repetitions() == 3);
  CHECK(Word::parse("STSO").repetitions() == 1);
  CHECK(Word::parse("SOSTSOST").repetitions() == 2);
}

TEST_CASE("what is no word is refused in words") {
  for (const char * text : {"", "S", "O", "T", "SS", "TT", "SOS", "TOOT", "STX", "st", "S T", "STST\n"}) {
    CAPTURE(text);
    CHECK_THROWS_AS((void)Word::parse(text), UsageError);
  }
  CHECK_THROWS_WITH(
      (void)Word::parse("SOS"),
      "'SOS' is not a word of phases: S follows S from its end to its start, and a phase ends only "
      "where another kind begins");
}
