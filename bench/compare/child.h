#pragma once

// A child process that answers lines with lines, and can be halted between them.

#include <sys/types.h>

#include <string>
#include <vector>

namespace spoke::compare {

/// A program to start.
struct Command {
  std::string program;                   ///< path of the executable file
  std::vector<std::string> arguments;    ///< behind the program's name
  std::vector<std::string> environment;  ///< the whole environment, as "NAME=value"
  std::string input = {};                ///< first text on its standard input
};

/// The answer of a child, or the reason why there is none.
struct Answer {
  enum class Kind {
    line,
    late,   ///< nothing within the time allowed
    ended,  ///< the child has ended, or closed its output
  };
  Kind kind = Kind::ended;
  std::string text;  ///< the line without its end
};

/// A process that is asked by lines on its standard input and answers by lines on its standard
/// output; what it writes to standard error is dropped. It never outlives this process.
class Child {
 public:
  /// Throws std::system_error if no process can be made. If the program cannot be run, the child
  /// ends at once.
  explicit Child(const Command& command);
  /// Kills the child if it still runs.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Sends a line. Does nothing if the child has ended; receive() then says so.
  void send(const std::string& line);
  Answer receive(double seconds_allowed);

  /// Halts all threads of the child wherever they are, so that spinning ones leave the processors
  /// to others; go_on() lets them go on.
  void halt();
  void go_on();

 private:
  void reap(int options);
  void send_text(const std::string& text);

  pid_t process_ = -1;  ///< -1 once it has ended
  int socket_ = -1;
  std::string received_;  ///< beginning of the next line
};

}  // namespace spoke::compare
