// Loads a private copy of the library, fills the records, and reads what it demands.

#include "engine/simulation/bladed_library.h"

#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/support/log.h"
#include "models/error.h"
#include "models/support/nearest_name.h"

namespace spoke {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRecords = 10000;  // of avrSWAP
constexpr std::size_t kMessage = 1024;   // characters of avcMSG
constexpr std::size_t kNameRoom = 4096;  // for libraries that write to their names

using Discon = void (*)(float* swap, int* fail, char* input, char* name, char* message);

[[noreturn]] void refuse(const std::string& file, const std::string& what) {
  throw InputError("control.library.file: is \"" + file + "\", " + what,
                   {.key = "control.library.file"});
}

/// A file that is removed when this is.
class TemporaryFile {
 public:
  /// Makes an empty one in a folder; without a name if that cannot be.
  explicit TemporaryFile(const fs::path& folder)
      : name_((folder / "spoke-discon-XXXXXX").string()) {
    const int file = mkstemp(name_.data());
    if (file < 0) name_.clear();
    if (file >= 0) close(file);
  }
  ~TemporaryFile() {
    if (!name_.empty()) unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// Returns a handle of a copy of the library; null if it cannot be loaded.
///
/// A library keeps its data in static variables, of which a process has one set for each file that
/// is loaded: simulations at the same time, and one after another, would share them. So each loads
/// a copy, which is removed at once: what is loaded stays. dlmopen() would do without a copy, but
/// has 16 name spaces at most, each with a C library of its own, and sanitizers and debuggers do
/// not know them.
void* load_copy(const std::string& file, const fs::path& folder) {
  const TemporaryFile copy(folder);
  std::error_code error;
  if (copy.name().empty() ||
      !fs::copy_file(file, copy.name(), fs::copy_options::overwrite_existing, error) || error)
    return nullptr;
  return dlopen(copy.name().c_str(), RTLD_NOW | RTLD_LOCAL);
}

class Library {
 public:
  explicit Library(const std::string& file) {
    std::error_code error;
    // Beside the file it finds what it names by its own place, by $ORIGIN; that folder may be one
    // that cannot be written.
    fs::path folder = fs::path(file).parent_path();
    if (folder.empty()) folder = ".";
    handle_ = load_copy(file, folder);
    if (!handle_) handle_ = load_copy(file, fs::temp_directory_path(error));
    if (!handle_) {
      const char* const why = dlerror();
      refuse(file, std::string("which cannot be loaded") + (why ? ": " + std::string(why) : "") +
                       ", expected a shared library with the function DISCON");
    }
    discon_ = reinterpret_cast<Discon>(dlsym(handle_, "DISCON"));
    if (discon_) return;
    dlclose(handle_);
    refuse(file, "which has no function DISCON, expected a shared library with that");
  }
  ~Library() { dlclose(handle_); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  Discon discon() const { return discon_; }

 private:
  void* handle_ = nullptr;
  Discon discon_ = nullptr;
};

std::vector<char> room_for(const std::string& text, std::size_t least) {
  std::vector<char> room(std::max(least, text.size() + 1), '\0');
  std::copy(text.begin(), text.end(), room.begin());
  return room;
}

class BladedLibrary final : public Controller {
 public:
  BladedLibrary(const OuterControl& place, double gear_ratio)
      : place_(place),
        gear_ratio_(gear_ratio),
        library_(place.file),
        swap_(kRecords, 0.0F),
        input_(room_for(place.input, kNameRoom)),
        name_(room_for(place.name, kNameRoom)),
        message_(kMessage + 1, '\0') {
    record(35) = 1.0F;  // the contactor is closed, the brake (36) off until it says else
  }
  ~BladedLibrary() override {
    if (!was_called_) return;
    record(1) = -1.0F;
    try {
      call();
    } catch (...) {  // nobody is left to hear it
    }
  }

  void begin(const std::vector<std::string>& sensors) override {
    const std::vector<std::string_view> known(sensors.begin(), sensors.end());
    for (const LibraryRecord& of : place_.records) {
      const auto found = std::find(known.begin(), known.end(), of.sensor);
      const std::size_t number = columns_.size() + 1;
      if (found == known.end())
        throw InputError("control.library.record." + std::to_string(number) +
                             ".sensor: " + describe_unknown(of.sensor, known),
                         {.key = "control.library.record." + std::to_string(number) + ".sensor"});
      columns_.push_back(static_cast<std::size_t>(found - known.begin()));
    }
  }

  void control(const ControlRecord& measured, ControlCommands& commands) override {
    if (measured.is_first)
      for (std::size_t k = 0; k < measured.blades.size(); ++k)
        demand_pitch(measured.blades[k].pitch);
    fill(measured);
    fill_constants(measured);
    for (std::size_t k = 0; k < columns_.size(); ++k)
      record(place_.records[k].number) =
          static_cast<float>(place_.records[k].factor * measured.sensors[columns_[k]]);
    was_called_ = true;
    const int fail = call();
    if (fail < 0) stop(measured);
    if (fail > 0) warn(measured);
    take(commands);
  }

 private:
  float& record(int number) { return swap_[static_cast<std::size_t>(number - 1)]; }
  double value(int number) { return static_cast<double>(record(number)); }
  void set(int number, double value) { record(number) = static_cast<float>(value); }

  /// Demands the pitch at the start, for libraries that set none in their first call.
  void demand_pitch(double angle) {
    for (const int number : {42, 43, 44, 45}) set(number, angle);
  }

  /// Calls the library, and returns aviFAIL.
  int call() {
    std::fill(message_.begin(), message_.end(), '\0');
    int fail = 0;
    library_.discon()(swap_.data(), &fail, input_.data(), name_.data(), message_.data());
    message_.back() = '\0';
    return fail;
  }

  void fill(const ControlRecord& measured) {
    const double generator = -measured.torque / gear_ratio_;
    const double speed = measured.drive_speed * gear_ratio_;
    set(1, measured.is_first ? 0.0 : 1.0);
    set(2, measured.time);
    set(3, measured.period);
    set(14, measured.speed * -measured.shaft_torque);
    set(15, place_.efficiency * generator * speed);
    set(20, speed);
    set(21, measured.speed);
    set(23, generator);
    set(24, measured.yaw_error);
    set(27, measured.wind_speed);
    set(37, measured.yaw);
    set(53, measured.fore_aft);
    set(54, measured.side_side);
    set(60, measured.azimuth);
    set(109, -measured.shaft_torque);
    constexpr std::array pitch{4, 33, 34}, flap{30, 31, 32}, edge{69, 70, 71};
    for (std::size_t k = 0; k < std::min(pitch.size(), measured.blades.size()); ++k) {
      set(pitch[k], measured.blades[k].pitch);
      set(flap[k], measured.blades[k].out_of_plane_moment);
      set(edge[k], measured.blades[k].in_plane_moment);
    }
  }

  void fill_constants(const ControlRecord& measured) {
    set(10, 0.0);  // the actuator of pitch takes angles
    set(11, value(place_.individual_pitch ? 42 : 45));
    set(28, place_.individual_pitch ? 1.0 : 0.0);
    set(29, 0.0);  // the yaw takes rates
    set(49, static_cast<double>(message_.size()));
    set(50, static_cast<double>(place_.input.size() + 1));
    set(51, static_cast<double>(place_.name.size() + 1));
    set(61, static_cast<double>(measured.blades.size()));
    set(129, static_cast<double>(kRecords));
  }

  std::string message() const {
    std::string text(message_.data());
    const std::size_t end = text.find_last_not_of(" \n\r\t");
    text.resize(end == std::string::npos ? 0 : end + 1);
    return text.empty() ? "without a message" : text;
  }

  [[noreturn]] void stop(const ControlRecord& measured) {
    if (measured.is_first) refuse(place_.file, "which fails at its first call: " + message());
    std::ostringstream text;
    text << "diverged at t = " << measured.time << " s: control.library \"" << place_.file
         << "\" fails: " << message();
    throw DivergenceError(text.str(), {.time = measured.time, .quantity = "control"});
  }

  /// Logs what it warns of, once.
  void warn(const ControlRecord& measured) {
    if (std::exchange(has_warned_, true) || !is_heard(LogLevel::warning)) return;
    std::ostringstream text;
    text << "control.library \"" << place_.file << "\" at t = " << measured.time
         << " s: " << message();
    log(LogLevel::warning, text.str());
  }

  void take(ControlCommands& commands) {
    const bool is_connected = record(35) != 0.0F;
    commands.torque = is_connected ? -value(47) * gear_ratio_ : 0.0;
    for (std::size_t k = 0; k < commands.pitch.size(); ++k)
      commands.pitch[k] = value(place_.individual_pitch ? 42 + static_cast<int>(k) : 45);
    commands.yaw_rate = value(48);
    commands.brake = value(36);
  }

  OuterControl place_;
  double gear_ratio_;
  Library library_;
  std::vector<float> swap_;
  std::vector<char> input_, name_, message_;
  std::vector<std::size_t> columns_;  ///< sensors of place_.records
  bool was_called_ = false, has_warned_ = false;
};

}  // namespace

std::shared_ptr<Controller> make_bladed_library(const Scenario& scenario, SimulatedModel& model) {
  const OuterControl& place = *scenario.space->outer_control;
  double gear_ratio = place.gear_ratio.value_or(1.0);
  if (const auto& rotors = model.space()->system.rotors; !rotors.empty() && !place.gear_ratio)
    gear_ratio = std::abs(rotors.front().gear_ratio);
  return std::make_shared<BladedLibrary>(place, gear_ratio);
}

}  // namespace spoke
