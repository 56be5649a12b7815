#pragma once

// Messages of an instance to its importer.

#include <string>

#include "program/fmu/fmi3.h"

namespace spoke::fmu {

/// Where the messages of an instance go.
struct MessageSink {
  fmi3InstanceEnvironment environment = nullptr;
  fmi3LogMessageCallback log = nullptr;  ///< may be null
  bool warns = false;                    ///< whether warnings are asked for

  /// Hands one message over; errors always, warnings if they are asked for.
  void send(fmi3Status status, const std::string& text) const noexcept;
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
