// libFuzzer: any bytes are a mesh of gmsh or Abaqus, or refused by InputError with one line.

#include <optional>
#include <string>
#include <string_view>

#include "models/error.h"
#include "models/solid/mesh_check.h"
#include "models/solid/parse_mesh.h"
#include "models/solid/surface.h"
#include "tests/fuzz/require.h"

using namespace spoke;
using test::require;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    std::optional<spatial::SolidMaterial> material;
    const auto mesh = solid::parse_mesh(text, "fuzz.msh", 1.0, &material);
    solid::check_mesh(*mesh);
    require(!solid::find_surface(*mesh).empty(), "a body has a surface");
  } catch (const InputError& error) {
    const std::string message = error.what();
    require(!message.empty() && message.find('\n') == std::string::npos, "a message is one line");
  }
  return 0;
}
