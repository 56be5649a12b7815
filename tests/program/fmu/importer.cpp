#include "tests/program/fmu/importer.h"

#include <dlfcn.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <stdexcept>

#include "tests/file_text.h"

namespace spoke::test {
namespace {

using Log = void(void*, int, const char*, const char*);

void keep(void* environment, int status, const char* category, const char* text) {
  static_cast<std::vector<Message>*>(environment)->push_back({status, category, text});
}

std::string unescape(std::string text) {
  for (const auto& [escaped, plain] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}})
    text = std::regex_replace(text, std::regex(escaped), plain);
  return text;
}

}  // namespace

LoadedFmu::LoadedFmu(const std::filesystem::path& folder)
    : folder_(folder), description_(file_text(folder / "modelDescription.xml")) {
  const bool is_2 = attribute("fmiVersion") == "2.0";
  token_ = attribute(is_2 ? "guid" : "instantiationToken");
  read_variables();
  const std::filesystem::path file = folder / "binaries" /
                                     (is_2 ? SPOKE_FMU_PLATFORM_2 : SPOKE_FMU_PLATFORM) /
                                     (attribute("modelIdentifier") + ".so");
  library_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library_) throw std::runtime_error(dlerror());
}

LoadedFmu::~LoadedFmu() { dlclose(library_); }

void* LoadedFmu::symbol(const char* name) const {
  void* found = dlsym(library_, name);
  if (!found) throw std::runtime_error(std::string("no function ") + name);
  return found;
}

std::string LoadedFmu::attribute(const std::string& name) const {
  std::smatch match;
  if (!std::regex_search(description_, match, std::regex(name + "=\"([^\"]*)\"")))
    throw std::runtime_error("no attribute " + name);
  return unescape(match[1]);
}

void LoadedFmu::read_variables() {
  const std::regex variable(
      "<(?:Float64|ScalarVariable) name=\"([^\"]*)\" "
      "valueReference=\"([0-9]+)\"[^>]*causality=\"([a-z]+)\"");
  for (std::sregex_iterator it(description_.begin(), description_.end(), variable), end; it != end;
       ++it) {
    const std::string name = unescape((*it)[1]), causality = (*it)[3];
    references_[name] = static_cast<std::uint32_t>(std::stoul((*it)[2]));
    if (causality == "input") inputs_.push_back(name);
    if (causality == "output") outputs_.push_back(name);
  }
}

FmuInstance::FmuInstance(const LoadedFmu& fmu, const std::string& token,
                         const std::string& resources)
    : fmu_(fmu) {
  using Make = void*(const char*, const char*, const char*, bool, bool, bool, bool,
                     const std::uint32_t*, std::size_t, void*, Log*, void*);
  handle_ = fmu.function<Make>("fmi3InstantiateCoSimulation")(
      "test", (token.empty() ? fmu.token() : token).c_str(),
      (resources.empty() ? fmu.resources().string() : resources).c_str(), false, true, false, false,
      nullptr, 0, &messages, keep, nullptr);
}

FmuInstance::~FmuInstance() { fmu_.function<void(void*)>("fmi3FreeInstance")(handle_); }

int FmuInstance::errors() const {
  return static_cast<int>(std::count_if(messages.begin(), messages.end(), [](const Message& each) {
    return each.status != kWarning;
  }));
}

int FmuInstance::enter_initialization(double start, std::optional<double> stop) {
  using Enter = int(void*, bool, double, double, bool, double);
  return fmu_.function<Enter>("fmi3EnterInitializationMode")(handle_, false, 0.0, start,
                                                             stop.has_value(), stop.value_or(0.0));
}

int FmuInstance::initialize(double start, std::optional<double> stop) {
  const int status = enter_initialization(start, stop);
  return status == kOk ? call("fmi3ExitInitializationMode") : status;
}

int FmuInstance::call(const char* function) { return fmu_.function<int(void*)>(function)(handle_); }

int FmuInstance::step(double point, double size) {
  using Step = int(void*, double, double, bool, bool*, bool*, bool*, double*);
  bool event = true, ends = true, early = true;
  const int status = fmu_.function<Step>("fmi3DoStep")(handle_, point, size, true, &event, &ends,
                                                       &early, &reached);
  if (status == kOk) CHECK((!event && !ends && !early));
  return status;
}

int FmuInstance::set(const std::vector<std::string>& names, const std::vector<double>& values) {
  using Set = int(void*, const std::uint32_t*, std::size_t, const double*, std::size_t);
  std::vector<std::uint32_t> references;
  for (const std::string& name : names) references.push_back(fmu_.reference(name));
  return fmu_.function<Set>("fmi3SetFloat64")(handle_, references.data(), references.size(),
                                              values.data(), values.size());
}

int FmuInstance::get(const std::vector<std::uint32_t>& references, std::vector<double>& values) {
  using Get = int(void*, const std::uint32_t*, std::size_t, double*, std::size_t);
  return fmu_.function<Get>("fmi3GetFloat64")(handle_, references.data(), references.size(),
                                              values.data(), values.size());
}

std::vector<double> FmuInstance::get(const std::vector<std::string>& names) {
  std::vector<std::uint32_t> references;
  for (const std::string& name : names) references.push_back(fmu_.reference(name));
  std::vector<double> values(names.size());
  const int status = get(references, values);
  CAPTURE(last());
  CHECK(status == kOk);
  return values;
}

int FmuInstance::get_state(void** state) {
  return fmu_.function<int(void*, void**)>("fmi3GetFMUState")(handle_, state);
}
int FmuInstance::set_state(void* state) {
  return fmu_.function<int(void*, void*)>("fmi3SetFMUState")(handle_, state);
}
int FmuInstance::free_state(void** state) {
  return fmu_.function<int(void*, void**)>("fmi3FreeFMUState")(handle_, state);
}

std::vector<std::uint8_t> FmuInstance::serialize(void* state) {
  std::size_t size = 0;
  CHECK(fmu_.function<int(void*, void*, std::size_t*)>("fmi3SerializedFMUStateSize")(handle_, state,
                                                                                     &size) == kOk);
  std::vector<std::uint8_t> bytes(size);
  CHECK(fmu_.function<int(void*, void*, std::uint8_t*, std::size_t)>("fmi3SerializeFMUState")(
            handle_, state, bytes.data(), size) == kOk);
  return bytes;
}

int FmuInstance::deserialize(const std::vector<std::uint8_t>& bytes, void** state) {
  using Read = int(void*, const std::uint8_t*, std::size_t, void**);
  return fmu_.function<Read>("fmi3DeserializeFMUState")(handle_, bytes.data(), bytes.size(), state);
}

}  // namespace spoke::test
