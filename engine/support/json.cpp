// JSON values by nlohmann's library.

#include "engine/support/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/support/plain_zero.h"

namespace spoke {
namespace {

using nlohmann::ordered_json;

/// Whether JSON has the text as it is, as it has data in base64.
bool is_plain(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

/// As dump() of the library, which takes a page's longest texts apart letter by letter.
void append(const ordered_json& value, std::string& text) {
  bool is_first = true;
  const auto separate = [&text, &is_first] {
    if (!std::exchange(is_first, false)) text += ',';
  };
  if (value.is_object()) {
    text += '{';
    for (const auto& [key, member] : value.items()) {
      separate();
      append(key, text);
      text += ':';
      append(member, text);
    }
    text += '}';
  } else if (value.is_array()) {
    text += '[';
    for (const ordered_json& element : value) {
      separate();
      append(element, text);
    }
    text += ']';
  } else if (value.is_string() && is_plain(value.get_ref<const std::string&>())) {
    text.append(1, '"').append(value.get_ref<const std::string&>()).append(1, '"');
  } else {
    text += value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  }
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
Json::Json(double value) : value_(make(plain_zero(value))) {}
Json::Json(float value) : value_(make(value + 0.0F)) {}
Json::Json(Signed number) : value_(make(number.value)) {}
Json::Json(Unsigned number) : value_(make(number.value)) {}
Json::Json(std::string_view text) : value_(make(text)) {}
Json::Json(const std::vector<double>& numbers) : value_(make(ordered_json::array())) {
  for (const double number : numbers) value_->json.push_back(plain_zero(number));
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
  Json value;
  value.value_->json = ordered_json::parse(text);
  return value;
}

void Json::push_back(Json element) { value_->json.push_back(std::move(element.value_->json)); }

void Json::set(std::string_view key, Json value) {
  value_->json[std::string(key)] = std::move(value.value_->json);
}

void Json::update(Json members) { value_->json.update(members.value_->json); }

std::string Json::dump() const {
  std::string text;
  append(value_->json, text);
  return text;
}

std::string Json::dump_lines() const {
  return value_->json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace spoke
