#pragma once

// Reads tables of the file by the rows of their keys, and writes them as JSON.

#include "models/reader/toml_section.h"
#include "models/support/json.h"
#include "models/support/key_row.h"

namespace spoke::keys {

/// Returns the keys that a table may have: those of all rows, in their order.
TomlSection::Keys keys_of(std::initializer_list<Rows> parts);
template <class... Parts>
TomlSection::Keys keys_of(const Parts&... parts) {
  return keys_of({Rows(parts)...});
}

/// Reads numbers, vectors, flags and choices into a structure, in the order of the rows. Keys by
/// hand and numbers by station are left to others. Throws InputError.
void read(const TomlSection& section, Rows rows, void* to);
/// Reads one of them.
void read_row(const TomlSection& section, const Row& row, void* to);

/// Returns the words of a key by hand. Precondition: it has some.
TomlSection::Keys words_of(Rows rows, std::string_view key);
/// Reads one of these words, and returns its index.
std::size_t read_word(const TomlSection& section, Rows rows, std::string_view key);

/// Adds numbers, vectors, flags and choices of a structure to a JSON object, in the order of the
/// rows.
void write(Rows rows, const void* from, Json& json);
/// Adds those alone that are choices, or that are numbers.
void write_words(Rows rows, const void* from, Json& json);
void write_numbers(Rows rows, const void* from, Json& json);

}  // namespace spoke::keys
