// The keys of the JSON: programs read them, so none goes, comes or ceases to be there always by accident. The
// schemas cannot tell, for they are made from what writes the JSON.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "report/schemas.hpp"
#include "report/tools/json.hpp"

using namespace stickslip;
using report::tools::Json;

namespace {

using Keys = std::set<std::string>;

// "orbits/[]/ur" for each key at any depth, with "?" where it may be absent.
void collect(const Json& schema, const std::string& path, Keys& keys) {
  if (schema.contains("properties")) {
    const Json required = schema.value("required", Json::array());
    for (const auto& [key, part] : schema.at("properties").items()) {
      const bool always = std::find(required.begin(), required.end(), key) != required.end();
      keys.insert(path + key + (always ? "" : "?"));
      collect(part, path + key + "/", keys);
    }
  }
  if (schema.contains("items") && schema.at("items").is_object()) {
    collect(schema.at("items"), path + "[]/", keys);
  }
  if (schema.contains("additionalProperties") && schema.at("additionalProperties").is_object()) {
    collect(schema.at("additionalProperties"), path + "*/", keys);
  }
  for (const char * kind : {"oneOf", "anyOf", "allOf"}) {
    if (schema.contains(kind)) {
      for (const Json& part : schema.at(kind)) {
        collect(part, path, keys);
      }
    }
  }
}

Keys difference(const Keys& a, const Keys& b) {
  Keys result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(result, result.end()));
  return result;
}

std::string joined(const Keys& keys) {
  std::string text;
  for (const std::string& key : keys) {
    text += "\n" + key;
  }
  return text;
}

}  // namespace

TEST_CASE("the keys of every form of JSON are those of keys.txt: a change there is one for schema_version") {
  Keys keys;
  for (const report::tools::File& file : report::schemas()) {
    collect(Json::parse(file.content), file.name.substr(0, file.name.find('.')) + ": ", keys);
  }
  std::ifstream stored(std::filesystem::path(__FILE__).parent_path() / "keys.txt");
  REQUIRE(stored);
  Keys known;
  for (std::string line; std::getline(stored, line);) {
    known.insert(line);
  }
  CHECK_MESSAGE(keys == known, "new:", joined(difference(keys, known)),
                "\ngone:", joined(difference(known, keys)));
  CHECK(keys.size() > 200);
}
