// One loop over rows for each direction.

#include "models/reader/row_reader.h"

#include <algorithm>
#include <cassert>

namespace spoke::keys {
namespace {

void read_present(const TomlSection& section, const Row& row, void* to) {
  switch (row.kind) {
    case Row::Kind::number:
      member_of<double>(row, to) = section.number(row.key, range_of(row, to));
      break;
    case Row::Kind::option:
      member_of<std::optional<double>>(row, to) = section.number(row.key, range_of(row, to));
      break;
    case Row::Kind::count:
      member_of<int>(row, to) = section.integer(row.key, row.count);
      break;
    case Row::Kind::flag:
      member_of<bool>(row, to) = section.flag(row.key, false);
      break;
    case Row::Kind::choice:
      row.choose(to, section.choice(row.key, words_of(row)));
      break;
    case Row::Kind::vector: {
      const std::vector<double> values = section.numbers(row.key, range_of(row, to), row.size);
      std::copy(values.begin(), values.end(), &member_of<double>(row, to));
      break;
    }
    default:
      break;
  }
}

void write_row(const Row& row, const void* from, Json& json) {
  if (!applies(row, from)) return;
  switch (row.kind) {
    case Row::Kind::number:
      json.set(row.key, member_of<double>(row, from));
      break;
    case Row::Kind::option:
      if (const auto& value = member_of<std::optional<double>>(row, from))
        json.set(row.key, *value);
      break;
    case Row::Kind::count:
      json.set(row.key, member_of<int>(row, from));
      break;
    case Row::Kind::flag:
      json.set(row.key, member_of<bool>(row, from));
      break;
    case Row::Kind::choice:
      json.set(row.key, row.word(row.chosen(from)));
      break;
    case Row::Kind::vector: {
      const double* const values = &member_of<double>(row, from);
      json.set(row.key, std::vector<double>(values, values + row.size));
      break;
    }
    default:
      break;
  }
}

}  // namespace

TomlSection::Keys keys_of(std::initializer_list<Rows> parts) {
  TomlSection::Keys keys;
  for (const Rows& rows : parts)
    for (const Row& row : rows)
      if (std::find(keys.begin(), keys.end(), row.key) == keys.end()) keys.push_back(row.key);
  return keys;
}

void read_row(const TomlSection& section, const Row& row, void* to) {
  if (!applies(row, to)) return;
  if (presence_of(row, to) == Presence::required || section.has(row.key))
    read_present(section, row, to);
}

void read(const TomlSection& section, Rows rows, void* to) {
  for (const Row& row : rows) read_row(section, row, to);
}

TomlSection::Keys words_of(Rows rows, std::string_view key) {
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const Row& candidate) { return candidate.key == key; });
  assert(row != rows.end() && !row->words.empty());
  return words_of(*row);
}

std::size_t read_word(const TomlSection& section, Rows rows, std::string_view key) {
  return section.choice(key, words_of(rows, key));
}

void write(Rows rows, const void* from, Json& json) {
  for (const Row& row : rows) write_row(row, from, json);
}

void write_words(Rows rows, const void* from, Json& json) {
  for (const Row& row : rows)
    if (row.kind == Row::Kind::choice) write_row(row, from, json);
}

void write_numbers(Rows rows, const void* from, Json& json) {
  for (const Row& row : rows)
    if (row.kind == Row::Kind::number || row.kind == Row::Kind::count) write_row(row, from, json);
}

}  // namespace spoke::keys
