#pragma once

#include <string>
#include <string_view>

/// What keeps a text from being well-formed XML (elements, attributes, text and the five entities,
/// which is all that drawings use); empty if nothing does.
std::string xml_fault(std::string_view text);

/// How often `part` occurs in `text`.
int count_of(std::string_view text, std::string_view part);
