#include "models/text_file.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "models/scenario.h"
#include "models/solid/import_text.h"
#include "models/solid/solid.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;
namespace fs = std::filesystem;

namespace {

const std::string kMark = "\xEF\xBB\xBF";

/// A file with a text, for as long as this lives.
class TextFile {
 public:
  TextFile(const std::string& name, const std::string& text)
      : path_(fs::temp_directory_path() / ("spoke_marked_" + name)) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TextFile() { fs::remove(path_); }
  std::string name() const { return path_.string(); }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("a byte-order mark at the beginning of a text is no part of it") {
  CHECK(without_byte_order_mark(kMark + "a" + kMark) == "a" + kMark);
  CHECK(without_byte_order_mark("\xEF\xBB") == "\xEF\xBB");
  CHECK(read_text(TextFile("a.txt", kMark + "a = 1\n").name()) == "a = 1\n");
  const TextFile none("none.toml", kMark);
  CHECK(message_of([&] { read_text(none.name()); }) ==
        none.name() + ": is empty, expected a scenario file (TOML)");
  for (const std::string start : {"\xFF\xFE", "\xFE\xFF"}) {
    const TextFile wide("wide.toml", start + std::string("a\0", 2));
    CHECK(message_of([&] { read_text(wide.name()); }) ==
          wide.name() + ": is text in UTF-16, not in UTF-8, expected a scenario file (TOML)");
  }
}

TEST_CASE("meshes, scenarios and tables of nodes may begin with a byte-order mark") {
  const TextFile inp("m.inp", kMark +
                                  "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n"
                                  "*ELEMENT, TYPE=C3D4\n1,1,2,3,4\n");
  CHECK(solid::read_mesh(inp.name(), 1.0, nullptr)->nodes.size() == 4);
  const TextFile msh("m.msh", kMark +
                                  "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n"
                                  "2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n1\n"
                                  "1 4 0 1 2 3 4\n$EndElements\n");
  CHECK(solid::read_mesh(msh.name(), 1.0, nullptr)->nodes.size() == 4);
  const fs::path shipped = fs::path(SPOKE_MODELS_DIR) / "wu_haug_rotor.toml";
  const TextFile scenario("rotor.toml", kMark + read_text(shipped));
  CHECK(read_scenario(scenario.name()).title == read_scenario(shipped.string()).title);
  const TextFile nodes("nodes.txt", kMark + "1.5 2 3\n");
  solid::NumberText table(nodes.name(), "nodes");
  REQUIRE(table.next());
  CHECK(table.real(0) == 1.5);
}
