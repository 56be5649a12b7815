#pragma once

// One paragraph for each table and figure: what agrees with the paper, what differs, and why.

#include <string>
#include <vector>

#include "engine/reproduce/reproduction.h"

namespace spoke::reproduce {

/// What makes times doubtful and keeps the remarks from a verdict, a sentence each.
std::vector<std::string> doubts_of(const Reproduction& reproduction);

std::string remark_on_counts();
std::string remark_on_drive(const Reproduction& reproduction);
std::string remark_on_deflection(const Reproduction& reproduction);
std::string remark_on_subsystem_threads(const Reproduction& reproduction);
std::string remark_on_layers(const Reproduction& reproduction);
std::string remark_on_inverse(const Reproduction& reproduction);
std::string remark_on_methods(const Reproduction& reproduction);

}  // namespace spoke::reproduce
