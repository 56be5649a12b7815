// What the FMU adds stands before the bytes of a checkpoint, which has a checksum.

#include "program/fmu/library/model_state.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "engine/checkpoint.h"
#include "models/error.h"
#include "models/support/hash_bytes.h"

namespace spoke::fmu {
namespace {

constexpr std::string_view kMark = "SPOKEFMU5\n";
constexpr const char* kName = "the serialized state";

[[noreturn]] void fail(const std::string& why) {
  throw InputError(std::string(kName) + " " + why +
                   ", expected bytes that an instance of this FMU has serialized");
}

class Writer {
 public:
  void add(std::uint64_t value) {
    for (int k = 0; k < 8; ++k) bytes_ += static_cast<char>(value >> (8 * k));
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    bytes_ += text;
  }
  void add(const std::vector<double>& values) {
    add(std::uint64_t{values.size()});
    for (const double value : values) add(value);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t number() {
    const std::string_view part = take(8);
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < 8; ++k)
      value |= std::uint64_t{static_cast<unsigned char>(part[k])} << (8 * k);
    return value;
  }
  double real() { return std::bit_cast<double>(number()); }
  std::string_view text() { return take(number()); }
  std::size_t count() {
    const std::uint64_t count = number();
    if (count > rest_.size()) fail("is damaged");
    return count;
  }
  int index() {
    const std::uint64_t value = number();
    if (value > 1'000'000'000) fail("is damaged");
    return static_cast<int>(value);
  }
  std::vector<double> reals() {
    std::vector<double> values(count());
    for (double& value : values) value = real();
    return values;
  }

 private:
  std::string_view take(std::uint64_t size) {
    if (size > rest_.size()) fail("is cut short");
    const std::string_view part = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return part;
  }

  std::string_view rest_;
};

void add(const std::optional<double>& value, Writer& writer) {
  writer.add(std::uint64_t{value.has_value()});
  if (value) writer.add(*value);
}

std::optional<double> read_optional(Reader& reader) {
  if (reader.number() == 0) return std::nullopt;
  return reader.real();
}

void add(const std::optional<WindCourse>& wind, Writer& writer) {
  writer.add(std::uint64_t{wind.has_value()});
  if (!wind) return;
  writer.add(wind->begin);
  writer.add(wind->end);
  for (const Eigen::Vector3d* velocity : {&wind->velocity, &wind->target})
    for (const double component : *velocity) writer.add(component);
}

std::optional<WindCourse> read_wind(Reader& reader) {
  if (reader.number() == 0) return std::nullopt;
  WindCourse wind;
  wind.begin = reader.real();
  wind.end = reader.real();
  for (Eigen::Vector3d* velocity : {&wind.velocity, &wind.target})
    for (double& component : *velocity) component = reader.real();
  return wind;
}

/// Drives that inputs set; of the scenario's own the identity of the model knows all.
enum class SetDrive : std::uint64_t { none, torque, speed };

void add(const Drive& drive, Writer& writer) {
  const auto add_curve = [&](SetDrive kind, const Curve& curve, double initial_speed) {
    writer.add(static_cast<std::uint64_t>(kind));
    writer.add(curve.times());
    writer.add(curve.values());
    writer.add(initial_speed);
  };
  if (const auto* torque = std::get_if<TorqueDrive>(&drive))
    return add_curve(SetDrive::torque, torque->torque, torque->initial_speed);
  if (const auto* table = std::get_if<SpeedTable>(&drive))
    return add_curve(SetDrive::speed, table->speed, 0.0);
  writer.add(static_cast<std::uint64_t>(SetDrive::none));
}

Drive read_drive(Reader& reader, const Drive& own) {
  const auto kind = static_cast<SetDrive>(reader.number());
  if (kind == SetDrive::none) return own;
  std::vector<double> times = reader.reals(), values = reader.reals();
  const Curve curve(std::move(times), std::move(values));
  const double initial_speed = reader.real();
  if (kind == SetDrive::torque) return TorqueDrive{curve, initial_speed};
  if (kind != SetDrive::speed) fail("is damaged");
  return SpeedTable{curve};
}

}  // namespace

std::string write_state(const ModelState& state, const std::string& token) {
  Writer writer;
  writer.add(std::string_view(token));
  writer.add(static_cast<std::uint64_t>(state.mode));
  writer.add(state.start_time);
  add(state.stop_time, writer);
  writer.add(std::uint64_t{state.inputs.size()});
  for (const InputValue& input : state.inputs) {
    writer.add(input.value);
    writer.add(std::uint64_t{input.is_given});
  }
  add(state.courses.drive, writer);
  writer.add(std::uint64_t{state.courses.rotors.size()});
  for (const RotorDrive& of : state.courses.rotors) {
    writer.add(std::string_view(of.rotor));
    add(of.drive, writer);
  }
  writer.add(std::uint64_t{state.courses.joints.size()});
  for (const JointCourse& joint : state.courses.joints) {
    for (const int index : {joint.tree, joint.joint, joint.coordinate})
      writer.add(static_cast<std::uint64_t>(index));
    for (const double value :
         {joint.begin, joint.motion.value, joint.motion.velocity, joint.motion.acceleration})
      writer.add(value);
  }
  writer.add(std::uint64_t{state.courses.loads.size()});
  for (const LoadFactor& load : state.courses.loads) {
    writer.add(std::string_view(load.load));
    writer.add(load.factor);
  }
  add(state.courses.wind, writer);
  writer.add(std::uint64_t{state.courses.torques.size()});
  for (const JointTorque& torque : state.courses.torques) {
    for (const int index : {torque.tree, torque.joint, torque.coordinate})
      writer.add(static_cast<std::uint64_t>(index));
    writer.add(torque.torque);
  }
  writer.add(std::string_view(make_checkpoint(state.simulation)));
  const std::string& bytes = writer.bytes();
  Writer hash;
  hash.add(hash_bytes(bytes.data(), bytes.size()));
  return std::string(kMark) + hash.bytes() + bytes;
}

ModelState read_state(std::string_view bytes, const std::string& token, const Courses& own) {
  if (!bytes.starts_with(kMark)) fail("is of another kind");
  bytes.remove_prefix(kMark.size());
  Reader head(bytes);
  const std::uint64_t hash = head.number();
  bytes.remove_prefix(8);
  if (hash_bytes(bytes.data(), bytes.size()) != hash) fail("is damaged");
  Reader reader(bytes);
  if (reader.text() != token) fail("is of another FMU");
  ModelState state;
  const std::uint64_t mode = reader.number();
  if (mode > static_cast<std::uint64_t>(Mode::failed)) fail("is damaged");
  state.mode = static_cast<Mode>(mode);
  state.start_time = reader.real();
  state.stop_time = read_optional(reader);
  state.inputs.resize(reader.count());
  for (InputValue& input : state.inputs) {
    input.value = reader.real();
    input.is_given = reader.number() != 0;
  }
  state.courses.drive = read_drive(reader, own.drive);
  state.courses.rotors.resize(reader.count());
  for (RotorDrive& of : state.courses.rotors) {
    of.rotor = reader.text();
    const auto known = std::find_if(own.rotors.begin(), own.rotors.end(),
                                    [&](const RotorDrive& at) { return at.rotor == of.rotor; });
    if (known == own.rotors.end()) fail("is of another FMU");
    of.drive = read_drive(reader, known->drive);
  }
  state.courses.joints.resize(reader.count());
  for (JointCourse& joint : state.courses.joints) {
    joint.tree = reader.index();
    joint.joint = reader.index();
    joint.coordinate = reader.index();
    joint.begin = reader.real();
    joint.motion.value = reader.real();
    joint.motion.velocity = reader.real();
    joint.motion.acceleration = reader.real();
  }
  state.courses.loads.resize(reader.count());
  for (LoadFactor& load : state.courses.loads) {
    load.load = reader.text();
    load.factor = reader.real();
  }
  state.courses.wind = read_wind(reader);
  state.courses.torques.resize(reader.count());
  for (JointTorque& torque : state.courses.torques) {
    torque.tree = reader.index();
    torque.joint = reader.index();
    torque.coordinate = reader.index();
    torque.torque = reader.real();
  }
  state.simulation = parse_checkpoint(reader.text(), kName).state;
  return state;
}

}  // namespace spoke::fmu
