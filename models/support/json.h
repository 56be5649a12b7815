#pragma once

// JSON values as Spoke writes them: objects whose members keep their order. The library that holds
// them, nlohmann::ordered_json, is compiled in one source only; it takes seconds in each.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
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
  /// The value of a text of any origin, without what is nested 32 levels deep or more; null if the
  /// text is not JSON.
  static Json parse(std::string_view text);

  bool is_object() const;

  /// Of an array.
  void push_back(Json element);
  /// Of an object: adds a member, or gives it another value.
  void set(std::string_view key, Json value);
  void update(Json members);
  /// Of an object: adds an element to the array under a key, which is made if there is none.
  void append(std::string_view key, Json element);
  /// Of an object: takes a member away if it is there.
  void erase(std::string_view key);

  /// On one line.
  std::string dump() const;
  /// On one line, members of objects sorted by their keys.
  std::string dump_sorted() const;
  /// On several lines, indented by 2, with a line end.
  std::string dump_lines() const;

 private:
  friend struct JsonChange;
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

/// What has become of a part of a value.
struct JsonChange {
  std::string place;   ///< "/blades/0/length"; ends in "/-" behind the last element of an array
  std::string before;  ///< on one line, in ASCII; empty: there is none
  std::string after;

  /// The first one on the way from one value to another; nothing if they are equal.
  static std::optional<JsonChange> find_first(const Json& before, const Json& after);
};

}  // namespace spoke
