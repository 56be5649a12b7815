#pragma once

// JSON values as Spoke writes them: objects whose members keep their order. The library that holds
// them, nlohmann::ordered_json, is compiled in one source only; it takes seconds in each.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace spoke {

/// Null, a bool, a number, a text, an array or an object. Numbers that are not finite are written
/// as null, zeros without a sign, bytes that are not UTF-8 as replacement characters.
class Json {
 public:
  struct Member;

  Json();
  Json(std::nullptr_t) : Json() {}
  Json(bool value);
  Json(double value);
  Json(float value);
  template <std::signed_integral Integer>
  Json(Integer value) : Json(Signed{value}) {}
  template <std::unsigned_integral Integer>
  requires(!std::same_as<Integer, bool>) Json(Integer value) : Json(Unsigned{value}) {}
  Json(const char* text) : Json(std::string_view(text)) {}
  Json(const std::string& text) : Json(std::string_view(text)) {}
  Json(std::string_view text);
  Json(const std::vector<double>& numbers);
  Json(const std::vector<int>& numbers);
  Json(const std::vector<std::string>& texts);
  /// An object: {{"key", value}, ...}.
  Json(std::initializer_list<Member> members);

  Json(const Json& other);
  Json(Json&& other) noexcept;
  Json& operator=(Json other) noexcept;
  ~Json();

  static Json array(std::initializer_list<Json> elements = {});
  static Json object();
  /// The value of a text that is JSON; throws std::exception on others.
  static Json parse(std::string_view text);

  /// Of an array.
  void push_back(Json element);
  /// Of an object: adds a member, or gives it another value.
  void set(std::string_view key, Json value);
  void update(Json members);

  /// On one line.
  std::string dump() const;
  /// On several lines, indented by 2, with a line end.
  std::string dump_lines() const;

 private:
  struct Value;
  struct Signed {
    std::int64_t value;
  };
  struct Unsigned {
    std::uint64_t value;
  };
  explicit Json(Signed number);
  explicit Json(Unsigned number);
  template <class Source>
  static std::unique_ptr<Value> make(Source&& source);

  std::unique_ptr<Value> value_;
};

struct Json::Member {
  std::string_view key;
  mutable Json value;  ///< moved from by the object that takes it
};

}  // namespace spoke
