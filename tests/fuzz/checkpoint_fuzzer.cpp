// libFuzzer: any bytes are a checkpoint, which is written to bytes that read as the same, or
// refused by InputError with one line. As random bytes have no valid checksum, they are also read
// with length and checksum put right.

#include <zlib.h>

#include <string>

#include "engine/checkpoint.h"
#include "engine/support/byte_order.h"
#include "models/error.h"
#include "tests/fuzz/require.h"

using namespace spoke;
using test::require;

namespace {

constexpr std::size_t kMagicAndFormat = 8 + 4;
constexpr std::size_t kHeader = kMagicAndFormat + 8;
constexpr std::size_t kChecksum = 4;

std::string with_valid_frame(const std::string& bytes) {
  ByteWriter length;
  length.add_count(bytes.size() - kHeader - kChecksum);
  const std::string framed = bytes.substr(0, kMagicAndFormat) + length.bytes() +
                             bytes.substr(kHeader, bytes.size() - kHeader - kChecksum);
  ByteWriter checksum;
  checksum.add(static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(framed.data()), framed.size())));
  return framed + checksum.bytes();
}

void read(const std::string& bytes) {
  try {
    const Checkpoint checkpoint = parse_checkpoint(bytes, "fuzz");
    const std::string written = make_checkpoint(checkpoint.state, checkpoint.record);
    const Checkpoint again = parse_checkpoint(written, "fuzz");
    require(make_checkpoint(again.state, again.record) == written, "what is read is written");
  } catch (const InputError& error) {
    const std::string message = error.what();
    require(message.starts_with("fuzz: ") && message.find('\n') == std::string::npos,
            "a message is one line");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read(bytes);
  if (size >= kHeader + kChecksum) read(with_valid_frame(bytes));
  return 0;
}
