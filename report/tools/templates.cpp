#include "report/tools/templates.hpp"

#include <fmt/format.h>

#include <kainjow/mustache.hpp>

#include "core/error.hpp"
#include "report/tools/prose.hpp"

namespace stickslip::report::tools {

namespace {

using Data = kainjow::mustache::data;

bool is_something(const Json& json) {
  return json.is_string() ? !json.get_ref<const std::string&>().empty() : !json.empty();
}

Data to_data(const Json& json) {
  switch (json.type()) {
    case Json::value_t::object: {
      Data object(Data::type::object);
      for (const auto& [key, value] : json.items()) {
        object.set(key, to_data(value));
        object.set("has_" + key, is_something(value) ? Data::type::bool_true : Data::type::bool_false);
      }
      return object;
    }
    case Json::value_t::array: {
      Data list(Data::type::list);
      for (const Json& value : json) {
        list.push_back(to_data(value));
      }
      return list;
    }
    case Json::value_t::string:
      return {json.get<std::string>()};
    case Json::value_t::boolean:
      return {json.get<bool>() ? Data::type::bool_true : Data::type::bool_false};
    case Json::value_t::null:
      return {Data::type::bool_false};
    default:
      return {json.dump()};
  }
}

void add_prose(Data& data, const PageFormat& format) {
  using kainjow::mustache::lambda2;
  using kainjow::mustache::renderer;
  data.set("prose", lambda2{[&format](const std::string& section, const renderer& render_section) {
             return format.prose(render_section(section, false));
           }});
}

void add_partials(Data& data) {
  for (const auto& [name, text] : templates()) {
    if (name.starts_with('_')) {
      data.set(name.substr(1, name.rfind('.') - 1), text);
    }
  }
}

std::string as_it_is(std::string_view text) {
  return std::string(text);
}

}  // namespace

const PageFormat html_format{escape_html, prose_html};
const PageFormat tex_format{escape_tex, prose_tex};
const PageFormat plain_format{as_it_is, as_it_is};

std::string render(const std::string& name, const std::string& source, const Json& data,
                   const PageFormat& format) {
  kainjow::mustache::mustache page(source);
  page.set_custom_escape([&format](const std::string& text) { return format.text(text); });
  Data all = to_data(data);
  add_prose(all, format);
  add_partials(all);
  std::string result = page.is_valid() ? page.render(all) : std::string();
  if (!page.is_valid()) {
    throw InternalError(fmt::format("the template {} is malformed: {}", name, page.error_message()));
  }
  return result;
}

std::string render_file(const std::string& name, const Json& data, const PageFormat& format) {
  const std::string file = name + ".mustache";
  return render(file, templates().at(file), data, format);
}

}  // namespace stickslip::report::tools
