#pragma once

// All tables of a scenario, each a list of rows, and what is made of them for people and editors.

#include <string>
#include <string_view>
#include <vector>

#include "models/support/json.h"
#include "models/support/key_row.h"

namespace spoke::keys {

/// Rows that documents show as one table.
struct Part {
  std::string_view name;  ///< of the documents' table: "[hub] in space"
  Rows rows;
  bool is_conditional = false;  ///< of some kinds of the table, or given by another one instead
  std::string_view more{};      ///< heading of the documents' last column
};

/// A table of the file. Several of one name are those of models in the plane and in space.
struct Table {
  std::string_view id;  ///< "hub.drive"; empty: the file itself
  std::vector<Part> parts;
};

const std::vector<Table>& tables();

/// Returns the names of the documents' tables, in their order, each once.
std::vector<std::string_view> document_names();

/// Returns the table of documents of this name in Markdown; empty if there is none. Columns in
/// which all cells are empty are left out.
std::string to_markdown(std::string_view name);

/// Returns a JSON schema, draft 7, by which editors complete and check scenario files. It takes
/// every file that the reader takes, but not only these: rules over several keys are not in it.
Json editor_schema();

}  // namespace spoke::keys
