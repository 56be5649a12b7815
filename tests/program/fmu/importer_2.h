#pragma once

// A small importer of FMUs of FMI 2.0, written from the text of that standard and not from Spoke's
// declarations.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/program/fmu/importer.h"

namespace spoke::test {

/// What an importer of FMI 2.0 hands over with an instance.
struct Callbacks2 {
  void (*logger)(void*, const char*, int, const char*, const char*, ...) = nullptr;
  void* (*allocate)(std::size_t, std::size_t) = nullptr;
  void (*free)(void*) = nullptr;
  void (*finished)(void*, int) = nullptr;
  void* environment = nullptr;
};

/// An instance for co-simulation of an FMU that is loaded.
class Fmu2Instance {
 public:
  /// Empty: the FMU's own token, and the location of its resources.
  explicit Fmu2Instance(const LoadedFmu& fmu, const std::string& token = "",
                        const std::string& location = "", int type = 1);
  ~Fmu2Instance();
  Fmu2Instance(const Fmu2Instance&) = delete;
  Fmu2Instance& operator=(const Fmu2Instance&) = delete;

  void* handle() const { return handle_; }
  int initialize(double start = 0.0, std::optional<double> stop = {});
  int set_up(double start, std::optional<double> stop = {});
  /// Calls a function that takes the instance alone.
  int call(const char* function);
  int step(double point, double size);
  int set(const std::vector<std::string>& names, const std::vector<double>& values);
  /// Returns values, and fails a check unless that is allowed.
  std::vector<double> get(const std::vector<std::string>& names);
  std::vector<double> outputs() { return get(fmu_.outputs()); }
  int get(const std::vector<unsigned>& references, std::vector<double>& values);

  int get_state(void** state);
  int set_state(void* state);
  int free_state(void** state);
  std::vector<char> serialize(void* state);
  int deserialize(const std::vector<char>& bytes, void** state);

  std::vector<Message> messages;
  /// The text of the last message; empty if there is none.
  std::string last() const { return messages.empty() ? "" : messages.back().text; }

 private:
  const LoadedFmu& fmu_;
  void* handle_ = nullptr;
};

}  // namespace spoke::test
