// Laws that hold for every key with a row: what is out of range, of a wrong type or misspelt is
// refused in the words of its row, by readers and by the check of what is filled in code.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "models/reader/keys/tables.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/spatial_fields.h"
#include "models/reader/toml_document.h"
#include "tests/message_of.h"

using namespace spoke;
using keys::Row;
using spoke::test::message_of;

namespace {

/// Calls visit(row) for every row that is bound to a member, of one of these kinds.
template <class Visit>
void visit_rows(std::initializer_list<Row::Kind> kinds, const Visit& visit) {
  for (const keys::Table& table : keys::tables())
    for (const keys::Part& part : table.parts)
      for (const Row& row : part.rows)
        for (const Row::Kind kind : kinds)
          if (row.kind == kind && keys::applies(row, row.standard())) {
            CAPTURE(part.name);
            CAPTURE(row.key);
            visit(row);
          }
}

/// Returns the message with which a row refuses a value. What is refused is not written, so that
/// the structure stays as it is.
std::string refusal(const Row& row, const std::string& value) {
  const TomlDocument document(std::string(row.key) + " = " + value, "f.toml");
  const TomlSection section(document, {row.key});
  return message_of([&] { keys::read_row(section, row, const_cast<void*>(row.standard())); });
}

/// Returns the message that a row's value is wrong.
std::string wrong(const Row& row, const std::string& value, const std::string& expected) {
  const std::string key(row.key);
  return "f.toml:1:" + std::to_string(key.size() + 4) + ": " + key + ": is " + value +
         ", expected " + expected;
}

std::string text_of(double number) { return describe(number); }

}  // namespace

TEST_CASE("numbers beyond their range are refused by every row") {
  int checked = 0;
  visit_rows({Row::Kind::number, Row::Kind::option}, [&](const Row& row) {
    const Quantity range = keys::range_of(row, row.standard());
    if (std::isfinite(range.least)) {
      const double below = range.least_included ? range.least - 1.0 : range.least;
      CHECK(refusal(row, text_of(below)) == wrong(row, text_of(below), range.expectation()));
      ++checked;
    }
    if (std::isfinite(range.greatest)) {
      const double above = range.greatest_included ? range.greatest + 1.0 : range.greatest;
      CHECK(refusal(row, text_of(above)) == wrong(row, text_of(above), range.expectation()));
      ++checked;
    }
    const std::string unit = in_parentheses(range.unit);
    CHECK(refusal(row, "nan") == wrong(row, "nan", "a finite number" + unit));
    if (!std::isfinite(range.greatest))
      CHECK(refusal(row, "2e30") ==
            wrong(row, "2e+30", "0 or a magnitude from 1e-40 to 1e+30" + unit));
  });
  CHECK(checked > 60);
}

TEST_CASE("counts beyond their range are refused by every row") {
  int checked = 0;
  visit_rows({Row::Kind::count}, [&](const Row& row) {
    for (const std::string& value :
         {std::to_string(std::int64_t{row.count.least} - 1),
          std::to_string(std::int64_t{row.count.greatest} + 1), std::string("1.5")})
      CHECK(refusal(row, value) == wrong(row, value, row.count.expectation()));
    ++checked;
  });
  CHECK(checked > 5);
}

TEST_CASE("values of a wrong type are refused by every row") {
  visit_rows({Row::Kind::number, Row::Kind::option}, [](const Row& row) {
    const std::string expected = keys::range_of(row, row.standard()).expectation();
    CHECK(refusal(row, "\"a\"") == wrong(row, "\"a\"", expected));
    CHECK(refusal(row, "true") == wrong(row, "true", expected));
    CHECK(refusal(row, "[1]") == wrong(row, "an array (1)", expected));
  });
  visit_rows({Row::Kind::count}, [](const Row& row) {
    CHECK(refusal(row, "\"a\"") == wrong(row, "\"a\"", row.count.expectation()));
  });
  visit_rows({Row::Kind::flag},
             [](const Row& row) { CHECK(refusal(row, "1") == wrong(row, "1", "true or false")); });
  visit_rows({Row::Kind::choice}, [](const Row& row) {
    const std::string expected = join_names(keys::words_of(row));
    CHECK(refusal(row, "\"no_word\"") == wrong(row, "\"no_word\"", expected));
    CHECK(refusal(row, "1") == wrong(row, "1", expected));
  });
  visit_rows({Row::Kind::vector}, [](const Row& row) {
    const std::string expected = "an array of 3 numbers" + in_parentheses(row.range.unit);
    CHECK(refusal(row, "1") == wrong(row, "1", expected));
    CHECK(refusal(row, "[1, 2]") == wrong(row, "an array (2)", expected));
  });
}

TEST_CASE("what a row requires is asked for") {
  visit_rows({Row::Kind::number, Row::Kind::option, Row::Kind::count}, [](const Row& row) {
    if (keys::presence_of(row, row.standard()) != Presence::required) return;
    const TomlDocument document("", "f.toml");
    const TomlSection section(document, {row.key});
    const std::string expected = keys::range_of(row, row.standard()).expectation();
    CHECK(message_of([&] { keys::read_row(section, row, const_cast<void*>(row.standard())); }) ==
          "f.toml:1:1: " + std::string(row.key) + ": is missing, expected " + expected);
  });
}

TEST_CASE("a default is within its range") {
  visit_rows({Row::Kind::number}, [](const Row& row) {
    if (keys::presence_of(row, row.standard()) == Presence::required) return;
    const double standard = keys::member_of<double>(row, row.standard());
    CHECK(keys::range_of(row, row.standard()).expectation_instead_of(standard).empty());
  });
  visit_rows({Row::Kind::count}, [](const Row& row) {
    CHECK(row.count.holds(keys::member_of<int>(row, row.standard())));
  });
}

TEST_CASE("every key of every table is suggested where one letter is missing") {
  for (const keys::Table& table : keys::tables()) {
    std::vector<keys::Rows> parts;
    for (const keys::Part& part : table.parts) parts.push_back(part.rows);
    TomlSection::Keys known;
    for (const keys::Rows& rows : parts)
      for (const std::string_view key : keys::keys_of(rows)) known.push_back(key);
    for (const std::string_view key : known) {
      constexpr std::size_t kLongEnough = 6;
      if (key.size() < kLongEnough) continue;
      const std::string slip(key.substr(0, key.size() - 1));
      if (std::find(known.begin(), known.end(), slip) != known.end()) continue;
      CAPTURE(key);
      const TomlDocument document(slip + " = 1", "f.toml");
      CHECK(message_of([&] { const TomlSection section(document, known); }) ==
            "f.toml:1:1: " + slip + ": unknown key, did you mean \"" + std::string(key) + "\"?");
    }
  }
}

TEST_CASE("keys whose unit is that of their joint have rows, too") {
  const auto check = [](const auto& structure, const auto& unit, keys::Rows rows) {
    const TomlSection::Keys known = keys::keys_of({rows});
    int count = 0;
    spatial::visit_fields(structure, unit, [&](std::string_view key, const auto&...) {
      CAPTURE(key);
      CHECK(std::find(known.begin(), known.end(), key) != known.end());
      ++count;
    });
    return count;
  };
  CHECK(check(spatial::Stop{}, spatial::kAngleUnits, keys::kStopRows) == 5);
  CHECK(check(spatial::AzimuthMotion{}, spatial::kAngleUnits, keys::kMotionRows) == 3);
  CHECK(check(spatial::JointCoordinate{}, spatial::kAngleUnits, keys::kJointRows) == 5);
  CHECK(check(spatial::VectorHarmonic{}, "m", keys::kCourseRows) == 5);
}
