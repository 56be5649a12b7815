#pragma once

// reproduce.html and reproduce.json; docs/reproduce.md says what is in them.

#include <string>

#include "bench/reproduce/reproduction.h"

namespace spoke::reproduce {

std::string make_html(const Reproduction& reproduction);
std::string make_json(const Reproduction& reproduction);

}  // namespace spoke::reproduce
