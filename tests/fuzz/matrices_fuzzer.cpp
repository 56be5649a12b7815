// libFuzzer: whatever stands in the files of matrices of other programs, they are read or refused
// by InputError with one line. The first line of an input names the format; lines "#file NAME"
// begin the files.

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "models/solid/import.h"
#include "spoke/error.h"
#include "tests/fuzz/require.h"

using namespace spoke;
using test::require;

namespace {

const std::filesystem::path& folder() {
  static const std::filesystem::path path = [] {
    auto made = std::filesystem::temp_directory_path() / ("spoke_fuzz_" + std::to_string(getpid()));
    std::filesystem::create_directories(made);
    return made;
  }();
  return path;
}

/// Writes a file with what stands behind "#file NAME" up to the next such line.
std::string write_part(const std::string& text, const std::string& name) {
  const std::string head = "#file " + name + '\n';
  const std::size_t at = text.find(head);
  const std::size_t begin = at == std::string::npos ? text.size() : at + head.size();
  const std::size_t end = text.find("#file ", begin);
  const std::filesystem::path file = folder() / name;
  std::ofstream(file, std::ios::binary) << text.substr(begin, end - begin);
  return file.string();
}

/// Requires everything that the reduction relies on.
void check(const solid::ImportedMatrices& matrices) {
  const auto n = static_cast<Eigen::Index>(matrices.nodes.size());
  require(n >= 3 && matrices.labels.size() == matrices.nodes.size(), "there are nodes");
  require(matrices.mesh->nodes.size() == matrices.nodes.size(), "the table has the nodes");
  require(matrices.m.rows() == n && matrices.K.rows() == 3 * n, "sizes fit");
  require(std::isfinite(matrices.m.sum()) && matrices.m.sum() > 0.0, "there is mass");
  require(std::isfinite(matrices.K.norm()), "stiffness is finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  spatial::SolidMatrices files;
  files.format = text.substr(0, text.find('\n'));
  files.stiffness = write_part(text, "body.sti");
  files.mass = write_part(text, "body.mas");
  write_part(text, "body.dof");
  files.nodes = write_part(
      text, text.find("#file nodes.inp\n") == std::string::npos ? "nodes.txt" : "nodes.inp");
  try {
    check(solid::read_matrices(files, 1.0));
  } catch (const InputError& error) {
    const std::string message = error.what();
    require(!message.empty() && message.find('\n') == std::string::npos, "a message is one line");
  }
  return 0;
}
