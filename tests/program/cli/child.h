#pragma once

// Runs the program spoke beside the test, which may send it signals.

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/program/cli/program.h"

/// How a process ended: by itself, or by a signal.
struct ChildEnded {
  int status = -1;  ///< exit status; -1 if a signal ended it
  int signal = 0;   ///< that ended it, else 0
  std::string err;
};

/// A running spoke with the folder as working directory. Its signals act as in a terminal, whatever
/// those of the test do. Killed if it still runs at the end.
class Child {
 public:
  /// most_bytes: limit of the size of its files; 0: none.
  Child(const std::vector<std::string>& arguments, const WorkFolder& folder,
        std::uint64_t most_bytes = 0);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void send(int signal) const;
  bool is_running();
  ChildEnded wait();
  pid_t process() const { return process_; }

 private:
  WorkFolder texts_;
  pid_t process_ = -1;
  bool has_ended_ = false;
  int how_ = 0;
};

/// Waits until `is_so`, at most 60 s; false if it did not come to that.
template <class Condition>
bool wait_until(const Condition& is_so);

/// The size of a file, 0 if there is none [bytes].
std::uint64_t size_of(const std::filesystem::path& file);

void sleep_seconds(double seconds);

template <class Condition>
bool wait_until(const Condition& is_so) {
  for (int k = 0; k < 60'000; ++k) {
    if (is_so()) return true;
    sleep_seconds(1e-3);
  }
  return false;
}
