#include "report/audit/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/decimal.hpp"
#include "core/error.hpp"
#include "report/tools/files.hpp"

namespace stickslip::report::audit {

using tools::Json;

namespace {

bool is_ball(const Json& json) {
  return json.is_object() && json.contains("mid") && json.contains("rad");
}

// Whether the two have a number in common.
bool meet(const Json& a, const Json& b) {
  const auto part = [](const Json& ball, const char * key) {
    return parse_decimal(ball.at(key).get<std::string>()).value;
  };
  return abs(Rational(part(a, "mid") - part(b, "mid"))) <= part(a, "rad") + part(b, "rad");
}

std::string text_of(const Json& json) {
  if (is_ball(json)) {
    return fmt::format("{} ± {}", json.at("mid").get<std::string>(), json.at("rad").get<std::string>());
  }
  return json.is_string() ? json.get<std::string>() : json.dump();
}

// Every member's value of the key, as a list.
Json values_of(const Json& list, const char * key) {
  return tools::list_of(list, [key](const Json& one) { return one.at(key); });
}

// What is compared, by the names under which differences are reported.
using Content = std::map<std::string, Json>;

Content of_statement(const Json& statement) {
  return {{"status", statement.at("status")}, {"claims", statement.at("claims")}};
}

Content of_claim(const Json& claim) {
  Content content{{"status", claim.at("status")},
                  {"what is printed", values_of(claim.at("printed"), "text")},
                  {"the corrected form", values_of(claim.at("corrected"), "text")},
                  {"what is assumed", values_of(claim.at("assumptions"), "text")}};
  for (const auto& [key, words] :
       {std::pair("outcome", ""), std::pair("corrected_outcome", " of the corrected form"),
        std::pair("converse", " of the converse")}) {
    const Json& outcome = claim.at(key);
    if (outcome.is_object()) {
      for (const auto& [part, name] : {std::pair("verdict", "verdict"), std::pair("theorems", "theorems")}) {
        content[std::string(name) + words] = outcome.at(part);
      }
      content[std::string("hypotheses") + words] = values_of(outcome.at("hypotheses"), "text");
      for (const Json& number : outcome.at("comparisons")) {
        content[number.at("name").get<std::string>()] = number.at("proved");
      }
    }
  }
  return content;
}

Content of_orbit(const Json& orbit) {
  Content content;
  for (const auto& [name, value] : orbit.items()) {
    if (is_ball(value) || name == "admissible" || name == "stability") {
      content[name] = value;
    }
  }
  for (const Json& condition : orbit.at("conditions")) {
    content["condition " + condition.at("id").get<std::string>()] = condition.at("verdict");
  }
  return content;
}

// In the order in which they stand.
using Contents = std::vector<std::pair<std::string, Content>>;

Contents of_audit(const Json& audit) {
  Contents all;
  for (const Json& statement : audit.at("statements")) {
    all.emplace_back(statement.at("id"), of_statement(statement));
  }
  for (const Json& place : audit.at("places")) {
    for (const Json& claim : place.at("claims")) {
      all.emplace_back(claim.at("id"), of_claim(claim));
    }
  }
  for (const Json& example : audit.at("examples")) {
    const std::string name = "example " + example.at("name").get<std::string>();
    const Json& list = example.at("orbits");
    all.emplace_back(name, Content{{"parameters", list.at("parameters")}, {"complete", list.at("complete")}});
    std::size_t number = 0;
    for (const Json& orbit : list.at("orbits")) {
      all.emplace_back(fmt::format("{}, orbit {}", name, ++number), of_orbit(orbit));
    }
  }
  return all;
}

std::string major(const std::string& version) {
  return version.substr(0, version.find('.'));
}

// Where two texts are long, from shortly before they part.
std::string excerpt(const std::string& text, const std::string& other) {
  constexpr std::ptrdiff_t most = 160, ahead = 40;
  const auto parts = std::ranges::mismatch(text, other).in1 - text.begin();
  const std::string from =
      parts > most - ahead ? "… " + text.substr(static_cast<std::size_t>(parts - ahead)) : text;
  return std::ssize(from) > most ? from.substr(0, most) + " …" : from;
}

}  // namespace

Json read_audit(const std::string& file) {
  const Json audit = Json::parse(tools::read_file(file), nullptr, false);
  for (const char * key : {"schema_version", "program", "statements", "places", "examples"}) {
    if (!audit.is_object() || !audit.contains(key)) {
      throw UsageError(fmt::format("'{}' is not the JSON of an audit: it has no {}", file, key));
    }
  }
  const std::string version = text_of(audit.at("schema_version"));
  if (major(version) != major(tools::schema_version)) {
    throw UsageError(fmt::format("'{}' has schema_version {}, which cannot be compared with {}", file,
                                 version, tools::schema_version));
  }
  try {
    static_cast<void>(compare(audit, audit));
  } catch (const Json::exception& error) {
    throw UsageError(fmt::format("'{}' is not the JSON of an audit: {}", file, error.what()));
  }
  return audit;
}

Comparison compare(const Json& older, const Json& newer) {
  Comparison result;
  const Json& program = older.at("program");
  result.program =
      fmt::format("{} {}", program.at("name").get<std::string>(), program.at("version").get<std::string>());
  const Contents now = of_audit(newer);
  std::map<std::string, Content> left(now.begin(), now.end());
  for (const auto& [id, before] : of_audit(older)) {
    const auto found = left.find(id);
    if (found == left.end()) {
      result.gone.push_back(id);
      continue;
    }
    const std::size_t known = result.differences.size();
    for (const auto& [what, value] : before) {
      const auto other = found->second.find(what);
      const Json after = other == found->second.end() ? Json("nothing") : other->second;
      if (is_ball(value) && is_ball(after) ? !meet(value, after) : value != after) {
        result.differences.push_back({id, what, text_of(value), text_of(after)});
      }
    }
    for (const auto& [what, value] : found->second) {
      if (!before.contains(what)) {
        result.differences.push_back({id, what, "nothing", text_of(value)});
      }
    }
    result.same += result.differences.size() == known ? 1 : 0;
    left.erase(found);
  }
  for (const auto& [id, content] : now) {
    if (left.contains(id)) {
      result.added.push_back(id);
    }
  }
  return result;
}

std::string to_text(const Comparison& comparison) {
  std::string text;
  for (const Difference& one : comparison.differences) {
    text += fmt::format("{}: {}\n  before  {}\n  now     {}\n", one.id, one.what,
                        excerpt(one.before, one.now), excerpt(one.now, one.before));
  }
  for (const auto& [ids, words] :
       {std::pair(&comparison.gone, "is gone"), std::pair(&comparison.added, "is new")}) {
    for (const std::string& id : *ids) {
      text += fmt::format("{} {}\n", id, words);
    }
  }
  std::map<std::string, std::size_t> differing;
  for (const Difference& one : comparison.differences) {
    ++differing[one.id];
  }
  return text +
         fmt::format(
             "Beside what {} found: {} statements, claims and orbits are the same, {} differ, {} are gone, "
             "{} are new.\n",
             comparison.program, comparison.same, differing.size(), comparison.gone.size(),
             comparison.added.size());
}

}  // namespace stickslip::report::audit
