// JSON values by nlohmann's library.

#include "engine/support/json.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace spoke {

struct Json::Value {
  nlohmann::ordered_json json;
};

template <class Source>
std::unique_ptr<Json::Value> Json::make(Source&& source) {
  return std::make_unique<Value>(Value{nlohmann::ordered_json(std::forward<Source>(source))});
}

Json::Json() : value_(make(nullptr)) {}
Json::Json(bool value) : value_(make(value)) {}
Json::Json(double value) : value_(make(value)) {}
Json::Json(float value) : value_(make(value)) {}
Json::Json(Signed number) : value_(make(number.value)) {}
Json::Json(Unsigned number) : value_(make(number.value)) {}
Json::Json(std::string_view text) : value_(make(text)) {}
Json::Json(const std::vector<double>& numbers) : value_(make(numbers)) {}
Json::Json(const std::vector<int>& numbers) : value_(make(numbers)) {}
Json::Json(const std::vector<std::string>& texts) : value_(make(texts)) {}

Json::Json(std::initializer_list<Member> members) : value_(make(nlohmann::ordered_json::object())) {
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
  array.value_->json = nlohmann::ordered_json::array();
  for (const Json& element : elements) array.push_back(element);
  return array;
}

Json Json::object() { return std::initializer_list<Member>{}; }

Json Json::parse(std::string_view text) {
  Json value;
  value.value_->json = nlohmann::ordered_json::parse(text);
  return value;
}

void Json::push_back(Json element) { value_->json.push_back(std::move(element.value_->json)); }

void Json::set(std::string_view key, Json value) {
  value_->json[std::string(key)] = std::move(value.value_->json);
}

void Json::update(Json members) { value_->json.update(members.value_->json); }

std::string Json::dump() const {
  return value_->json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string Json::dump_lines() const {
  return value_->json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace spoke
