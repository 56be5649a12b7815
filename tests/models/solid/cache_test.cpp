// The cache of constants: what is read is what was written, and a file that is not is made anew.

#include "models/solid/cache.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "models/solid/cache_bytes.h"
#include "spoke/error.h"
#include "tests/file_text.h"
#include "tests/models/solid/matrix_files.h"
#include "tests/models/solid/solids.h"
#include "tests/temporary_folder.h"

namespace spoke {
namespace {

using space::SolidConstants;
using test::TemporaryFolder;

/// Sets a variable of the environment, and puts it back.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (before_)
      setenv(name_, before_->c_str(), 1);
    else
      unsetenv(name_);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

spatial::SolidBody make_body(spatial::SolidCoordinates coordinates) {
  spatial::SolidBody body;
  body.mesh = std::make_shared<spatial::SolidMesh>(
      test::make_bar({3, 1, 1}, {1.0, 0.1, 0.1}, spatial::ElementKind::tet10));
  body.material = test::aluminium();
  body.coordinates = coordinates;
  body.interfaces = {{"root", "X0"}, {"tip", "X1", spatial::InterfaceKind::average}};
  body.modes = 6;
  if (coordinates == spatial::SolidCoordinates::reduced) body.damping = {0.01};
  return body;
}

/// All values of constants as bytes, those that are not in the cache too.
std::string bytes_of(const SolidConstants& c) {
  solid::ByteWriter write;
  write(c.mass), write(c.S0), write(c.J0), write(c.coordinates), write(c.extent), write(c.frame);
  write(c.is_stiffened), write(c.places), write(c.nodes), write(c.frequencies);
  const solid::Sparse stress = c.stress;
  write(stress);
  if (const space::ReducedSolid* r = c.reduced()) {
    write(r->stiffness), write(r->damping), write(r->C_t), write(r->h), write(r->m), write(r->own);
    write(r->translation), write(r->places), write(r->shapes);
  } else {
    const space::NodalSolid& n = *c.nodal();
    write(n.m), write(n.K), write(n.Xi), write(n.own), write(n.translation), write(n.places);
  }
  return write.bytes();
}

constexpr auto kReduced = spatial::SolidCoordinates::reduced;
constexpr auto kNodal = spatial::SolidCoordinates::nodal;

TEST_CASE("solid cache: constants that are read are those that were made, bit by bit") {
  const TemporaryFolder folder;
  const Variable cache("SPOKE_CACHE", (folder / "cache").string());
  for (const auto coordinates : {kReduced, kNodal}) {
    const spatial::SolidBody body = make_body(coordinates);
    const solid::LoadedSets sets{"Y0"};
    solid::CacheUse first, second, third{.reads = false};
    const auto made = solid::make_constants(body, sets, {}, &first);
    CHECK_FALSE(first.was_read);
    CHECK(std::filesystem::exists(first.file));
    const auto read = solid::make_constants(body, sets, {}, &second);
    CHECK(second.was_read);
    CHECK(second.file == first.file);
    CHECK(bytes_of(*read) == bytes_of(*made));
    CHECK(read->mesh == body.mesh);
    const auto again = solid::make_constants(body, sets, {}, &third);
    CHECK_FALSE(third.was_read);
    CHECK(bytes_of(*again) == bytes_of(*made));
    const Variable none("SPOKE_CACHE", "none");
    solid::CacheUse fourth;
    CHECK(bytes_of(*solid::make_constants(body, sets, {}, &fourth)) == bytes_of(*made));
    CHECK(fourth.file.empty());
  }
}

TEST_CASE("solid cache: a damaged, cut or foreign file is made anew") {
  const TemporaryFolder folder;
  const Variable cache("SPOKE_CACHE", folder.path().string());
  const spatial::SolidBody body = make_body(kReduced);
  solid::CacheUse use;
  const std::string expected = bytes_of(*solid::make_constants(body, {}, {}, &use));
  const std::string file = test::file_text(use.file);
  REQUIRE(file.size() > 1000);
  const std::uint64_t key = [&] {
    std::uint64_t value;
    std::memcpy(&value, file.data() + 16, sizeof value);
    return value;
  }();
  REQUIRE(solid::read_constants(use.file, key));
  // Each byte of the header, and some of everything behind it.
  for (std::size_t at = 0; at < file.size(); at += at < 60 ? 1 : 2999) {
    std::string damaged = file;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    test::write_text(use.file, damaged);
    CHECK_FALSE(solid::read_constants(use.file, key));
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{39}, std::size_t{40},
                                 file.size() / 2, file.size() - 1}) {
    test::write_text(use.file, file.substr(0, size));
    CHECK_FALSE(solid::read_constants(use.file, key));
  }
  test::write_text(use.file, file + "x");
  CHECK_FALSE(solid::read_constants(use.file, key));
  test::write_text(use.file, "[simulation]\n");
  CHECK_FALSE(solid::read_constants(use.file, key));
  solid::CacheUse anew;
  CHECK(bytes_of(*solid::make_constants(body, {}, {}, &anew)) == expected);
  CHECK_FALSE(anew.was_read);
  CHECK(test::file_text(anew.file) == file);
}

TEST_CASE("solid cache: bytes that fit the checksum but make no sense are refused") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "solid.bin";
  const spatial::SolidBody body = make_body(kNodal);
  const Variable cache("SPOKE_CACHE", "none");
  const auto made = solid::make_constants(body, {});
  REQUIRE(solid::write_constants(path, 1, *made));
  const std::string file = test::file_text(path);
  constexpr std::size_t kHeader = 40;
  // Whatever is in the payload, reading ends, without memory that is not its own.
  for (std::size_t at = kHeader; at < file.size(); at += at < 1000 ? 7 : 19997) {
    std::string damaged = file;
    damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
    const std::uint64_t hash = hash_bytes(damaged.data() + kHeader, damaged.size() - kHeader);
    std::memcpy(damaged.data() + 32, &hash, sizeof hash);
    test::write_text(path, damaged);
    solid::read_constants(path, 1);
  }
}

TEST_CASE("solid cache: another mesh, material, interface or number of modes has another file") {
  const TemporaryFolder folder;
  const Variable cache("SPOKE_CACHE", folder.path().string());
  std::vector<std::string> files;
  const auto make = [&](const spatial::SolidBody& body, const solid::LoadedSets& sets) {
    solid::CacheUse use;
    solid::make_constants(body, sets, {}, &use);
    const bool is_new = std::find(files.begin(), files.end(), use.file) == files.end();
    CHECK(use.was_read == !is_new);
    files.push_back(use.file);
    return is_new;
  };
  spatial::SolidBody body = make_body(kReduced);
  CHECK(make(body, {}));
  body.damping = {0.05};  // is not in it
  CHECK_FALSE(make(body, {}));
  CHECK(make(body, {"Z1"}));
  body.modes = 7;
  CHECK(make(body, {}));
  body.interfaces[1].kind = spatial::InterfaceKind::rigid;
  CHECK(make(body, {}));
  body.interfaces[1].point = spatial::Vector(1.0, 0.0, 0.0);
  CHECK(make(body, {}));
  body.material->density = 2701.0;
  CHECK(make(body, {}));
  body.geometric_stiffening = false;
  CHECK(make(body, {}));
  auto mesh = std::make_shared<spatial::SolidMesh>(*body.mesh);
  mesh->nodes[30] += spatial::Vector(1e-9, 0.0, 0.0);
  body.mesh = mesh;
  CHECK(make(body, {}));
  body.frame = spatial::SolidFrame::mean_axis;
  CHECK(make(body, {}));
  body.modes.reset();
  body.up_to = 2000.0;
  CHECK(make(body, {}));
}

TEST_CASE("solid cache: its folder, and none where none can be made") {
  const TemporaryFolder folder;
  const Variable cache("SPOKE_CACHE", "");
  const Variable home("HOME", folder.path().string());
  const Variable xdg("XDG_CACHE_HOME", (folder / "xdg").string());
  CHECK(solid::find_cache_folder() == folder.path() / "xdg" / "spoke");
  const Variable no_xdg("XDG_CACHE_HOME", "");
  CHECK(solid::find_cache_folder() == folder.path() / ".cache" / "spoke");
  test::write_text(folder / "file", "x");
  const Variable below_file("SPOKE_CACHE", (folder / "file").string() + "/cache");
  CHECK_FALSE(solid::find_cache_folder());
  const Variable none("SPOKE_CACHE", "none");
  CHECK_FALSE(solid::find_cache_folder());
  solid::CacheUse use;
  solid::make_constants(make_body(kReduced), {}, {}, &use);
  CHECK(use.file.empty());
}

TEST_CASE("solid constants: progress goes on to 1, mean axes are of reduced coordinates only") {
  const Variable none("SPOKE_CACHE", "none");
  spatial::SolidBody body = make_body(kReduced);
  double before = 0.0;
  std::vector<std::string> steps;
  const auto hear = [&](const std::string& step, double done) {
    if (steps.empty() || steps.back() != step) steps.push_back(step);
    CHECK(done >= before);
    before = done;
  };
  solid::make_constants(body, {}, {.progress = hear});
  CHECK(before == 1.0);
  CHECK(steps == std::vector<std::string>{"assemble", "factorise", "modes", "stiffening"});
  body = make_body(kNodal);
  body.frame = spatial::SolidFrame::mean_axis;
  CHECK_THROWS_WITH_AS(solid::make_constants(body, {}), doctest::Contains("nodal"), InputError);
}

}  // namespace
}  // namespace spoke
