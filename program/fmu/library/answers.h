#pragma once

// How the functions of FMI answer. No exception leaves them: an error becomes a status and a
// message. Handles of instances that are not there are told apart from others.

#include <exception>
#include <new>
#include <string>

#include "program/fmu/fmi3.h"
#include "program/fmu/library/log.h"

namespace spoke::fmu {

class Instance;

/// Notes a new instance of this process.
void enlist(const Instance& instance);
/// Returns the instance of a handle; null if there is none, or no longer.
Instance* find(fmi3Instance handle);
/// Returns it likewise, and forgets it.
Instance* strike_off(fmi3Instance handle);
/// Returns where the messages of an instance go.
const MessageSink& messages_of(Instance& instance);

/// Does the work of a function, and turns what it throws into a status and a message.
template <class Work>
fmi3Status guard(const MessageSink& messages, const char* function, const Work& work) noexcept {
  try {
    const LogsTo sink(messages);
    work();
    return fmi3OK;
  } catch (const std::bad_alloc&) {
    messages.send(fmi3Error, "no memory");
  } catch (const std::exception& error) {
    messages.send(fmi3Error, std::string(function) + ": " + error.what());
  }
  return fmi3Error;
}

/// Does the work of a function on an instance, likewise.
template <class Work>
fmi3Status call(fmi3Instance handle, const char* function, const Work& work) noexcept {
  Instance* instance = find(handle);
  if (!instance) return fmi3Error;
  return guard(messages_of(*instance), function, [&] { work(*instance); });
}

/// Answers functions for types of which there are no variables: an error unless `count` is 0.
fmi3Status no_variables(fmi3Instance handle, const char* function, std::size_t count);

/// Answers functions of what there is not.
fmi3Status not_there(fmi3Instance handle, const char* function, const char* what);

}  // namespace spoke::fmu
