// Keeps the instances of the process.

#include "program/fmu/library/answers.h"

#include <mutex>
#include <set>
#include <string>

#include "models/error.h"
#include "program/fmu/library/instance.h"

namespace spoke::fmu {
namespace {

struct Register {
  std::mutex mutex;
  std::set<const void*> instances;
};

Register& known() {
  static Register instances;
  return instances;
}

}  // namespace

void enlist(const Instance& instance) {
  const std::lock_guard lock(known().mutex);
  known().instances.insert(&instance);
}

Instance* find(fmi3Instance handle) {
  const std::lock_guard lock(known().mutex);
  return known().instances.contains(handle) ? static_cast<Instance*>(handle) : nullptr;
}

Instance* strike_off(fmi3Instance handle) {
  const std::lock_guard lock(known().mutex);
  return known().instances.erase(handle) > 0 ? static_cast<Instance*>(handle) : nullptr;
}

const MessageSink& messages_of(Instance& instance) { return instance.messages(); }

fmi3Status no_variables(fmi3Instance handle, const char* function, std::size_t count) {
  return call(handle, function, [&](Instance&) {
    if (count > 0) throw InputError("all variables of this FMU are of the type Float64");
  });
}

fmi3Status not_there(fmi3Instance handle, const char* function, const char* what) {
  return call(handle, function,
              [&](Instance&) { throw InputError(std::string("this FMU has no ") + what); });
}

}  // namespace spoke::fmu
