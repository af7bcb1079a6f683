#include "report/tools/schema.hpp"

#include <algorithm>

#include "report/tools/json.hpp"

namespace stickslip::report::tools {

namespace {

Json with_more(Json schema, const Json& more) {
  if (more.is_string()) {
    schema["description"] = more;
  } else if (more.is_object()) {
    schema.update(more);
  }
  return schema;
}

// A schema by its name, with its definition at the top.
Json named(const std::string& name, Json schema) {
  return {{"$ref", "#/$defs/" + name}, {"$defs", {{name, std::move(schema)}}}};
}

Json matching(const char * pattern) {
  return {{"type", "string"}, {"pattern", pattern}};
}

}  // namespace

Json ball_schema() {
  return named("ball",
               {{"type", "object"},
                {"description", "The interval [mid - rad, mid + rad] as decimal strings, rounded outwards."},
                {"required", {"mid", "rad"}},
                {"properties",
                 {{"mid", matching("^(-?[0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?|nan)$")},
                  {"rad", matching("^([0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?|inf)$")}}},
                {"additionalProperties", false}});
}

Json exact_schema() {
  return named("exact", with(matching("^-?[0-9]+(\\.[0-9]+|/[0-9]+)?$"), "An exact decimal or a fraction."));
}

Json one_of(const std::vector<std::string>& texts) {
  return {{"enum", texts}};
}

Json with(Json keywords, const std::string& words) {
  keywords["description"] = words;
  return keywords;
}

Json list_schema(Json items, int length) {
  Json schema = {{"type", "array"}, {"$defs", items.value("$defs", Json::object())}};
  items.erase("$defs");
  schema["items"] = std::move(items);
  if (length > 0) {
    schema["minItems"] = schema["maxItems"] = length;
  }
  return schema;
}

Json one_of_schemas(std::vector<Json> schemas) {
  Json definitions = Json::object();
  for (Json& schema : schemas) {
    definitions.update(schema.value("$defs", Json::object()));
    schema.erase("$defs");
  }
  return {{"oneOf", std::move(schemas)}, {"$defs", std::move(definitions)}};
}

Json or_null_schema(Json schema) {
  return one_of_schemas({{{"type", "null"}}, std::move(schema)});
}

Object::Object(Json& json, Json * schema) : json_(json), schema_(schema) {
  if (schema_ != nullptr) {
    *schema_ = {{"type", "object"},
                {"required", Json::array()},
                {"properties", Json::object()},
                {"additionalProperties", false}};
  }
}

Json Object::without_definitions(Json schema) {
  if (schema.contains("$defs")) {
    (*schema_)["$defs"].update(schema.at("$defs"));
    schema.erase("$defs");
  }
  return schema;
}

void Object::add(const std::string& key, Json schema, const Json& more, bool always) {
  if (schema_ == nullptr) {
    return;
  }
  (*schema_)["properties"][key] = with_more(without_definitions(std::move(schema)), more);
  if (always) {
    (*schema_)["required"].push_back(key);
  }
}

void Object::add_all(const Json& other) {
  for (const auto& [key, schema] : other.at("properties").items()) {
    add(key, schema, {}, false);
  }
  (void)without_definitions(other);
}

void Object::add_names(const Json& schema, const Json& more, const std::vector<std::string>& always,
                       const std::vector<std::string>& sometimes) {
  for (const std::string& name : always) {
    add(name, schema, more, true);
  }
  for (const std::string& name : sometimes) {
    add(name, schema, more, false);
  }
  if (always.empty() && sometimes.empty()) {
    (*schema_)["additionalProperties"] = with_more(without_definitions(schema), more);
  }
}

void Object::has_as(const std::string& key, const Json& value, const Json& schema, const Json& more) {
  add(key, schema, more, true);
  json_[key] = value;
}

void Object::rules(const Json& keywords) {
  if (schema_ != nullptr) {
    schema_->update(keywords);
  }
}

void write_provenance(Object& json, const std::string& command, const Json& like) {
  const auto component = [](Object& to, const Component& c) {
    to.has("name", c.name);
    to.has("version", c.version);
  };
  const std::optional<std::string> date = source_date();
  json.has("schema_version", schema_version, one_of({schema_version}));
  json.has_as("date", date ? Json(*date) : Json(nullptr),
              {{"type", {"string", "null"}},
               {"pattern", "^[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z$"},
               {"description", "The moment of SOURCE_DATE_EPOCH, else null."}});
  json.object("program", [&](Object& to) { component(to, {"stickslip", program_version()}); });
  json.list("libraries", libraries(), component);
  json.has("command", command, with(like, "What gives the same result again."));
}

Json provenance(const std::string& command) {
  return written(command, [](Object& json, const std::string& it) { write_provenance(json, it); });
}

File schema_file(const std::string& name, const std::string& title, const Json& schema) {
  const std::string file = name + ".schema.json";
  Json published = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"$id", "https://stickslip.invalid/schema/" + file},
                    {"title", title}};
  published.update(schema);
  return {file, to_text(published)};
}

std::string to_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace stickslip::report::tools
