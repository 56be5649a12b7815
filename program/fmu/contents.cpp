// The file is TOML, whose strings are those of JSON.

#include "program/fmu/contents.h"

#include <cstdint>
#include <string_view>

#include "models/error.h"
#include "models/reader/toml_document.h"
#include "models/support/json.h"

namespace spoke::fmu {
namespace {

constexpr std::int64_t kFormat = 1;

std::string line(std::string_view key, const Json& value) {
  return std::string(key) + " = " + value.dump() + '\n';
}

[[noreturn]] void fail(const std::string& name, const std::string& key) {
  throw InputError(name + ": " + key +
                   " is missing or of another kind, expected the file that "
                   "spoke fmu has written with the library of the FMU");
}

std::string text_of(const TomlDocument& document, const std::string& key, const std::string& name) {
  const TomlValue* value = document.root().find(key);
  const std::string* text = value ? value->as_text() : nullptr;
  if (!text) fail(name, key);
  return *text;
}

std::vector<std::string> texts_of(const TomlDocument& document, const std::string& key,
                                  const std::string& name) {
  const TomlValue* value = document.root().find(key);
  const TomlArray* array = value ? value->as_array() : nullptr;
  if (!array) fail(name, key);
  std::vector<std::string> texts;
  for (const TomlValue& element : *array) {
    const std::string* text = element.as_text();
    if (!text) fail(name, key);
    texts.push_back(*text);
  }
  return texts;
}

}  // namespace

std::string write_contents(const Contents& contents) {
  return "# Read by the library of this FMU, which Spoke " SPOKE_VERSION " has made.\n" +
         line("format", kFormat) + line("token", contents.token) +
         line("scenario", contents.scenario) + line("set", contents.overrides) +
         line("step", contents.step) + line("inputs", contents.inputs) +
         line("outputs", contents.outputs);
}

Contents read_contents(const std::string& text, const std::string& name) {
  const TomlDocument document(text, name);
  const TomlValue* format = document.root().find("format");
  if (!format || !format->as_integer() || *format->as_integer() != kFormat) fail(name, "format");
  const TomlValue* step = document.root().find("step");
  const bool is_step = step && step->as_floating_point() && *step->as_floating_point() > 0.0;
  if (!is_step) fail(name, "step");
  return {text_of(document, "token", name),   text_of(document, "scenario", name),
          texts_of(document, "set", name),    *step->as_floating_point(),
          texts_of(document, "inputs", name), texts_of(document, "outputs", name)};
}

}  // namespace spoke::fmu
