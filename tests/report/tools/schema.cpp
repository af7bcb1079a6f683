#include "report/tools/schema.hpp"

#include <doctest/doctest.h>

#include <array>
#include <map>

#include "report/schemas.hpp"

using namespace stickslip;
using namespace stickslip::report::tools;

namespace {

struct Part {
  std::string name;
  std::optional<BallText> value;
};

struct Whole {
  std::vector<Part> parts;
  std::optional<Part> one, other;
  std::map<std::string, double> named;
};

void write_part(Object& json, const Part& part) {
  json.has("name", part.name, "Who.");
  json.has("value", part.value);
}

void write_whole(Object& json, const Whole& whole) {
  json.has("truth", Truth::refuted);
  json.has("exact", Rational(1, 3));
  json.has("pair", std::array{1, 2}, {{"uniqueItems", true}});
  json.list("parts", whole.parts, write_part, {{"minItems", 1}});
  json.or_null("one", whole.one, write_part);
  json.object_if("other", whole.other, write_part);
  json.keys_if(whole.other, [](Object& to, const Part& part) { to.has("count", part.name.size()); });
  json.object("named", [&](Object& to) { to.each(whole.named); });
}

}  // namespace

TEST_CASE("what is not there has no key, or is null") {
  const Json bare = written(Whole{}, write_whole);
  CHECK(bare == Json::parse(R"({"truth": "refuted", "exact": "1/3", "pair": [1, 2], "parts": [], "one": null,
                                "named": {}})"));
  const Part part{"a", BallText{"1", "0"}};
  const Json full = written(Whole{{part}, part, part, {{"x", 0.5}}}, write_whole);
  CHECK(full.at("one") == Json::parse(R"({"name": "a", "value": {"mid": "1", "rad": "0"}})"));
  CHECK(full.at("parts").at(0) == full.at("one"));
  CHECK(full.at("other") == full.at("one"));
  CHECK(full.at("count") == 1);
  CHECK(full.at("named").at("x") == 0.5);
}

TEST_CASE("a schema has every key with its type, whether the sample has it or not") {
  const Json schema = schema_by(Whole{}, write_whole);
  CHECK(schema.at("required") == Json::parse(R"(["truth", "exact", "pair", "parts", "one", "named"])"));
  CHECK(schema.at("additionalProperties") == false);
  const Json& keys = schema.at("properties");
  CHECK(keys.at("truth") == Json::parse(R"({"enum": ["proved", "refuted", "undecided"]})"));
  CHECK(keys.at("pair").at("items").at("type") == "integer");
  CHECK(keys.at("pair").at("minItems") == 2);
  CHECK(keys.at("pair").at("uniqueItems") == true);
  CHECK(keys.at("count") == Json::parse(R"({"type": "integer", "minimum": 0})"));
  const Json& part = keys.at("parts").at("items");
  CHECK(part.at("required") == Json::array({"name"}));
  CHECK(part.at("properties").at("name").at("description") == "Who.");
  CHECK(part.at("properties").at("value").at("$ref") == "#/$defs/ball");
  CHECK(keys.at("one").at("oneOf").at(1) == part);
  CHECK(keys.at("other") == part);
  CHECK(keys.at("named").at("additionalProperties").at("type") == "number");
  // Definitions stand at the top alone.
  CHECK(schema.at("$defs").contains("ball"));
  CHECK(schema.at("$defs").contains("exact"));
  CHECK(keys.dump().find("$defs\":") == std::string::npos);
}

TEST_CASE("each form of JSON has one schema, named by its file") {
  std::vector<std::string> names;
  for (const File& file : report::schemas()) {
    const Json schema = Json::parse(file.content);
    CHECK(schema.at("$id") == "https://stickslip.invalid/schema/" + file.name);
    CHECK_FALSE(schema.at("title").get<std::string>().empty());
    names.push_back(file.name.substr(0, file.name.find('.')));
  }
  CHECK(names == std::vector<std::string>{"atlas", "verification", "machine_attractors", "machine_words",
                                          "machine_branches", "machine_box", "machine_steady",
                                          "machine_steady_branch", "machine_simulation", "machine_set",
                                          "audit", "orbits", "words", "pure", "branches", "attractors",
                                          "simulation"});
}
