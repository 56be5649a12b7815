// Keeps the instances of the process.

#include "program/fmu/library/answers.h"

#include <map>
#include <mutex>
#include <string>

#include "models/error.h"
#include "program/fmu/library/instance.h"

namespace spoke::fmu {
namespace {

struct Register {
  std::mutex mutex;
  std::map<const void*, Instance*> instances;
};

Register& known() {
  static Register instances;
  return instances;
}

}  // namespace

void enlist(Instance& instance) {
  const std::lock_guard lock(known().mutex);
  known().instances[&instance] = &instance;
}

Instance* find(const void* handle) {
  const std::lock_guard lock(known().mutex);
  const auto found = known().instances.find(handle);
  return found == known().instances.end() ? nullptr : found->second;
}

Instance* strike_off(const void* handle) {
  const std::lock_guard lock(known().mutex);
  const auto found = known().instances.extract(handle);
  return found.empty() ? nullptr : found.mapped();
}

const MessageSink& messages_of(Instance& instance) { return instance.messages(); }

std::string text_or_empty(const char* text) { return text ? text : ""; }

void require_pointers(bool are_there, const char* which) {
  if (!are_there) throw InputError(std::string(which) + " is a null pointer");
}

Answer no_variables(const void* handle, const char* function, std::size_t count) {
  return call(handle, function, [&](Instance&) {
    if (count > 0) throw InputError("all variables of this FMU are real numbers (Real, Float64)");
  });
}

Answer not_there(const void* handle, const char* function, const char* what) {
  return call(handle, function,
              [&](Instance&) { throw InputError(std::string("this FMU has no ") + what); });
}

}  // namespace spoke::fmu
