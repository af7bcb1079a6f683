// JSON and its schema (JSON Schema, draft 2020-12) from one description: the function that writes an object
// says of each key what stands there, and, where that is more than its type, what may stand there.
#pragma once

#include <concepts>
#include <optional>
#include <ranges>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/ball.hpp"
#include "core/decimal.hpp"
#include "core/verdict.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"

namespace stickslip::report::tools {

// {"mid", "rad"}; an exact decimal or a fraction; one of these texts.
[[nodiscard]] Json ball_schema();
[[nodiscard]] Json exact_schema();
[[nodiscard]] Json one_of(const std::vector<std::string>& texts);
// One of the names of an enumeration from its value `first` up to `last`.
template <class Enumeration>
[[nodiscard]] Json names_through(Enumeration last, Enumeration first = {}) {
  std::vector<std::string> names;
  for (int k = static_cast<int>(first); k <= static_cast<int>(last); ++k) {
    names.push_back(to_string(static_cast<Enumeration>(k)));
  }
  return one_of(names);
}
[[nodiscard]] Json list_schema(Json items, int length = 0);
[[nodiscard]] Json or_null_schema(Json schema);
[[nodiscard]] Json one_of_schemas(std::vector<Json> schemas);
// Keywords of the schema: with a sentence for its reader.
[[nodiscard]] Json with(Json keywords, const std::string& words);

// Of a list whose type says it; else 0.
template <class T>
[[nodiscard]] constexpr int fixed_length() {
  if constexpr (requires { T::SizeAtCompileTime; }) {
    return T::SizeAtCompileTime;
  } else if constexpr (requires { std::tuple_size<T>::value; }) {
    return static_cast<int>(std::tuple_size<T>::value);
  } else {
    return 0;
  }
}

// Truth values, numbers, texts, names of enumerations, exact numbers, balls, and lists of these.
template <class T>
[[nodiscard]] Json json_value(const T& value) {
  if constexpr (std::same_as<T, BallText>) {
    return {{"mid", value.mid}, {"rad", value.rad}};
  } else if constexpr (std::is_enum_v<T> || std::same_as<T, Rational>) {
    return to_string(value);
  } else if constexpr (std::is_arithmetic_v<T> || std::convertible_to<T, std::string>) {
    return value;
  } else {
    return list_of(value, [](const auto& one) { return json_value(one); });
  }
}
template <class T>
[[nodiscard]] Json schema_of() {
  if constexpr (std::same_as<T, BallText>) {
    return ball_schema();
  } else if constexpr (std::same_as<T, Rational>) {
    return exact_schema();
  } else if constexpr (std::same_as<T, Truth>) {
    return names_through(Truth::undecided);
  } else if constexpr (std::same_as<T, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::unsigned_integral<T>) {
    return {{"type", "integer"}, {"minimum", 0}};
  } else if constexpr (std::integral<T>) {
    return {{"type", "integer"}};
  } else if constexpr (std::floating_point<T>) {
    return {{"type", "number"}};
  } else if constexpr (std::is_enum_v<T> || std::convertible_to<T, std::string>) {
    return {{"type", "string"}};
  } else {
    return list_schema(schema_of<std::ranges::range_value_t<T>>(), fixed_length<T>());
  }
}

// What stands for a T where only the schema is wanted.
template <class T>
struct SampleOf {
  [[nodiscard]] static T made() { return {}; }
};

// What the function writes of it, or of what it points to; what it writes, by a sample.
template <class T, class Write>
[[nodiscard]] Json written(const T& it, const Write& write);
template <class T, class Write>
[[nodiscard]] Json schema_by(const T& sample, const Write& write);

// An object that is being written, and its schema, if that is wanted: then the values are only samples, every
// function that writes a part is called once at least, and what it is called with need not be anything.
class Object {
 public:
  explicit Object(Json& json, Json * schema = nullptr);

  // A value under the key; where it is optional, only if it is there. `more`: a sentence for the reader of
  // the schema, or its further keywords.
  template <class T>
  void has(const std::string& key, const T& value, const Json& more = {}) {
    if (schema_ != nullptr) {
      add(key, schema_of<T>(), more, true);
    }
    json_[key] = json_value(value);
  }
  template <class T>
  void has(const std::string& key, const std::optional<T>& value, const Json& more = {}) {
    if (schema_ != nullptr) {
      add(key, schema_of<T>(), more, false);
    }
    if (value) {
      json_[key] = json_value(*value);
    }
  }

  // An object under the key, which `write` writes; a list of objects; null or an object.
  template <class Write>
  void object(const std::string& key, const Write& write, const Json& more = {}) {
    Json json = Json::object(), schema;
    Object object(json, schema_ != nullptr ? &schema : nullptr);
    write(object);
    add(key, std::move(schema), more, true);
    json_[key] = std::move(json);
  }
  template <class Range, class Write>
  void list(const std::string& key, const Range& all, const Write& write, const Json& more = {}) {
    using Member = std::ranges::range_value_t<Range>;
    if (schema_ != nullptr) {
      add(key, list_schema(sample<Member>(write)), more, true);
    }
    json_[key] = list_of(all, [&](const auto& one) { return written(one, write); });
  }
  template <class Pointer, class Write>
  void or_null(const std::string& key, const Pointer& value, const Write& write, const Json& more = {}) {
    if (schema_ != nullptr) {
      add(key, or_null_schema(sample<std::remove_cvref_t<decltype(*value)>>(write)), more, true);
    }
    json_[key] = value ? written(*value, write) : Json(nullptr);
  }
  // An object under the key, if there is one; keys of this object, if there is what they are about.
  template <class T, class Write>
  void object_if(const std::string& key, const std::optional<T>& value, const Write& write,
                 const Json& more = {}) {
    if (schema_ != nullptr) {
      add(key, sample<T>(write), more, false);
    }
    if (value) {
      json_[key] = written(*value, write);
    }
  }
  template <class T, class Write>
  void keys_if(const std::optional<T>& value, const Write& write) {
    if (schema_ != nullptr) {
      add_all(sample<T>(write));
    }
    if (value) {
      Object same(json_);
      write(same, *value);
    }
  }

  // Pairs of a name and a value: the names that are always there, and those that may be; any, without these.
  template <class Pairs>
  void each(const Pairs& pairs, const std::vector<std::string>& always = {},
            const std::vector<std::string>& sometimes = {}, const Json& more = {}) {
    if (schema_ != nullptr) {
      using Value = std::remove_cvref_t<decltype(std::ranges::begin(pairs)->second)>;
      add_names(schema_of<Value>(), more, always, sometimes);
    }
    for (const auto& [name, value] : pairs) {
      json_[name] = json_value(value);
    }
  }

  // A key that is written elsewhere; one with a value of its own kind; further keywords of the schema.
  template <class T, class Write>
  void may_have(const std::string& key, const Write& write, const Json& more = {}) {
    if (schema_ != nullptr) {
      add(key, sample<T>(write), more, false);
    }
  }
  void has_as(const std::string& key, const Json& value, const Json& schema, const Json& more = {});
  void rules(const Json& keywords);

 private:
  void add(const std::string& key, Json schema, const Json& more, bool always);
  void add_all(const Json& other);
  void add_names(const Json& schema, const Json& more, const std::vector<std::string>& always,
                 const std::vector<std::string>& sometimes);
  [[nodiscard]] Json without_definitions(Json schema);

  // The schema of what is written of a T.
  template <class T, class Write>
  [[nodiscard]] static Json sample(const Write& write) {
    return schema_by(SampleOf<std::remove_const_t<std::remove_pointer_t<T>>>::made(), write);
  }

  Json& json_;
  Json * schema_;
};

template <class T, class Write>
Json written(const T& it, const Write& write) {
  Json json = Json::object();
  Object object(json);
  if constexpr (std::is_pointer_v<T>) {
    write(object, *it);
  } else {
    write(object, it);
  }
  return json;
}
template <class T, class Write>
Json schema_by(const T& sample, const Write& write) {
  Json json = Json::object(), schema;
  Object object(json, &schema);
  write(object, sample);
  return schema;
}

// What every result says about its origin (json.hpp: provenance). `command` gives it again; in its schema, by
// default, it is one of the program's.
inline const Json of_program = {{"pattern", "^stickslip "}};
void write_provenance(Object& json, const std::string& command, const Json& like = of_program);

// NAME.schema.json, as it is published.
[[nodiscard]] File schema_file(const std::string& name, const std::string& title, const Json& schema);

}  // namespace stickslip::report::tools
