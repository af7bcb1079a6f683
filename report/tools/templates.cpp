#include "report/tools/templates.hpp"

#include <fmt/format.h>

#include <kainjow/mustache.hpp>
#include <system_error>

#include "core/error.hpp"
#include "report/tools/escape.hpp"
#include "report/tools/files.hpp"
#include "report/tools/prose.hpp"

namespace stickslip::report::tools {

namespace {

namespace fs = std::filesystem;
using Data = kainjow::mustache::data;

fs::path installed_directory() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return (program.parent_path() / STICKSLIP_INSTALLED_TEMPLATES).lexically_normal();
}

bool names_directory(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

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
  for (const fs::directory_entry& entry : fs::directory_iterator(template_directory())) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('_')) {
      data.set(entry.path().stem().string().substr(1), read_file(entry.path()));
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

fs::path template_directory() {
  const fs::path installed = installed_directory();
  for (const fs::path& place : {installed, fs::path(STICKSLIP_SOURCE_TEMPLATES)}) {
    if (names_directory(place)) {
      return place;
    }
  }
  throw InputOutputError(fmt::format("cannot find the page templates, neither in {} nor in {}",
                                     installed.string(), STICKSLIP_SOURCE_TEMPLATES));
}

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
  return render(file, read_file(template_directory() / file), data, format);
}

}  // namespace stickslip::report::tools
