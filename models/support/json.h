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
  /// Makes an object {{"key", value}, ...}.
  Json(std::initializer_list<Member> members);

  Json(const Json& other);
  Json(Json&& other) noexcept;
  Json& operator=(Json other) noexcept;
  ~Json();

  static Json array(std::initializer_list<Json> elements = {});
  static Json object();
  /// Returns the value of a text of any origin, without parts nested 32 levels deep or more; null
  /// if the text is not JSON.
  static Json parse(std::string_view text);

  bool is_object() const;

  /// Appends an element to an array.
  void push_back(Json element);
  /// Adds a member to an object, or gives an existing one another value.
  void set(std::string_view key, Json value);
  void update(Json members);
  /// Gives the part at a path, such as "/blades/0/length", another value. Precondition: what it is
  /// in exists.
  void set_at(const std::string& path, Json value);
  /// Adds an element to the array under a key of an object, and makes the array if there is none.
  void append(std::string_view key, Json element);
  /// Removes a member of an object if it is there.
  void erase(std::string_view key);

  /// Returns the value on one line.
  std::string dump() const;
  /// Returns the value on one line, members of objects sorted by their keys.
  std::string dump_sorted() const;
  /// Returns the value on several lines, indented by 2, with a line end.
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
  mutable Json value;  ///< mutable, since the object that takes it moves from it
};

/// The change of one part of a value.
struct JsonChange {
  /// Path of the part, "/blades/0/length"; ends in "/-" behind the last element of an array.
  std::string place;
  std::string before;  ///< value before, on one line in ASCII; empty: there is none
  std::string after;

  /// Finds the first change on the way from one value to another; none if they are equal.
  static std::optional<JsonChange> find_first(const Json& before, const Json& after);
};

}  // namespace spoke
