#include "models/solid/cache.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <system_error>
#include <thread>

#include "models/solid/cache_bytes.h"

namespace spoke::solid {
namespace {

namespace fs = std::filesystem;
using space::SolidConstants;

/// Raised whenever the files or the values in them change.
constexpr std::int64_t kCacheFormat = 3;
constexpr char kMagic[8] = {'s', 'p', 'o', 'k', 'e', 'f', 'e', '\n'};

/// What a file begins with. Numbers are those of the machine: another byte order is another format.
struct CacheHeader {
  char magic[8];
  std::int64_t format;
  std::uint64_t key;
  std::uint64_t size;  ///< bytes that follow
  std::uint64_t hash;  ///< of these
};

/// Visits all members but damping, mesh, nodes and stress.
template <class Visitor, class Solid>
void visit_reduced(Visitor& visit, Solid& solid) {
  visit(solid.stiffness);
  visit(solid.C_t);
  visit(solid.h);
  visit(solid.m);
  visit(solid.own);
  visit(solid.translation);
  visit(solid.places);
  visit(solid.shapes);
}

template <class Visitor, class Solid>
void visit_nodal(Visitor& visit, Solid& solid) {
  visit(solid.m);
  visit(solid.K);
  visit(solid.Xi);
  visit(solid.slices);
  visit(solid.own);
  visit(solid.translation);
  visit(solid.places);
}

template <class Visitor, class Constants>
void visit_common(Visitor& visit, Constants& constants) {
  visit(constants.mass);
  visit(constants.S0);
  visit(constants.J0);
  visit(constants.coordinates);
  visit(constants.extent);
  visit(constants.frame);
  visit(constants.is_stiffened);
  visit(constants.places);
  visit(constants.frequencies);
}

std::string pack(const SolidConstants& constants) {
  ByteWriter writer;
  visit_common(writer, constants);
  writer(constants.reduced() != nullptr);
  if (const space::ReducedSolid* solid = constants.reduced())
    visit_reduced(writer, *solid);
  else
    visit_nodal(writer, *constants.nodal());
  return writer.bytes();
}

std::optional<SolidConstants> unpack(std::string_view bytes) {
  ByteReader reader(bytes);
  SolidConstants constants;
  visit_common(reader, constants);
  bool is_reduced = false;
  reader(is_reduced);
  if (is_reduced) {
    visit_reduced(reader, constants.matrices.emplace<space::ReducedSolid>());
  } else {
    visit_nodal(reader, constants.matrices.emplace<space::NodalSolid>());
  }
  if (!reader.is_at_end()) return std::nullopt;
  return constants;
}

std::string text_of(const char* variable) {
  const char* value = std::getenv(variable);
  return value ? value : "";
}

}  // namespace

CacheKey::CacheKey() : value_(hash_bytes(kMagic, sizeof kMagic)) {
  add(kCacheFormat);
  add(std::string_view(SPOKE_VERSION));
  add(std::string_view(__VERSION__));
#ifdef __AVX2__
  add(std::string_view("avx2"));
#endif
#ifdef __AVX512F__
  add(std::string_view("avx512"));
#endif
#ifdef __FMA__
  add(std::string_view("fma"));
#endif
#ifdef NDEBUG
  add(std::string_view("release"));
#endif
}

void CacheKey::add(std::string_view text) {
  add(static_cast<std::int64_t>(text.size()));
  add(text.data(), text.size());
}

void CacheKey::add(const std::vector<int>& values) {
  add(static_cast<std::int64_t>(values.size()));
  add(values.data(), sizeof(int) * values.size());
}

void CacheKey::add(const std::vector<double>& values) {
  add(static_cast<std::int64_t>(values.size()));
  add(values.data(), sizeof(double) * values.size());
}

void CacheKey::add(const Sparse& matrix) {
  ByteWriter writer;
  writer(matrix);
  add(std::string_view(writer.bytes()));
}

std::optional<fs::path> find_cache_folder() {
  fs::path folder = text_of("SPOKE_CACHE");
  if (folder == "none") return std::nullopt;
  if (folder.empty()) {
    const fs::path base = text_of("XDG_CACHE_HOME"), home = text_of("HOME");
    if (base.is_absolute())
      folder = base / "spoke";
    else if (home.is_absolute())
      folder = home / ".cache" / "spoke";
    else
      return std::nullopt;
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error)) return std::nullopt;
  return folder;
}

fs::path cache_file(const fs::path& folder, std::uint64_t key) {
  char name[40];
  std::snprintf(name, sizeof name, "solid-%016llx.bin", static_cast<unsigned long long>(key));
  return folder / name;
}

std::optional<SolidConstants> read_constants(const fs::path& file, std::uint64_t key) {
  std::ifstream stream(file, std::ios::binary);
  CacheHeader header;
  if (!stream.read(reinterpret_cast<char*>(&header), sizeof header)) return std::nullopt;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || std::memcmp(header.magic, kMagic, sizeof kMagic) != 0 ||
      header.format != kCacheFormat || header.key != key || header.size != size - sizeof header)
    return std::nullopt;
  std::string bytes(header.size, '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return std::nullopt;
  if (hash_bytes(bytes.data(), bytes.size()) != header.hash) return std::nullopt;
  return unpack(bytes);
}

bool write_constants(const fs::path& file, std::uint64_t key, const SolidConstants& constants) {
  const std::string bytes = pack(constants);
  CacheHeader header{{}, kCacheFormat, key, bytes.size(), hash_bytes(bytes.data(), bytes.size())};
  std::memcpy(header.magic, kMagic, sizeof kMagic);
  // Several programs, and threads of one, may make the same solid at once: each its own file.
  const std::size_t thread = std::hash<std::thread::id>()(std::this_thread::get_id());
  const fs::path temporary =
      file.string() + '.' + std::to_string(getpid()) + '.' + std::to_string(thread) + ".tmp";
  std::error_code error;
  {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(&header), sizeof header);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (stream) fs::rename(temporary, file, error);
    if (stream && !error) return true;
  }
  fs::remove(temporary, error);
  return false;
}

}  // namespace spoke::solid
