#pragma once

// Output of commands: labelled lines, the model, tables.

#include <string>
#include <string_view>
#include <vector>

#include "engine/simulation.h"
#include "program/report/page.h"

namespace spoke::cli {

/// Prints one line: a label in a column of its own, then text.
void print_line(std::string_view label, std::string_view text);

/// Returns the text with control characters replaced by spaces, for messages of one line.
std::string one_line(std::string text);

/// Prints the title of a scenario as a line.
void print_title(const std::string& title);

/// Prints title, sizes of the model and of its step graph.
void print_model(const Simulation& simulation);

/// Prints the model, and how its steps are solved on each of so many processes.
void print_plan(const Simulation& simulation, int processes);

/// Warns on stderr of what is valid but looks wrong, find_hints(), a line each. `file`: the
/// scenario's.
void warn_of_oddities(const std::string& file, const Scenario& scenario);

/// Returns the heads of the columns of sensors.csv behind the time's, as cells (csv_cell.h).
std::vector<std::string> column_heads(const Simulation& simulation);

/// Prints a table in columns as wide as their widest cell, after an empty line.
void print_table(const report::Table& table);

}  // namespace spoke::cli
