#pragma once

// A line on the terminal that says what a long command is doing.

#include <string>

namespace spoke::cli {

/// Says on a line of the terminal (stderr) what is being done; an empty text clears it. Nothing
/// where stderr is not a terminal.
void show_progress(const std::string& text);

}  // namespace spoke::cli
