#include "tests/program/fmu/unpacked_fmu.h"

#include <unistd.h>
#include <zip.h>

#include <fstream>
#include <stdexcept>

#include "program/fmu/make_fmu.h"

namespace spoke::test {

namespace fs = std::filesystem;

Simulation simulate(const std::string& text, const Overrides& overrides) {
  return Simulation(parse_scenario(text, "rotor.toml", overrides));
}

UnpackedFmu::UnpackedFmu(const std::string& scenario, const std::vector<std::string>& inputs,
                         const std::vector<std::string>& outputs, const Overrides& overrides,
                         fmu::FmiVersion version) {
  static int count = 0;
  folder_ = fs::temp_directory_path() /
            ("spoke_fmu_" + std::to_string(getpid()) + '_' + std::to_string(++count));
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  const fs::path file = folder_ / "rotor.toml";
  std::ofstream(file) << scenario;
  SimulationOptions serial;
  serial.executor = ExecutorKind::serial;
  const Simulation simulation(read_scenario(file.string(), overrides), serial);
  unpack(fmu::make_fmu(
             {file.string(), overrides, "rotor", SPOKE_FMU_LIBRARY_FILE, inputs, outputs, version},
             simulation)
             .bytes,
         folder_);
  fs::remove(file);  // the FMU has one of its own
}

UnpackedFmu::~UnpackedFmu() { fs::remove_all(folder_); }

void unpack(const std::string& archive, const fs::path& folder) {
  zip_error_t error;
  zip_source_t* source = zip_source_buffer_create(archive.data(), archive.size(), 0, &error);
  zip_t* opened =
      source ? zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error) : nullptr;
  if (!opened) throw std::runtime_error("no archive");
  for (zip_int64_t k = 0; k < zip_get_num_entries(opened, 0); ++k) {
    const auto index = static_cast<zip_uint64_t>(k);
    zip_stat_t stat;
    zip_stat_index(opened, index, 0, &stat);
    zip_file_t* entry = zip_fopen_index(opened, index, 0);
    std::string content(stat.size, '\0');
    if (!entry ||
        zip_fread(entry, content.data(), content.size()) != static_cast<zip_int64_t>(stat.size))
      throw std::runtime_error("no entry");
    zip_fclose(entry);
    fs::create_directories((folder / stat.name).parent_path());
    std::ofstream(folder / stat.name, std::ios::binary) << content;
  }
  zip_close(opened);
}

}  // namespace spoke::test
