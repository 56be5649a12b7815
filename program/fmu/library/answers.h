#pragma once

// How the functions of FMI answer. No exception leaves them: an error becomes a status and a
// message. Handles of instances that are not there are told apart from others.

#include <cstddef>
#include <exception>
#include <new>
#include <string>

#include "program/fmu/fmi2.h"
#include "program/fmu/fmi3.h"
#include "program/fmu/library/log.h"

namespace spoke::fmu {

class Instance;

/// How a call has ended, as a status of either version.
struct Answer {
  bool is_done = false;  ///< else there was an error

  operator fmi2Status() const { return is_done ? fmi2OK : fmi2Error; }
  operator fmi3Status() const { return is_done ? fmi3OK : fmi3Error; }
};

/// Notes a new instance of this process.
void enlist(Instance& instance);
/// Returns the instance of a handle; null if there is none, or no longer.
Instance* find(const void* handle);
/// Returns it likewise, and forgets it.
Instance* strike_off(const void* handle);
/// Returns where the messages of an instance go.
const MessageSink& messages_of(Instance& instance);

/// Does the work of a function, and turns what it throws into a status and a message.
template <class Work>
Answer guard(const MessageSink& messages, const char* function, const Work& work) noexcept {
  try {
    const LogsTo sink(messages);
    work();
    return {true};
  } catch (const std::bad_alloc&) {
    messages.send(Grade::error, "no memory");
  } catch (const std::exception& error) {
    messages.send(Grade::error, std::string(function) + ": " + error.what());
  }
  return {};
}

/// Does the work of a function on an instance, likewise.
template <class Work>
Answer call(const void* handle, const char* function, const Work& work) noexcept {
  Instance* instance = find(handle);
  if (!instance) return {};
  return guard(messages_of(*instance), function, [&] { work(*instance); });
}

/// Returns the text of an importer; empty for a null pointer.
std::string text_or_empty(const char* text);

/// Throws InputError, which names `which`, unless pointers are there.
void require_pointers(bool are_there, const char* which);

/// Answers functions for types of which there are no variables: an error unless `count` is 0.
Answer no_variables(const void* handle, const char* function, std::size_t count);

/// Answers functions of what there is not.
Answer not_there(const void* handle, const char* function, const char* what);

}  // namespace spoke::fmu
