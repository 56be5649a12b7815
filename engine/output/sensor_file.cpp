// Formats rows, keeps their checksum, and continues a file behind a checkpoint.

#include "engine/sensor_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "engine/support/hash.h"
#include "models/count_text.h"
#include "models/error.h"

namespace spoke {
namespace {

constexpr std::size_t kBuffer = 64 * 1024;  // bytes of rows that are written together

void append_number(std::string& text, double number) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number + 0.0).ptr;
  text.append(buffer.data(), end);
}

[[noreturn]] void refuse_sensors(const std::string& file, const std::string& reason) {
  throw InputError(file + ": cannot be continued: " + reason);
}

/// Calls `take` for the marked beginning of a file, piece by piece. Throws InputError if the file
/// is shorter, cannot be read, or holds other bytes.
template <class Take>
void read_marked(const std::string& file, const SensorFileMark& mark, const Take& take) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_sensors(file, std::strerror(errno));
  std::string piece(kBuffer, '\0');
  std::uint32_t checksum = 0;
  std::uint64_t done = 0;
  while (done < mark.bytes) {
    const std::uint64_t wanted = std::min<std::uint64_t>(piece.size(), mark.bytes - done);
    stream.read(piece.data(), static_cast<std::streamsize>(wanted));
    const auto count = static_cast<std::size_t>(stream.gcount());
    if (count == 0)
      refuse_sensors(file, "it has " + counted(static_cast<std::int64_t>(done), "byte") +
                               ", the checkpoint was made behind " + std::to_string(mark.bytes));
    checksum = checksum_of({piece.data(), count}, checksum);
    take(std::string_view(piece.data(), count));
    done += count;
  }
  if (checksum != mark.checksum)
    refuse_sensors(file, "its first " + std::to_string(mark.bytes) +
                             " bytes are not those that stood there when the checkpoint was made");
}

/// Opens `file` to write behind the mark. Throws unless `source` begins with the marked bytes.
OutputFile open_behind(const std::string& file, const SensorFileMark& mark,
                       const std::string& source) {
  read_marked(source, mark, [](std::string_view) {});
  std::error_code ignored;
  if (std::filesystem::equivalent(file, source, ignored))
    return OutputFile(file, OutputFile::Start::existing);
  return OutputFile(file);
}

}  // namespace

SensorFile::SensorFile(std::string file, const std::vector<std::string>& names)
    : output_(std::move(file)) {
  lines_ += 't';
  for (const std::string& name : names) lines_ += ',' + name;
  end_line();
}

SensorFile::SensorFile(std::string file, const SensorFileMark& mark, const std::string& source)
    : output_(open_behind(file, mark, source)), checksum_(mark.checksum) {
  if (output_.size() == 0)
    read_marked(source, mark, [this](std::string_view piece) { output_.append(piece); });
  else
    output_.cut(mark.bytes);
}

void SensorFile::write_row(double t, std::span<const double> values) {
  append_number(lines_, t);
  for (const double value : values) {
    lines_ += ',';
    append_number(lines_, value);
  }
  end_line();
}

void SensorFile::end_line() {
  lines_ += '\n';
  if (lines_.size() >= kBuffer) flush();
}

void SensorFile::flush() {
  const std::uint64_t before = output_.size();
  try {
    output_.append(lines_);
  } catch (const InputError&) {
    const std::string_view written(lines_.data(), output_.size() - before);
    const std::size_t rows = written.rfind('\n') + 1;  // 0 if there is none
    try {
      output_.cut(before + rows);
    } catch (const InputError&) {  // a device: the first error matters
    }
    throw;
  }
  checksum_ = checksum_of(lines_, checksum_);
  lines_.clear();
}

SensorFileMark SensorFile::sync() {
  flush();
  output_.sync();
  return {output_.size(), checksum_};
}

void SensorFile::close() {
  flush();
  output_.close();
}

void read_rows(const std::string& file,
               const std::function<void(double t, std::span<const double> values)>& visit) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);  // names
  std::vector<double> numbers;
  while (std::getline(stream, line)) {
    numbers.clear();
    const char* const end = line.data() + line.size();
    for (const char* at = line.data(); at < end; ++at) {
      double number = 0.0;
      at = std::from_chars(at, end, number).ptr;  // to the comma
      numbers.push_back(number);
    }
    if (!numbers.empty()) visit(numbers.front(), std::span(numbers).subspan(1));
  }
  if (!stream.eof()) throw InputError(file + ": cannot be read");
}

}  // namespace spoke
