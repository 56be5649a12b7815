// Makes the archive in memory, so that it is written as a whole or not at all.

#include "program/fmu/archive.h"

#include <zip.h>

#include <cstddef>
#include <ctime>
#include <memory>

#include "models/error.h"

namespace spoke::fmu {
namespace {

[[noreturn]] void fail(const std::string& why) {
  throw InputError("the archive of the FMU cannot be made: " + why);
}

/// Memory to which libzip writes an archive.
class Memory {
 public:
  Memory() : source_(zip_source_buffer_create(nullptr, 0, 0, nullptr)) {
    if (!source_) fail("no memory");
  }
  ~Memory() { zip_source_free(source_); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  zip_source_t* source() const { return source_; }
  std::string bytes() const {
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_source_stat(source_, &stat) < 0 || (stat.valid & ZIP_STAT_SIZE) == 0)
      fail("its size is not known");
    std::string bytes(stat.size, '\0');
    if (zip_source_open(source_) < 0) fail("it cannot be read");
    const zip_int64_t count = zip_source_read(source_, bytes.data(), bytes.size());
    zip_source_close(source_);
    if (count < 0 || static_cast<std::size_t>(count) != bytes.size()) fail("it cannot be read");
    return bytes;
  }

 private:
  zip_source_t* source_;
};

void add(const PackedFile& file, zip_t* archive) {
  zip_source_t* content = zip_source_buffer(archive, file.content.data(), file.content.size(), 0);
  if (!content) fail(zip_strerror(archive));
  const zip_int64_t index = zip_file_add(archive, file.name.c_str(), content, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(content);
    fail(file.name + ": " + zip_strerror(archive));
  }
  std::tm day{};
  day.tm_year = 80;
  day.tm_mday = 1;
  day.tm_isdst = -1;
  const auto entry = static_cast<zip_uint64_t>(index);
  // A fifth of the time of libzip's own choice, 9, for 3 % more bytes.
  constexpr zip_uint32_t kEffort = 4;
  zip_set_file_compression(archive, entry, ZIP_CM_DEFLATE, kEffort);
  zip_file_set_mtime(archive, entry, std::mktime(&day), 0);
  // Read by all, written by their owner; importers load the shared object by its path.
  constexpr zip_uint32_t kRegularFile = 0100644;
  zip_file_set_external_attributes(archive, entry, 0, ZIP_OPSYS_UNIX, kRegularFile << 16);
}

}  // namespace

std::string make_archive(const std::vector<PackedFile>& files) {
  const Memory memory;
  zip_error_t error;
  zip_error_init(&error);
  zip_t* opened = zip_open_from_source(memory.source(), ZIP_CREATE | ZIP_TRUNCATE, &error);
  if (!opened) fail(zip_error_strerror(&error));
  zip_source_keep(memory.source());  // closing frees it once
  std::unique_ptr<zip_t, void (*)(zip_t*)> archive(opened, zip_discard);
  for (const PackedFile& file : files) add(file, opened);
  if (zip_close(opened) < 0) fail(zip_strerror(opened));
  static_cast<void>(archive.release());  // closed
  return memory.bytes();
}

}  // namespace spoke::fmu
