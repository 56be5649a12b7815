#pragma once

// Asks the caller's function from inside a team of threads.

#include <exception>
#include <functional>

namespace spoke::graph {

/// Asks whether another pass is wanted, from inside a team of threads, which an exception must not
/// leave: an exception counts as no, and is thrown again when the team has ended.
class PassQuestion {
 public:
  explicit PassQuestion(const std::function<bool()>& more) : more_(more) {}

  bool ask() noexcept {
    try {
      return more_();
    } catch (...) {
      exception_ = std::current_exception();
      return false;
    }
  }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  const std::function<bool()>& more_;
  std::exception_ptr exception_;
};

}  // namespace spoke::graph
