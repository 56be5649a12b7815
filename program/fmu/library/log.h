#pragma once

// Messages of an instance to its importer.

#include <functional>
#include <string>

namespace spoke::fmu {

/// What a message is about; the values are those of fmi2Status and fmi3Status.
enum class Grade { warning = 1, error = 3 };

/// Where the messages of an instance go.
struct MessageSink {
  /// Hands a message with its category to the importer; may be empty.
  std::function<void(Grade, const char* category, const char* text)> log;
  bool warns = false;  ///< whether warnings are asked for

  /// Hands one message over; errors always, warnings if they are asked for.
  void send(Grade grade, const std::string& text) const noexcept;
};

/// While it lives, what the engine logs on this thread goes to `sink`.
class LogsTo {
 public:
  explicit LogsTo(const MessageSink& sink) noexcept;
  ~LogsTo();
  LogsTo(const LogsTo&) = delete;
  LogsTo& operator=(const LogsTo&) = delete;

 private:
  const MessageSink* before_;
};

}  // namespace spoke::fmu
