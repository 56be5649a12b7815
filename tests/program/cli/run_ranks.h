#pragma once

// Runs in several processes, for tests.

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// The summary of a run without what depends on time and machine.
nlohmann::json figures_in(const std::filesystem::path& folder);

/// The arguments of a run of a shipped scenario, on one thread of each process.
std::vector<std::string> run_of(const std::string& scenario, const std::string& duration,
                                const std::vector<std::string>& further);

/// How many times `part` is in `text`.
std::size_t count_of(const std::string& part, const std::string& text);
