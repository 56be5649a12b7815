#pragma once

// A small importer of FMUs, written from the text of FMI 3.0 and not from Spoke's declarations: it
// finds the functions by their names and calls them with the types that the standard gives them.
// What it loads may be of FMI 2.0, too: importer_2.h has its instances.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace spoke::test {

/// The statuses of FMI, by their numbers.
enum Status { kOk = 0, kWarning = 1, kDiscard = 2, kError = 3, kFatal = 4 };

/// A message of an instance.
struct Message {
  int status = 0;
  std::string category, text;
};

/// An FMU in a folder, with its shared object loaded.
class LoadedFmu {
 public:
  explicit LoadedFmu(const std::filesystem::path& folder);
  ~LoadedFmu();
  LoadedFmu(const LoadedFmu&) = delete;
  LoadedFmu& operator=(const LoadedFmu&) = delete;

  /// Returns a function by its name, cast to a pointer to it.
  template <class Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }
  std::uint32_t reference(const std::string& name) const { return references_.at(name); }
  const std::vector<std::string>& inputs() const { return inputs_; }
  const std::vector<std::string>& outputs() const { return outputs_; }
  const std::string& token() const { return token_; }
  const std::string& description() const { return description_; }
  std::filesystem::path resources() const { return folder_ / "resources" / ""; }
  /// An attribute of the model description that occurs once.
  std::string attribute(const std::string& name) const;

 private:
  void* symbol(const char* name) const;
  void read_variables();

  std::filesystem::path folder_;
  std::string description_;  ///< the model description
  std::string token_;
  std::map<std::string, std::uint32_t> references_;
  std::vector<std::string> inputs_, outputs_;
  void* library_ = nullptr;
};

/// An instance of an FMU. Functions return statuses.
class FmuInstance {
 public:
  /// Makes it; handle() is null where the FMU refuses. `token`: in place of the right one.
  explicit FmuInstance(const LoadedFmu& fmu, const std::string& token = "",
                       const std::string& resources = "");
  ~FmuInstance();
  FmuInstance(const FmuInstance&) = delete;
  FmuInstance& operator=(const FmuInstance&) = delete;

  void* handle() const { return handle_; }
  int initialize(double start = 0.0, std::optional<double> stop = {});
  int enter_initialization(double start = 0.0, std::optional<double> stop = {});
  /// Calls a function that takes the instance alone.
  int call(const char* function);
  int step(double point, double size);
  int set(const std::vector<std::string>& names, const std::vector<double>& values);
  /// Returns values, and fails a check unless that is allowed.
  std::vector<double> get(const std::vector<std::string>& names);
  std::vector<double> outputs() { return get(fmu_.outputs()); }
  int get(const std::vector<std::uint32_t>& references, std::vector<double>& values);

  int get_state(void** state);
  int set_state(void* state);
  int free_state(void** state);
  std::vector<std::uint8_t> serialize(void* state);
  int deserialize(const std::vector<std::uint8_t>& bytes, void** state);

  /// Time up to which the last step has come.
  double reached = 0.0;
  std::vector<Message> messages;
  /// The number of messages that are no warnings.
  int errors() const;
  /// The text of the last message; empty if there is none.
  std::string last() const { return messages.empty() ? "" : messages.back().text; }

 private:
  const LoadedFmu& fmu_;
  void* handle_ = nullptr;
};

}  // namespace spoke::test
