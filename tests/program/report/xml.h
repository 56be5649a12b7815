#pragma once

#include <string>
#include <string_view>

/// Returns what keeps a text from being well-formed XML (elements, attributes, text and the five
/// entities, which are all that drawings use); empty if nothing does.
std::string xml_fault(std::string_view text);

/// Counts how often `part` occurs in `text`.
int count_of(std::string_view text, std::string_view part);
