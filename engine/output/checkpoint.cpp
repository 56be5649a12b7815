// Writes the bytes of a checkpoint file, and checks them on reading (docs/checkpoint.md).

#include "engine/checkpoint.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <istream>
#include <iterator>
#include <sstream>
#include <system_error>

#include "engine/output_file.h"
#include "engine/support/byte_order.h"
#include "engine/support/hash.h"
#include "engine/support/log.h"
#include "models/count_text.h"
#include "models/error.h"
#include "models/support/instructions.h"

namespace spoke {
namespace {

// The frame, which all formats share: magic, format, length of the content, content, checksum of
// all bytes before it.
constexpr std::string_view kMagic = "SPOKECKP";
constexpr std::uint32_t kFormat = 9;
constexpr std::size_t kHeader = 8 + 4 + 8;
constexpr std::size_t kFrame = kHeader + 4;

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
  throw InputError(name + ": " + reason, {.file = name});
}

void add_state(const SavedState& state, ByteWriter& content) {
  content.add_text(state.model ? *state.model : std::string());
  content.add_number(state.time);
  content.add(static_cast<std::uint64_t>(state.steps));
  content.add(static_cast<std::uint64_t>(state.evaluations));
  content.add_number(state.work);
  content.add_number(state.dissipated);
  content.add_count(state.values.size());
  for (const double value : state.values) content.add_number(value);
  content.add(static_cast<std::uint8_t>(state.control.has_value()));
  if (!state.control) return;
  content.add(static_cast<std::uint64_t>(state.control->sampled));
  content.add_count(state.control->commands.size());
  for (const double value : state.control->commands) content.add_number(value);
  content.add_text(state.control->memory);
}

void add_record(const RunRecord& record, ByteWriter& content) {
  for (const double value :
       {record.output_interval, record.next_multiple, record.last_row, record.wall_time})
    content.add_number(value);
  content.add_count(record.ranges.size());
  for (const SensorRange& range : record.ranges)
    for (const double value : {range.min, range.t_min, range.max, range.t_max, range.final})
      content.add_number(value);
  content.add_count(record.tips.size());
  for (const TipExtreme& tip : record.tips) {
    content.add_number(tip.largest);
    content.add_number(tip.time);
  }
  content.add(record.rows.bytes);
  content.add(record.rows.checksum);
}

SavedState take_state(ByteReader& content) {
  SavedState state;
  state.model = std::make_shared<const std::string>(content.take_text());
  state.time = content.take_number();
  state.steps = static_cast<std::int64_t>(content.take<std::uint64_t>());
  state.evaluations = static_cast<std::int64_t>(content.take<std::uint64_t>());
  state.work = content.take_number();
  state.dissipated = content.take_number();
  state.values.resize(content.take_count(sizeof(double)));
  for (double& value : state.values) value = content.take_number();
  if (content.take<std::uint8_t>() == 0) return state;
  SavedControl& control = state.control.emplace();
  control.sampled = static_cast<std::int64_t>(content.take<std::uint64_t>());
  control.commands.resize(content.take_count(sizeof(double)));
  for (double& value : control.commands) value = content.take_number();
  control.memory = content.take_text();
  return state;
}

RunRecord take_record(ByteReader& content) {
  RunRecord record;
  for (double* value :
       {&record.output_interval, &record.next_multiple, &record.last_row, &record.wall_time})
    *value = content.take_number();
  record.ranges.resize(content.take_count(5 * sizeof(double)));
  for (SensorRange& range : record.ranges)
    for (double* value : {&range.min, &range.t_min, &range.max, &range.t_max, &range.final})
      *value = content.take_number();
  record.tips.resize(content.take_count(2 * sizeof(double)));
  for (TipExtreme& tip : record.tips) {
    tip.largest = content.take_number();
    tip.time = content.take_number();
  }
  record.rows.bytes = content.take<std::uint64_t>();
  record.rows.checksum = content.take<std::uint32_t>();
  return record;
}

void log_file(const std::string& file, const char* what, const SavedState& state,
              std::size_t bytes) {
  if (!is_heard(LogLevel::debug)) return;
  std::ostringstream text;
  text << file << ": " << what << " a checkpoint: t = " << state.time << " s, step " << state.steps
       << ", " << counted(static_cast<std::int64_t>(bytes), "byte");
  log(LogLevel::debug, text.str());
}

std::string hexadecimal(std::uint32_t number) {
  char text[16];
  std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(number));
  return text;
}

/// Reads a whole checkpoint; from other files only the beginning, since a device may have no end.
std::string read_bytes(std::istream& stream) {
  std::string bytes(kMagic.size(), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (bytes == kMagic)
    bytes.append(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  return bytes;
}

/// Returns the content of an intact frame of this format.
std::string_view require_frame(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) refuse(name, "is empty, expected a checkpoint");
  if (!kMagic.starts_with(bytes.substr(0, kMagic.size())))
    refuse(name, "is no checkpoint of Spoke");
  const auto refuse_length = [&](const std::string& expected) {
    refuse(name,
           "is truncated: has " + counted(std::ssize(bytes), "byte") + ", expected " + expected);
  };
  if (bytes.size() < kFrame) refuse_length("at least " + std::to_string(kFrame));
  ByteReader header(bytes.substr(kMagic.size()));
  const auto format = header.take<std::uint32_t>();
  const auto length = header.take<std::uint64_t>();
  if (length > bytes.size() - kFrame) refuse_length(std::to_string(length) + " and a frame");
  if (length < bytes.size() - kFrame) refuse(name, "is damaged: has bytes behind its end");
  ByteReader end(bytes.substr(bytes.size() - 4));
  const auto expected = end.take<std::uint32_t>();
  const std::uint32_t found = checksum_of(bytes.substr(0, bytes.size() - 4));
  if (found != expected)
    refuse(name, "is damaged: its checksum is " + hexadecimal(found) + ", expected " +
                     hexadecimal(expected));
  if (format != kFormat)
    refuse(name, "is of format " + std::to_string(format) + ", this version of Spoke (" +
                     SPOKE_VERSION + ") reads format " + std::to_string(kFormat));
  return bytes.substr(kHeader, static_cast<std::size_t>(length));
}

}  // namespace

std::string make_checkpoint(const SavedState& state, const std::optional<RunRecord>& record) {
  ByteWriter content;
  content.add_text(SPOKE_VERSION);
  content.add_text(std::string(instructions_in_use()));
  add_state(state, content);
  content.add(static_cast<std::uint8_t>(record.has_value()));
  if (record) add_record(*record, content);
  ByteWriter header;
  header.add(kFormat);
  header.add_count(content.bytes().size());
  std::string bytes = std::string(kMagic) + header.bytes() + content.bytes();
  ByteWriter end;
  end.add(checksum_of(bytes));
  return bytes + end.bytes();
}

Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name) {
  ByteReader content(require_frame(bytes, name));
  Checkpoint checkpoint;
  checkpoint.program = content.take_text();
  checkpoint.instructions = content.take_text();
  checkpoint.state = take_state(content);
  const auto has_record = content.take<std::uint8_t>();
  if (has_record == 1) checkpoint.record = take_record(content);
  if (!content.is_done() || has_record > 1) refuse(name, "is damaged: its parts do not fit");
  return checkpoint;
}

void save_checkpoint(const std::string& file, const SavedState& state,
                     const std::optional<RunRecord>& record) {
  const std::string bytes = make_checkpoint(state, record);
  replace_file(file, bytes);
  log_file(file, "wrote", state, bytes.size());
}

Checkpoint load_checkpoint(const std::string& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    refuse(file, "is a directory, expected a checkpoint");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(file, std::string("cannot be read: ") + std::strerror(errno));
  const std::string bytes = read_bytes(stream);
  if (stream.bad()) refuse(file, std::string("cannot be read: ") + std::strerror(errno));
  Checkpoint checkpoint = parse_checkpoint(bytes, file);
  log_file(file, "read", checkpoint.state, bytes.size());
  return checkpoint;
}

}  // namespace spoke
