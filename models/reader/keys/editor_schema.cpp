// A JSON schema from the rows of keys. Where a key has several forms, or other ones in space, any
// of them will do.

#include <algorithm>
#include <cmath>
#include <string>

#include "models/reader/keys/key_cells.h"
#include "models/reader/keys/tables.h"

namespace spoke::keys {
namespace {

std::string reference_to(std::string_view id) { return "#/definitions/" + std::string(id); }

Json number_schema(const Quantity& range) {
  Json schema = {{"type", "number"}};
  if (std::isfinite(range.least))
    schema.set(range.least_included ? "minimum" : "exclusiveMinimum", range.least);
  if (std::isfinite(range.greatest))
    schema.set(range.greatest_included ? "maximum" : "exclusiveMaximum", range.greatest);
  return schema;
}

Json whole_schema(const Count& range) {
  Json schema = {{"type", "integer"}};
  if (range.greatest > range.least) {
    schema.set("minimum", range.least);
    schema.set("maximum", range.greatest);
  }
  return schema;
}

Json array_of(Json items, std::size_t size = 0) {
  Json schema = {{"type", "array"}, {"items", std::move(items)}, {"minItems", size ? size : 1}};
  if (size != 0) schema.set("maxItems", size);
  return schema;
}

Json words_schema(const Row& row) {
  Json words = Json::array();
  for (const std::string_view word : words_of(row)) words.push_back(word);
  return {{"type", "string"}, {"enum", std::move(words)}};
}

/// Returns what may stand there for a key of the table `parent`.
std::vector<Json> forms_of(const Row& row, std::string_view parent) {
  const std::string child =
      !row.table_id.empty()
          ? std::string(row.table_id)
          : std::string(parent) + (parent.empty() ? "" : ".") + std::string(row.key);
  Json table = {{"$ref", reference_to(child)}};
  std::vector<Json> forms;
  const auto add = [&](Forms form, const auto& make) {
    if ((row.forms & form) != 0) forms.push_back(make());
  };
  add(kNumber, [&] { return number_schema(row.range); });
  add(kWhole, [&] { return whole_schema(row.count); });
  add(kFlag, [] { return Json{{"type", "boolean"}}; });
  add(kWord, [&] { return words_schema(row); });
  add(kText, [] { return Json{{"type", "string"}}; });
  add(kNumbers, [&] { return array_of(number_schema(row.range), row.size); });
  add(kNumberArrays, [] { return array_of({{"type", "array"}}); });
  add(kTexts, [&] { return array_of({{"type", "string"}}, row.size); });
  add(kTable, [&] { return table; });
  add(kTables, [&] { return array_of(table); });
  add(kNamedNumbers, [&] {
    return Json{{"type", "object"}, {"additionalProperties", number_schema(row.range)}};
  });
  return forms;
}

/// Returns the value of a row in a new structure; null if documents have words for it.
Json default_of(const Row& row) {
  const bool is_plain = row.default_text.empty() && row.presence == Presence::optional &&
                        row.presence_by == nullptr && row.applies == nullptr;
  if (!is_plain || row.kind == Row::Kind::by_hand) return nullptr;
  const void* const made = row.standard();
  switch (row.kind) {
    case Row::Kind::number:
      return member_of<double>(row, made);
    case Row::Kind::count:
      return member_of<int>(row, made);
    case Row::Kind::flag:
      return member_of<bool>(row, made);
    case Row::Kind::choice:
      return row.word(row.chosen(made));
    default:
      return nullptr;
  }
}

/// A key of all tables of one name: its rows in the plane, in space and of several kinds.
struct Property {
  std::string_view key;
  std::vector<const Row*> rows;
  std::size_t required = 0;  ///< in so many tables without a condition
};

std::string description_of(const Property& property) {
  std::vector<std::string> texts;
  for (const Row* row : property.rows) {
    const std::string_view unit = row->unit_text.empty() ? row->range.unit : row->unit_text;
    std::string text = without_links(row->doc);
    if (!unit.empty()) text += (text.empty() ? "[" : " [") + std::string(unit) + ']';
    if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
  }
  std::string joined;
  for (const std::string& text : texts) joined += (joined.empty() ? "" : "\n\n") + text;
  return joined;
}

Json property_schema(const Property& property, std::string_view parent) {
  std::vector<Json> forms;
  std::vector<std::string> seen;
  for (const Row* row : property.rows)
    for (Json& form : forms_of(*row, parent)) {
      const std::string text = form.dump();
      if (std::find(seen.begin(), seen.end(), text) != seen.end()) continue;
      seen.push_back(text);
      forms.push_back(std::move(form));
    }
  Json schema = {{"description", description_of(property)}};
  const bool is_reference = seen.size() == 1 && seen.front().starts_with("{\"$ref\"");
  if (seen.size() == 1 && !is_reference) {
    schema.update(std::move(forms.front()));
  } else {
    // Beside a reference other members do not count in draft 7.
    Json list = Json::array();
    for (Json& form : forms) list.push_back(std::move(form));
    schema.set(is_reference ? "allOf" : "anyOf", std::move(list));
  }
  const Json standard = property.rows.size() == 1 ? default_of(*property.rows.front()) : nullptr;
  if (standard.dump() != "null") schema.set("default", standard);
  return schema;
}

/// Adds the rows of a table to the keys that others of its name have.
void add_rows(const Table& table, std::vector<Property>& properties) {
  for (const Part& part : table.parts)
    for (const Row& row : part.rows) {
      auto at = std::find_if(properties.begin(), properties.end(),
                             [&](const Property& property) { return property.key == row.key; });
      if (at == properties.end()) at = properties.insert(at, {row.key, {}, 0});
      at->rows.push_back(&row);
      if (row.presence == Presence::required && !row.applies && !part.is_conditional)
        ++at->required;
    }
}

Json table_schema(std::string_view id) {
  std::vector<Property> found;
  std::size_t count = 0;
  for (const Table& table : tables()) {
    if (table.id != id) continue;
    add_rows(table, found);
    ++count;
  }
  Json properties = Json::object(), required = Json::array();
  bool is_any_required = false;
  for (const Property& property : found) {
    properties.set(property.key, property_schema(property, id));
    if (property.required != count) continue;
    required.push_back(property.key);
    is_any_required = true;
  }
  Json schema = {
      {"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
  if (is_any_required) schema.set("required", std::move(required));
  return schema;
}

}  // namespace

Json editor_schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "A scenario of Spoke"}};
  schema.update(table_schema(""));
  Json definitions = Json::object();
  for (const Table& table : tables())
    if (!table.id.empty()) definitions.set(table.id, table_schema(table.id));
  schema.set("definitions", std::move(definitions));
  return schema;
}

}  // namespace spoke::keys
