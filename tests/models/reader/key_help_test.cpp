// What is said of keys: every key of every table is found by its path.

#include "models/reader/keys/key_help.h"

#include <doctest/doctest.h>

#include <string>

#include "models/reader/keys/tables.h"
#include "tests/contains.h"

using namespace spoke;
using test::contains;

TEST_CASE("every key and every table is explained by its path, and by its name") {
  for (const keys::Table& table : keys::tables())
    for (const keys::Part& part : table.parts)
      for (const keys::Row& row : part.rows) {
        const std::string path =
            (table.id.empty() ? "" : std::string(table.id) + '.') + std::string(row.key);
        CAPTURE(path);
        const std::string text = keys::explain(path);
        CHECK(contains(text, std::string(row.key) + " of "));
        CHECK_FALSE(contains(text, "`"));
        CHECK_FALSE(contains(text, "]("));
        CHECK(contains(keys::explain(row.key), std::string(row.key) + " of "));
        if (!table.id.empty()) CHECK(contains(keys::explain(table.id), std::string(row.key)));
      }
}

TEST_CASE("indices, brackets and the tables around a table do not matter") {
  const std::string stop = keys::explain("joint.stop.stiffness");
  CHECK(contains(stop, "stiffness of [joint.stop], stops\n"));
  CHECK(keys::explain("blade.joint.2.stop.stiffness") == stop);
  CHECK(keys::explain("[[blade.joint]]") == keys::explain("blade.joint"));
  CHECK_FALSE(contains(keys::explain("hub.drive.speed"), "[wind]"));
}

TEST_CASE("of a key that is none the nearest is named") {
  CHECK(keys::explain("hub.drive.sped").empty());
  CHECK(keys::find_alike("hub.drive.sped") == "speed");
  CHECK(keys::explain("").empty());
  CHECK(keys::explain("..").empty());
  CHECK(keys::find_alike("zzzzzzzzzz").empty());
}
