// JSON values by nlohmann's library.

#include "models/support/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace spoke {
namespace {

using nlohmann::ordered_json;

/// Whether JSON writes the text unchanged, as it does data in base64.
bool is_plain(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

/// Appends a text as the library's dump() does, but without its pass over each letter of a page's
/// longest texts.
void append_text(const ordered_json& value, std::string& text) {
  bool is_first = true;
  const auto separate = [&text, &is_first] {
    if (!std::exchange(is_first, false)) text += ',';
  };
  if (value.is_object()) {
    text += '{';
    for (const auto& [key, member] : value.items()) {
      separate();
      append_text(key, text);
      text += ':';
      append_text(member, text);
    }
    text += '}';
  } else if (value.is_array()) {
    text += '[';
    for (const ordered_json& element : value) {
      separate();
      append_text(element, text);
    }
    text += ']';
  } else if (value.is_string() && is_plain(value.get_ref<const std::string&>())) {
    text.append(1, '"').append(value.get_ref<const std::string&>()).append(1, '"');
  } else {
    text += value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  }
}

/// Returns a part of a value, in ASCII; empty if there is none.
std::string dump_at(const ordered_json::json_pointer& place, const ordered_json& value) {
  if (!value.contains(place)) return {};
  return value.at(place).dump(-1, ' ', true, ordered_json::error_handler_t::replace);
}

}  // namespace

struct Json::Value {
  ordered_json json;
};

template <class Source>
std::unique_ptr<Json::Value> Json::make(Source&& source) {
  return std::make_unique<Value>(Value{ordered_json(std::forward<Source>(source))});
}

Json::Json() : value_(make(nullptr)) {}
Json::Json(bool value) : value_(make(value)) {}
// A sum of -0.0 and 0.0 has no sign.
Json::Json(double value) : value_(make(value + 0.0)) {}
Json::Json(float value) : value_(make(value + 0.0F)) {}
Json::Json(Signed number) : value_(make(number.value)) {}
Json::Json(Unsigned number) : value_(make(number.value)) {}
Json::Json(std::string_view text) : value_(make(text)) {}
Json::Json(const std::vector<double>& numbers) : value_(make(ordered_json::array())) {
  for (const double number : numbers) value_->json.push_back(number + 0.0);
}
Json::Json(const std::vector<int>& numbers) : value_(make(numbers)) {}
Json::Json(const std::vector<std::string>& texts) : value_(make(texts)) {}

Json::Json(std::initializer_list<Member> members) : value_(make(ordered_json::object())) {
  for (const Member& member : members) set(member.key, std::move(member.value));
}

Json::Json(const Json& other) : value_(std::make_unique<Value>(*other.value_)) {}
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(Json other) noexcept {
  value_ = std::move(other.value_);
  return *this;
}
Json::~Json() = default;

Json Json::array(std::initializer_list<Json> elements) {
  Json array;
  array.value_->json = ordered_json::array();
  for (const Json& element : elements) array.push_back(element);
  return array;
}

Json Json::object() { return std::initializer_list<Member>{}; }

Json Json::parse(std::string_view text) {
  // A text of another origin may be nested without end.
  const auto is_shallow = [](int depth, ordered_json::parse_event_t, ordered_json&) {
    return depth < 32;
  };
  Json value;
  ordered_json parsed = ordered_json::parse(text, is_shallow, false);
  if (!parsed.is_discarded()) value.value_->json = std::move(parsed);
  return value;
}

bool Json::is_object() const { return value_->json.is_object(); }

void Json::push_back(Json element) { value_->json.push_back(std::move(element.value_->json)); }

void Json::set(std::string_view key, Json value) {
  value_->json[std::string(key)] = std::move(value.value_->json);
}

void Json::update(Json members) { value_->json.update(members.value_->json); }

void Json::set_at(const std::string& path, Json value) {
  value_->json[ordered_json::json_pointer(path)] = std::move(value.value_->json);
}

void Json::append(std::string_view key, Json element) {
  value_->json[std::string(key)].push_back(std::move(element.value_->json));
}

void Json::erase(std::string_view key) { value_->json.erase(std::string(key)); }

std::string Json::dump() const {
  std::string text;
  append_text(value_->json, text);
  return text;
}

std::string Json::dump_sorted() const {
  return nlohmann::json(value_->json)
      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string Json::dump_lines() const {
  return value_->json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

std::optional<JsonChange> JsonChange::find_first(const Json& before, const Json& after) {
  const ordered_json& old = before.value_->json;
  const ordered_json& current = after.value_->json;
  const ordered_json changes = ordered_json::diff(old, current);
  if (changes.empty()) return {};
  auto place = changes[0]["path"].get<std::string>();
  if (place.ends_with("/-")) return JsonChange{std::move(place), {}, {}};
  const ordered_json::json_pointer pointer(place);
  return JsonChange{std::move(place), dump_at(pointer, old), dump_at(pointer, current)};
}

}  // namespace spoke
