// The published values of both, of the same text.

#include "engine/support/hash.h"

#include <doctest/doctest.h>

using namespace spoke;

TEST_CASE("a hash is FNV-1a, and goes on behind other bytes") {
  CHECK(hash_bytes("", 0) == 0xcbf29ce484222325u);
  CHECK(hash_bytes("foobar", 6) == 0x85944171f73967e8u);
  CHECK(hash_bytes("bar", 3, hash_bytes("foo", 3)) == 0x85944171f73967e8u);
}

TEST_CASE("a checksum is CRC-32, and goes on behind other bytes") {
  CHECK(checksum_of("") == 0u);
  CHECK(checksum_of("123456789") == 0xcbf43926u);
  CHECK(checksum_of("789", checksum_of("123456")) == 0xcbf43926u);
}
