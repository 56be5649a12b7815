#pragma once

// SIGINT, SIGTERM and SIGHUP: the first one lets a command end in order.

#include <array>
#include <csignal>
#include <string>

namespace spoke::cli {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP is only noted, and a second one ends the
/// process as it would without. A signal that the process was started to ignore stays ignored. One
/// at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Returns the signal that was noted, or 0.
  static int signal();

 private:
  using Action = struct sigaction;
  std::array<Action, 3> before_{};  ///< handlers that were in place
};

/// Installs handlers so that a signal that ends the process, SIGINT, SIGTERM or SIGHUP, leaves no
/// unfinished file or empty folder (output_file.h). Signals that the process was started to ignore
/// stay ignored.
void clean_up_on_signals();

/// Writes files that belong together: a first SIGINT, SIGTERM or SIGHUP meanwhile ends the process
/// when all are there. Not within the life of an Interruption.
template <class Write>
void write_together(const Write& write) {
  int signal = 0;
  {
    const Interruption interruption;
    write();
    signal = Interruption::signal();
  }
  if (signal != 0) std::raise(signal);
}

/// Returns "SIGINT", "SIGTERM" or "SIGHUP".
std::string name_of_signal(int signal);

}  // namespace spoke::cli
