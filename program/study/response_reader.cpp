// Reads the keys of each kind of response.

#include "program/study/response_reader.h"

#include <algorithm>
#include <limits>

namespace spoke::study {
namespace {

constexpr Count kModes{1, 1000};

/// Refuses keys that only other kinds have.
void require_fitting_keys(const TomlSection& section, ResponseKind kind,
                          const TomlSection::Keys& own) {
  for (const std::string_view key :
       {"sensor", "from", "to", "time", "level", "direction", "every", "mode", "of", "speed"})
    if (section.has(key) && std::find(own.begin(), own.end(), key) == own.end())
      section.fail(key, "does not go with \"" + std::string(name_of(kind)) + "\", expected " +
                            join_names(own));
}

TomlSection::Keys keys_of(ResponseKind kind) {
  switch (kind) {
    case ResponseKind::final:
      return {"sensor"};
    case ResponseKind::at:
      return {"sensor", "time"};
    case ResponseKind::first_crossing:
      return {"sensor", "level", "direction", "from", "to"};
    case ResponseKind::period:
      return {"sensor", "level", "from", "to"};
    case ResponseKind::history:
      return {"sensor", "every"};
    case ResponseKind::frequency:
      return {"mode", "of", "speed"};
    default:
      return {"sensor", "from", "to"};
  }
}

void read_window(const TomlSection& section, Response& response) {
  response.from = section.number("from", Quantity::not_negative("s"), 0.0);
  response.to =
      section.number("to", Quantity::positive("s"), std::numeric_limits<double>::infinity());
  if (!(response.to > response.from))
    section.fail(section.has("to") ? "to" : "from",
                 "ends the window before it begins, expected \"to\" greater than \"from\"");
}

void read_mode(const TomlSection& section, Response& response) {
  if (section.is_text("mode"))
    response.mode_name = section.text("mode", "");
  else
    response.mode = section.integer("mode", kModes);
  response.mode_of = section.text("of", "");
  if (section.has("speed")) response.speed = section.number("speed", Quantity::any("rad/s"));
  response.unit = "Hz";
}

void read_sensor(const TomlSection& section, Response& response) {
  response.sensor = section.text("sensor", "");
  if (response.sensor.empty())
    section.fail("sensor", "is missing, expected the name of a sensor, such as \"blade1.tip.y\"");
  read_window(section, response);
  if (response.kind == ResponseKind::at)
    response.time = section.number("time", Quantity::not_negative("s"));
  if (response.kind == ResponseKind::first_crossing || section.has("level"))
    response.level = section.number("level", Quantity::any(""));
  response.direction =
      section.choice("direction", {Direction::up, Direction::down, Direction::any}, Direction::any);
  if (section.has("every")) response.every = section.number("every", Quantity::not_negative("s"));
}

std::string default_name(const Response& response) {
  if (response.kind != ResponseKind::frequency) {
    const std::string name = response.sensor + '.' + std::string(name_of(response.kind));
    return response.kind == ResponseKind::at ? name + '.' + describe(response.time) : name;
  }
  std::string name = "frequency.";
  name += response.mode_name.empty() ? std::to_string(response.mode) : response.mode_name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

Response read_response(const TomlSection& section) {
  using K = ResponseKind;
  const std::vector<K> kinds = {K::min,     K::max,      K::mean,           K::rms,
                                K::final,   K::at,       K::first_crossing, K::period,
                                K::history, K::frequency};
  TomlSection::Keys names;
  for (const K kind : kinds) names.push_back(name_of(kind));
  Response response;
  response.kind = kinds[section.choice("kind", names)];
  require_fitting_keys(section, response.kind, keys_of(response.kind));
  if (response.kind == K::frequency)
    read_mode(section, response);
  else
    read_sensor(section, response);
  response.name = section.text("name", default_name(response));
  response.place = section.place(response.kind == K::frequency ? "mode" : "sensor");
  return response;
}

}  // namespace

std::vector<Response> read_responses(const TomlSection& root, bool is_required) {
  std::vector<Response> responses;
  std::size_t bytes = 0;  // of all names
  for (const TomlSection& section :
       root.sections("response", {"sensor", "kind", "name", "from", "to", "time", "level",
                                  "direction", "every", "mode", "of", "speed"})) {
    Response response = read_response(section);
    const std::string_view key = section.has("name") ? "name" : "";
    if (!is_column_name(response.name) || response.name.find('/') != std::string::npos ||
        response.name == ".")
      section.fail(key, "is named \"" + response.name +
                            "\", expected a name without comma, quote, slash or control character, "
                            "and other than \".\"");
    bytes += response.name.size() + 1;
    if (bytes > kMostNameBytes)
      section.fail(key, "makes the names of responses " + std::to_string(bytes) +
                            " bytes long together, expected at most " +
                            std::to_string(kMostNameBytes));
    for (const Response& other : responses)
      if (other.name == response.name)
        section.fail(key, "is named \"" + response.name +
                              "\" as another response is, expected a \"name\" of its own");
    responses.push_back(std::move(response));
  }
  if (responses.empty() && is_required)
    root.fail("response", "is missing, expected tables headed [[response]]");
  return responses;
}

}  // namespace spoke::study
