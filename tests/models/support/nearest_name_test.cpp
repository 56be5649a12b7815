#include "models/support/nearest_name.h"

#include <doctest/doctest.h>

#include <string_view>
#include <vector>

using spoke::edit_distance;
using spoke::nearest_name;

TEST_CASE("edit distance counts insertions and deletions and replacements and swaps") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("length", "length") == 0);
  CHECK(edit_distance("length", "") == 6);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("lenth", "length") == 1);
  CHECK(edit_distance("lengthh", "length") == 1);
  CHECK(edit_distance("lingth", "length") == 1);
  CHECK(edit_distance("lenght", "length") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("the nearest name is suggested unless it is another word") {
  const std::vector<std::string_view> names = {"length", "bodies", "elements", "density"};
  CHECK(nearest_name("lenght", names) == "length");
  CHECK(nearest_name("body", names) == "bodies");
  CHECK(nearest_name("element", names) == "elements");
  CHECK_FALSE(nearest_name("colour", names).has_value());
  CHECK_FALSE(nearest_name("x", names).has_value());
}
