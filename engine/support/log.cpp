// Finds the logger in spdlog's registry and hands it the line.

#include "engine/support/log.h"

#include <spdlog/spdlog.h>

namespace spoke {
namespace {

spdlog::level::level_enum level_of(LogLevel level) {
  switch (level) {
    case LogLevel::debug:
      return spdlog::level::debug;
    case LogLevel::info:
      return spdlog::level::info;
    case LogLevel::warning:
      return spdlog::level::warn;
    case LogLevel::error:
      break;
  }
  return spdlog::level::err;
}

/// Looked up at every message: the program may register and drop its logger at any time.
std::shared_ptr<spdlog::logger> find_logger() { return spdlog::get("spoke"); }

}  // namespace

bool is_heard(LogLevel level) {
  const std::shared_ptr<spdlog::logger> logger = find_logger();
  return logger && logger->should_log(level_of(level));
}

void log(LogLevel level, const std::string& text) {
  if (const std::shared_ptr<spdlog::logger> logger = find_logger())
    logger->log(level_of(level), spdlog::string_view_t(text));
}

}  // namespace spoke
