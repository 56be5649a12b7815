#include "tests/program/fmu/importer_2.h"

#include <doctest/doctest.h>

#include <cstdarg>
#include <cstdio>

namespace spoke::test {
namespace {

/// A message is a format, as of printf.
void keep_formatted(void* environment, const char* name, int status, const char* category,
                    const char* format, ...) {
  CHECK(std::string(name) == "test");
  char text[4096];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  static_cast<std::vector<Message>*>(environment)->push_back({status, category, text});
}

/// Returns the URI of a folder.
std::string location_of(const std::filesystem::path& folder) {
  std::string uri = "file://";
  for (const char c : folder.string()) uri += c == ' ' ? "%20" : std::string(1, c);
  return uri;
}

}  // namespace

Fmu2Instance::Fmu2Instance(const LoadedFmu& fmu, const std::string& token,
                           const std::string& location, int type)
    : fmu_(fmu) {
  using Make = void*(const char*, int, const char*, const char*, const Callbacks2*, int, int);
  const Callbacks2 callbacks{keep_formatted, nullptr, nullptr, nullptr, &messages};
  handle_ = fmu.function<Make>("fmi2Instantiate")(
      "test", type, (token.empty() ? fmu.token() : token).c_str(),
      (location.empty() ? location_of(fmu.resources()) : location).c_str(), &callbacks, 0, 1);
}

Fmu2Instance::~Fmu2Instance() { fmu_.function<void(void*)>("fmi2FreeInstance")(handle_); }

int Fmu2Instance::set_up(double start, std::optional<double> stop) {
  using SetUp = int(void*, int, double, double, int, double);
  return fmu_.function<SetUp>("fmi2SetupExperiment")(handle_, 0, 0.0, start, stop.has_value(),
                                                     stop.value_or(0.0));
}

int Fmu2Instance::initialize(double start, std::optional<double> stop) {
  for (const int status : {set_up(start, stop), call("fmi2EnterInitializationMode")})
    if (status != kOk) return status;
  return call("fmi2ExitInitializationMode");
}

int Fmu2Instance::call(const char* function) {
  return fmu_.function<int(void*)>(function)(handle_);
}

int Fmu2Instance::step(double point, double size) {
  return fmu_.function<int(void*, double, double, int)>("fmi2DoStep")(handle_, point, size, 1);
}

int Fmu2Instance::set(const std::vector<std::string>& names, const std::vector<double>& values) {
  std::vector<unsigned> references;
  for (const std::string& name : names) references.push_back(fmu_.reference(name));
  using Set = int(void*, const unsigned*, std::size_t, const double*);
  return fmu_.function<Set>("fmi2SetReal")(handle_, references.data(), references.size(),
                                           values.data());
}

int Fmu2Instance::get(const std::vector<unsigned>& references, std::vector<double>& values) {
  using Get = int(void*, const unsigned*, std::size_t, double*);
  return fmu_.function<Get>("fmi2GetReal")(handle_, references.data(), references.size(),
                                           values.data());
}

std::vector<double> Fmu2Instance::get(const std::vector<std::string>& names) {
  std::vector<unsigned> references;
  for (const std::string& name : names) references.push_back(fmu_.reference(name));
  std::vector<double> values(names.size());
  const int status = get(references, values);
  CAPTURE(last());
  CHECK(status == kOk);
  return values;
}

int Fmu2Instance::get_state(void** state) {
  return fmu_.function<int(void*, void**)>("fmi2GetFMUstate")(handle_, state);
}
int Fmu2Instance::set_state(void* state) {
  return fmu_.function<int(void*, void*)>("fmi2SetFMUstate")(handle_, state);
}
int Fmu2Instance::free_state(void** state) {
  return fmu_.function<int(void*, void**)>("fmi2FreeFMUstate")(handle_, state);
}

std::vector<char> Fmu2Instance::serialize(void* state) {
  std::size_t size = 0;
  CHECK(fmu_.function<int(void*, void*, std::size_t*)>("fmi2SerializedFMUstateSize")(handle_, state,
                                                                                     &size) == kOk);
  std::vector<char> bytes(size);
  CHECK(fmu_.function<int(void*, void*, char*, std::size_t)>("fmi2SerializeFMUstate")(
            handle_, state, bytes.data(), size) == kOk);
  return bytes;
}

int Fmu2Instance::deserialize(const std::vector<char>& bytes, void** state) {
  using Read = int(void*, const char*, std::size_t, void**);
  return fmu_.function<Read>("fmi2DeSerializeFMUstate")(handle_, bytes.data(), bytes.size(), state);
}

}  // namespace spoke::test
