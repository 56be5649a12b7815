#pragma once

// Keys of a scenario as plain rows: what belongs to a type is behind a pointer, so that the reader,
// the rules, JSON and documents are ordinary functions, compiled once.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "models/support/quantity.h"

namespace spoke {

/// Whether a file must give a value; code always does.
enum class Presence { required, optional };

}  // namespace spoke

namespace spoke::keys {

/// What may stand in a file for the value of a key: one form, or several as `a | b`.
using Forms = unsigned;
inline constexpr Forms kNumber = 1;           ///< of the row's range
inline constexpr Forms kWhole = 2;            ///< a whole number of the row's count
inline constexpr Forms kFlag = 4;             ///< true or false
inline constexpr Forms kText = 8;             ///< any text
inline constexpr Forms kWord = 16;            ///< one of the row's words
inline constexpr Forms kNumbers = 32;         ///< an array of numbers of the row's range
inline constexpr Forms kNumberArrays = 64;    ///< an array of arrays of numbers
inline constexpr Forms kTexts = 128;          ///< an array of texts
inline constexpr Forms kTable = 256;          ///< a table
inline constexpr Forms kTables = 512;         ///< an array of tables
inline constexpr Forms kNamedNumbers = 1024;  ///< a table of numbers under any names

/// A key: its member, what may stand there, and a line of documentation. The default is the value
/// of a new structure. Rows are constants of the program; texts are in Markdown, without "|".
struct Row {
  /// The type of the member: double, int, bool, an enumeration, a vector of three components,
  /// std::optional<double>, std::vector<double>. A key by hand is known and documented here, and
  /// read and written elsewhere.
  enum class Kind { number, count, flag, choice, vector, option, numbers, by_hand };

  std::string_view key;
  std::string_view doc;
  Kind kind = Kind::by_hand;
  Forms forms = 0;
  Quantity range{};      ///< of a number or of each number
  Count count{};         ///< of a whole number
  std::size_t size = 0;  ///< of an array; 0: any
  Presence presence = Presence::optional;

  void* (*member)(void*) = nullptr;     ///< of a structure
  const void* (*standard)() = nullptr;  ///< a new structure
  std::size_t word_count = 0;           ///< of a choice
  std::string_view (*word)(std::size_t) = nullptr;
  std::size_t (*chosen)(const void*) = nullptr;
  void (*choose)(void*, std::size_t) = nullptr;

  // Conditions, by the other members of the structure; null: none.
  bool (*applies)(const void*) = nullptr;
  Quantity (*range_by)(const void*) = nullptr;
  Presence (*presence_by)(const void*) = nullptr;

  // What documents say where the members above do not say it.
  std::string_view words{};         ///< of a key by hand, separated by spaces
  std::string_view default_text{};  ///< "required" is that of a key that is
  std::string_view range_text{};
  std::string_view unit_text{};
  std::string_view more{};      ///< the cell of the table's last column
  std::string_view table_id{};  ///< the table that stands here; empty: "PARENT.KEY"

  // Each returns the row with one thing changed.
  constexpr Row required() const {
    Row row = *this;
    row.presence = Presence::required;
    return row;
  }
  constexpr Row from(std::string_view text) const {
    Row row = *this;
    row.default_text = text;
    return row;
  }
  constexpr Row within(std::string_view text) const {
    Row row = *this;
    row.range_text = text;
    return row;
  }
  constexpr Row in(std::string_view text) const {
    Row row = *this;
    row.unit_text = text;
    return row;
  }
  constexpr Row with(std::string_view text) const {
    Row row = *this;
    row.more = text;
    return row;
  }
  constexpr Row among(std::string_view text) const {
    Row row = *this;
    row.words = text;
    return row;
  }
  constexpr Row as(std::string_view text) const {
    Row row = *this;
    row.table_id = text;
    return row;
  }
  constexpr Row of(std::size_t numbers) const {
    Row row = *this;
    row.size = numbers;
    return row;
  }
  constexpr Row of(Count whole) const {
    Row row = *this;
    row.count = whole;
    return row;
  }
  constexpr Row of(Quantity numbers) const {
    Row row = *this;
    row.range = numbers;
    return row;
  }
  constexpr Row when(bool (*condition)(const void*)) const {
    Row row = *this;
    row.applies = condition;
    return row;
  }
  constexpr Row ranging(Quantity (*by)(const void*)) const {
    Row row = *this;
    row.range_by = by;
    return row;
  }
  constexpr Row present(Presence (*by)(const void*)) const {
    Row row = *this;
    row.presence_by = by;
    return row;
  }
};

template <class M>
struct MemberOf;
template <class S, class T>
struct MemberOf<T S::*> {
  using Structure = S;
  using Type = T;
};

template <auto member>
constexpr Row bound(Row::Kind kind, Forms forms, std::string_view key, std::string_view doc) {
  using S = typename MemberOf<decltype(member)>::Structure;
  Row row{key, doc, kind, forms};
  row.member = [](void* of) -> void* { return &(static_cast<S*>(of)->*member); };
  row.standard = []() -> const void* {
    static const S made{};
    return &made;
  };
  return row;
}

template <auto member>
constexpr Row number(std::string_view key, const Quantity& range, std::string_view doc) {
  static_assert(std::is_same_v<typename MemberOf<decltype(member)>::Type, double>);
  return bound<member>(Row::Kind::number, kNumber, key, doc).of(range);
}

/// A number that may be missing, std::optional<double>.
template <auto member>
constexpr Row option(std::string_view key, const Quantity& range, std::string_view doc) {
  static_assert(std::is_same_v<typename MemberOf<decltype(member)>::Type, std::optional<double>>);
  return bound<member>(Row::Kind::option, kNumber, key, doc).of(range);
}

template <auto member>
constexpr Row count(std::string_view key, const Count& range, std::string_view doc) {
  static_assert(std::is_same_v<typename MemberOf<decltype(member)>::Type, int>);
  return bound<member>(Row::Kind::count, kWhole, key, doc).of(range);
}

template <auto member>
constexpr Row flag(std::string_view key, std::string_view doc) {
  static_assert(std::is_same_v<typename MemberOf<decltype(member)>::Type, bool>);
  return bound<member>(Row::Kind::flag, kFlag, key, doc);
}

/// A vector of three components, as of vectors.h.
template <auto member>
constexpr Row vector(std::string_view key, const Quantity& range, std::string_view doc) {
  constexpr std::size_t components = 3;
  static_assert(sizeof(typename MemberOf<decltype(member)>::Type) == components * sizeof(double));
  return bound<member>(Row::Kind::vector, kNumbers, key, doc).of(range).of(components);
}

/// Numbers by station, std::vector<double>: an array, or one number for all.
template <auto member>
constexpr Row stations(std::string_view key, const Quantity& range, std::string_view doc) {
  static_assert(std::is_same_v<typename MemberOf<decltype(member)>::Type, std::vector<double>>);
  return bound<member>(Row::Kind::numbers, kNumber | kNumbers, key, doc).of(range);
}

/// One of the values of an enumeration that has a function name_of(), in the order of messages.
template <auto member, auto... values>
constexpr Row choice(std::string_view key, std::string_view doc) {
  using S = typename MemberOf<decltype(member)>::Structure;
  Row row = bound<member>(Row::Kind::choice, kWord, key, doc);
  row.word_count = sizeof...(values);
  row.word = [](std::size_t i) -> std::string_view {
    constexpr std::array all{values...};
    return name_of(all[i]);
  };
  row.chosen = [](const void* of) {
    constexpr std::array all{values...};
    std::size_t i = 0;
    while (i + 1 < all.size() && all[i] != static_cast<const S*>(of)->*member) ++i;
    return i;
  };
  row.choose = [](void* of, std::size_t i) {
    constexpr std::array all{values...};
    static_cast<S*>(of)->*member = all[i];
  };
  return row;
}

/// A key that is known and documented here, and read and written by hand.
constexpr Row by_hand(std::string_view key, Forms forms, std::string_view doc) {
  return {key, doc, Row::Kind::by_hand, forms};
}
/// Numbers that are read by hand.
constexpr Row by_hand(std::string_view key, Forms forms, const Quantity& range,
                      std::string_view doc) {
  return by_hand(key, forms, doc).of(range);
}

/// Conditions of rows by the structure, for when(), ranging() and present().
template <class S, bool (*condition)(const S&)>
bool holds(const void* of) {
  return condition(*static_cast<const S*>(of));
}
template <class S, Quantity (*range)(const S&)>
Quantity range_by(const void* of) {
  return range(*static_cast<const S*>(of));
}
template <class S, Presence (*presence)(const S&)>
Presence presence_by(const void* of) {
  return presence(*static_cast<const S*>(of));
}

using Rows = std::span<const Row>;

/// Returns whether a row of a structure counts, and its range and presence.
inline bool applies(const Row& row, const void* of) { return !row.applies || row.applies(of); }
inline Quantity range_of(const Row& row, const void* of) {
  return row.range_by ? row.range_by(of) : row.range;
}
inline Presence presence_of(const Row& row, const void* of) {
  return row.presence_by ? row.presence_by(of) : row.presence;
}

/// Returns the member of a structure, whose type is that of the row's kind.
template <class T>
T& member_of(const Row& row, void* of) {
  return *static_cast<T*>(row.member(of));
}
template <class T>
const T& member_of(const Row& row, const void* of) {
  return *static_cast<const T*>(row.member(const_cast<void*>(of)));
}

/// Calls visit(key, value, range, presence) for the numbers of a structure, in the order of the
/// rows: double, int if `visit` takes it, and Vector unless it is void. Other rows are passed over.
template <class Vector, class S, class Visit>
void visit_numbers(Rows rows, S& of, const Visit& visit) {
  using Erased = std::conditional_t<std::is_const_v<S>, const void*, void*>;
  const Erased erased = &of;
  for (const Row& row : rows) {
    if (!applies(row, erased)) continue;
    const Presence presence = presence_of(row, erased);
    if (row.kind == Row::Kind::number)
      visit(row.key, member_of<double>(row, erased), range_of(row, erased), presence);
    if constexpr (requires(int& whole) { visit(row.key, whole, row.count, presence); })
      if (row.kind == Row::Kind::count)
        visit(row.key, member_of<int>(row, erased), row.count, presence);
    if constexpr (!std::is_void_v<Vector>)
      if (row.kind == Row::Kind::vector)
        visit(row.key, member_of<Vector>(row, erased), range_of(row, erased), presence);
  }
}

/// Calls visit(key, value, range) for numbers that may be missing.
template <class S, class Visit>
void visit_options(Rows rows, S& of, const Visit& visit) {
  using Erased = std::conditional_t<std::is_const_v<S>, const void*, void*>;
  for (const Row& row : rows)
    if (row.kind == Row::Kind::option)
      visit(row.key, member_of<std::optional<double>>(row, Erased{&of}), row.range);
}

/// Calls visit(key, values, range) for numbers by station.
template <class S, class Visit>
void visit_stations(Rows rows, S& of, const Visit& visit) {
  using Erased = std::conditional_t<std::is_const_v<S>, const void*, void*>;
  for (const Row& row : rows)
    if (row.kind == Row::Kind::numbers)
      visit(row.key, member_of<std::vector<double>>(row, Erased{&of}), row.range);
}

/// Returns the words of a choice, or of a key by hand.
std::vector<std::string_view> words_of(const Row& row);

/// Returns ", key value" for each number and choice of a structure that is not the default, but
/// those in `said`: what a sentence about the structure has not said.
std::string describe_others(Rows rows, const void* of, std::span<const std::string_view> said = {});

}  // namespace spoke::keys
