#pragma once

// Messages to the program that embeds the library: they go to the spdlog logger that it has
// registered as "spoke", and nowhere if there is none. docs/guide.md lists them.

#include <string>

namespace spoke {

enum class LogLevel { debug, info, warning, error };

/// Whether messages of this level are logged: else their texts need not be made. Takes a lock of
/// spdlog's, so it is not for code that runs in every step.
bool is_heard(LogLevel level);

/// Hands one message to the logger, on the calling thread; a logger that fails is no error here.
void log(LogLevel level, const std::string& text);

}  // namespace spoke
