// The tables of keys in the documents are those of the rows, and each is there once.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "models/reader/keys/tables.h"
#include "models/text_file.h"

using namespace spoke;

namespace {

/// Tables of documents that are told in prose, or in a table of what they mean together.
constexpr std::array<std::string_view, 14> kInProse{"[control]",
                                                    "[gravity] in space",
                                                    "trees",
                                                    "stops",
                                                    "motions",
                                                    "efforts",
                                                    "materials",
                                                    "scales",
                                                    "nodes",
                                                    "schedules",
                                                    "nodes at a plane",
                                                    "nodes at a cylinder",
                                                    "nodes in a box",
                                                    "geometric stiffness"};

/// Compares the tables of a document, and adds their names.
void check_tables(const std::string& document, std::multiset<std::string>& names) {
  const std::string text = read_text(SPOKE_DOCS_DIR "/" + document);
  const std::string begin = "<!-- keys: ", middle = " -->\n\n", end = "\n<!-- end of keys -->";
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    at += begin.size();
    const std::size_t name_end = text.find(middle, at), table = name_end + middle.size();
    REQUIRE(name_end != std::string::npos);
    const std::string name = text.substr(at, name_end - at);
    CAPTURE(name);
    INFO("spoke schema --markdown | docs/write_keys.py writes it");
    CHECK(text.substr(table, text.find(end, table) - table) == keys::to_markdown(name));
    names.insert(name);
  }
}

}  // namespace

TEST_CASE("documents have the tables of the rows") {
  std::multiset<std::string> written;
  check_tables("scenario.md", written);
  check_tables("wind.md", written);
  for (const std::string_view name : keys::document_names()) {
    CAPTURE(name);
    const bool is_in_prose = std::find(kInProse.begin(), kInProse.end(), name) != kInProse.end();
    CHECK(written.count(std::string(name)) == (is_in_prose ? 0 : 1));
  }
}

TEST_CASE("tables in Markdown leave out columns without a cell") {
  CHECK(keys::to_markdown("[output]") ==
        "| key of `[output]` | meaning | unit | default | range |\n|---|---|---|---|---|\n"
        "| `interval` | time between the rows of `sensors.csv`, and between the files of `--vtk`; "
        "0: every step | s | 0.05 | 0 or more |\n");
  CHECK(keys::to_markdown("[hub.mount]").starts_with("| key of `[hub.mount]` | meaning | unit |"));
  CHECK(keys::to_markdown("nothing of this name").empty());
}

TEST_CASE("every row has a line of documentation that fits into a table") {
  for (const keys::Table& table : keys::tables())
    for (const keys::Part& part : table.parts)
      for (const keys::Row& row : part.rows) {
        CAPTURE(part.name);
        CAPTURE(row.key);
        CHECK(row.forms != 0);
        CHECK(row.doc.find('|') == std::string_view::npos);
        CHECK(row.doc.find('\n') == std::string_view::npos);
        if (row.key != "chord" && row.key != "start" && row.key != "time_step")
          CHECK(!row.doc.empty());
      }
}
