// Writes records of a length, a checksum and a result, behind a head that identifies their study.

#include "program/study/journal.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "engine/support/byte_order.h"
#include "engine/support/hash.h"
#include "models/error.h"
#include "models/support/instructions.h"

namespace spoke::study {
namespace {

constexpr std::string_view kMagic = "SPOKESTUDY2\n";
// Bytes of length and checksum of a record.
constexpr std::size_t kFrame = 8;
constexpr std::size_t kMostBytes = std::size_t{1} << 31;  // size of a record

std::uint64_t hash_of(std::string_view text) { return hash_bytes(text.data(), text.size()); }

std::string framed(std::string_view content) {
  ByteWriter writer;
  writer.add(static_cast<std::uint32_t>(content.size()));
  writer.add(checksum_of(content));
  return writer.bytes() + std::string(content);
}

/// The head of a journal, which tells studies apart.
struct Head {
  std::int64_t runs = 0;
  std::string version, instructions;
  std::uint64_t study = 0, scenario = 0, table = 0;  ///< hashes of the texts
};

Head head_of(const Study& study) {
  return {study.design.runs,
          SPOKE_VERSION,
          std::string(instructions_in_use()),
          hash_of(study.text),
          hash_of(study.scenario_text),
          hash_of(study.table_text)};
}

std::string pack(const Head& head) {
  ByteWriter writer;
  writer.add(static_cast<std::uint64_t>(head.runs));
  writer.add_text(head.version);
  writer.add_text(head.instructions);
  for (const std::uint64_t hash : {head.study, head.scenario, head.table}) writer.add(hash);
  return writer.bytes();
}

Head unpack_head(std::string_view bytes) {
  ByteReader reader(bytes);
  Head head;
  head.runs = static_cast<std::int64_t>(reader.take<std::uint64_t>());
  head.version = reader.take_text();
  head.instructions = reader.take_text();
  for (std::uint64_t* hash : {&head.study, &head.scenario, &head.table})
    *hash = reader.take<std::uint64_t>();
  return head;
}

void require_same_study(const Head& there, const Study& study, const std::string& file) {
  const Head here = head_of(study);
  const auto refuse = [&](const std::string& what) {
    throw InputError(file + ": is of another study, expected the same one to resume: " + what);
  };
  if (there.version != here.version)
    refuse("it was begun by version " + there.version + " of Spoke, this is " + here.version);
  if (there.instructions != here.instructions)
    refuse("it was begun with the instructions \"" + there.instructions + "\", here they are \"" +
           here.instructions + "\", which have other bits (see --instructions)");
  if (there.study != here.study) refuse(study.file + " is not what it was");
  if (there.scenario != here.scenario) refuse(study.scenario_file + " is not what it was");
  if (there.table != here.table) refuse(study.design.table + " is not what it was");
}

/// Reads all of the bytes asked for, which the system may read in parts; false at the file's end.
bool read_all(int descriptor, std::uint64_t place, std::size_t count, std::string& bytes) {
  bytes.resize(count);
  for (std::size_t done = 0; done < count;) {
    const ssize_t read =
        pread(descriptor, bytes.data() + done, count - done, static_cast<off_t>(place + done));
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return false;
    done += static_cast<std::size_t>(read);
  }
  return true;
}

/// Returns the content of the record at a place, and moves the place behind it; none if there is no
/// intact record.
std::optional<std::string> take_record(int descriptor, std::uint64_t& place) {
  std::string bytes;
  if (!read_all(descriptor, place, kFrame, bytes)) return {};
  ByteReader frame(bytes);
  const auto length = frame.take<std::uint32_t>();
  const auto checksum = frame.take<std::uint32_t>();
  struct stat status {};
  if (fstat(descriptor, &status) != 0 ||
      place + kFrame + length > static_cast<std::uint64_t>(status.st_size))
    return {};
  if (!read_all(descriptor, place + kFrame, length, bytes) || checksum_of(bytes) != checksum)
    return {};
  place += kFrame + length;
  return bytes;
}

/// A file that is open for reading.
class Reader {
 public:
  explicit Reader(const std::string& file)
      : descriptor_(open(file.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~Reader() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

/// Returns the head of a journal, and moves the place behind it; none if the file does not begin
/// with one.
std::optional<Head> take_head(int descriptor, std::uint64_t& place) {
  std::string magic;
  if (!read_all(descriptor, 0, kMagic.size(), magic) || magic != kMagic) return {};
  place = kMagic.size();
  const std::optional<std::string> head = take_record(descriptor, place);
  if (!head) return {};
  return unpack_head(*head);
}

void pack_numbers(const std::vector<double>& numbers, ByteWriter& writer) {
  writer.add_count(numbers.size());
  for (const double number : numbers) writer.add_number(number);
}

std::vector<double> unpack_numbers(ByteReader& reader) {
  std::vector<double> numbers(reader.take_count(sizeof(double)));
  for (double& number : numbers) number = reader.take_number();
  return numbers;
}

constexpr std::array kNumbersOfStatistics = {
    &SensorStatistics::mean, &SensorStatistics::deviation, &SensorStatistics::min,
    &SensorStatistics::max,  &SensorStatistics::min_time,  &SensorStatistics::max_time};
constexpr std::array kListsOfStatistics = {&SensorStatistics::ranges, &SensorStatistics::at_min,
                                           &SensorStatistics::at_max};

void pack_statistics(const std::vector<SensorStatistics>& all, ByteWriter& writer) {
  writer.add_count(all.size());
  for (const SensorStatistics& one : all) {
    for (const auto number : kNumbersOfStatistics) writer.add_number(one.*number);
    for (const auto list : kListsOfStatistics) pack_numbers(one.*list, writer);
  }
}

std::vector<SensorStatistics> unpack_statistics(ByteReader& reader) {
  constexpr std::size_t kLeast = sizeof(double) * kNumbersOfStatistics.size();
  std::vector<SensorStatistics> all(reader.take_count(kLeast));
  for (SensorStatistics& one : all) {
    for (const auto number : kNumbersOfStatistics) one.*number = reader.take_number();
    for (const auto list : kListsOfStatistics) one.*list = unpack_numbers(reader);
  }
  return all;
}

}  // namespace

std::uint64_t fingerprint(const Study& study) { return hash_of(pack(head_of(study))) | 1U; }

std::string pack(const RunResult& result) {
  ByteWriter writer;
  writer.add(static_cast<std::uint64_t>(result.run));
  writer.add(static_cast<std::uint8_t>(result.status));
  writer.add_text(result.diagnosis);
  writer.add_count(result.responses.size());
  for (const double value : result.responses) writer.add_number(value);
  writer.add_count(result.histories.size());
  for (const History& history : result.histories) {
    writer.add_count(history.times.size());
    for (const double t : history.times) writer.add_number(t);
    for (const double value : history.values) writer.add_number(value);
  }
  pack_statistics(result.statistics, writer);
  return writer.bytes();
}

RunResult unpack(std::string_view bytes, const std::string& name) {
  ByteReader reader(bytes);
  RunResult result;
  result.run = static_cast<std::int64_t>(reader.take<std::uint64_t>());
  result.status = static_cast<RunStatus>(reader.take<std::uint8_t>());
  result.diagnosis = reader.take_text();
  result.responses.resize(reader.take_count(sizeof(double)));
  for (double& value : result.responses) value = reader.take_number();
  result.histories.resize(reader.take_count(sizeof(std::uint64_t)));
  for (History& history : result.histories) {
    history.times.resize(reader.take_count(2 * sizeof(double)));
    history.values.resize(history.times.size());
    for (double& t : history.times) t = reader.take_number();
    for (double& value : history.values) value = reader.take_number();
  }
  result.statistics = unpack_statistics(reader);
  if (!reader.is_done() || result.status > RunStatus::refused)
    throw InputError(name + ": is damaged, expected the result of a run");
  return result;
}

Journal::Journal(const std::string& file, const Study& study, Start start)
    : file_(file), places_(static_cast<std::size_t>(study.design.runs), 0) {
  if (start == Start::resumed) {
    find_records(study);
    return;
  }
  // The head is written as a whole, so that there is no journal without one.
  replace_file(file, std::string(kMagic) + framed(pack(head_of(study))));
  output_ = std::make_unique<OutputFile>(file, OutputFile::Start::existing);
  open_reader();
}

Journal::~Journal() {
  if (reader_ >= 0) close(reader_);
}

void Journal::open_reader() {
  reader_ = open(file_.c_str(), O_RDONLY | O_CLOEXEC);
  if (reader_ < 0)
    throw InputError(file_ + ": cannot be read: " + std::strerror(errno) +
                     ", expected the journal of a study to resume");
}

/// Finds the whole records, and cuts off any bytes behind them.
void Journal::find_records(const Study& study) {
  open_reader();
  std::uint64_t place = 0;
  const std::optional<Head> head = take_head(reader_, place);
  if (!head) throw InputError(file_ + ": is no journal of a study");
  require_same_study(*head, study, file_);
  std::uint64_t begin = place;
  while (const std::optional<std::string> record = take_record(reader_, place)) {
    const std::int64_t run = unpack(*record, file_).run;
    if (run < 0 || run >= std::ssize(places_))
      throw InputError(file_ + ": has run " + std::to_string(run + 1) + ", expected at most " +
                       std::to_string(places_.size()));
    if (!has(run)) ++count_;
    places_[static_cast<std::size_t>(run)] = begin;
    begin = place;
  }
  output_ = std::make_unique<OutputFile>(file_, OutputFile::Start::existing);
  output_->cut(begin);
}

void Journal::append(const RunResult& result) {
  const std::string content = pack(result);
  if (content.size() > kMostBytes)
    throw InputError(file_ + ": run " + std::to_string(result.run + 1) +
                     " has histories or statistics of more than 2 GB, expected fewer values");
  const std::uint64_t place = output_->size();
  output_->append(framed(content));
  places_[static_cast<std::size_t>(result.run)] = place;
  ++count_;
}

RunResult Journal::read(std::int64_t run) const {
  std::uint64_t place = places_[static_cast<std::size_t>(run)];
  const std::optional<std::string> record = take_record(reader_, place);
  if (!record)
    throw InputError(file_ + ": cannot be read as it was written, at run " +
                     std::to_string(run + 1));
  return unpack(*record, file_);
}

std::optional<JournalState> find_journal(const std::string& file) {
  const Reader reader(file);
  std::uint64_t place = 0;
  if (reader.descriptor() < 0) return {};
  const std::optional<Head> head = take_head(reader.descriptor(), place);
  if (!head) return {};
  JournalState state{0, head->runs, head->instructions};
  while (take_record(reader.descriptor(), place)) ++state.runs;
  return state;
}

}  // namespace spoke::study
