#pragma once

#include <string>

namespace spoke::cli {

/// Says on a line of the terminal (stderr) what is being done; an empty text clears it. Nothing
/// where stderr is not a terminal.
void show_progress(const std::string& text);

}  // namespace spoke::cli
