// Stands in for engine/support/log.cpp, whose lines go to a logger of spdlog: those of an FMU go to
// its importer.

#include "program/fmu/library/log.h"

#include "engine/support/log.h"

namespace spoke {
namespace {

thread_local const fmu::MessageSink* current = nullptr;

}  // namespace

bool is_heard(LogLevel level) {
  return current && (level == LogLevel::error || (level == LogLevel::warning && current->warns));
}

void log(LogLevel level, const std::string& text) {
  if (is_heard(level))
    current->send(level == LogLevel::error ? fmu::Grade::error : fmu::Grade::warning, text);
}

namespace fmu {

void MessageSink::send(Grade grade, const std::string& text) const noexcept {
  if (!log || (grade == Grade::warning && !warns)) return;
  log(grade, grade == Grade::warning ? "logStatusWarning" : "logStatusError", text.c_str());
}

LogsTo::LogsTo(const MessageSink& sink) noexcept : before_(current) { current = &sink; }
LogsTo::~LogsTo() { current = before_; }

}  // namespace fmu
}  // namespace spoke
