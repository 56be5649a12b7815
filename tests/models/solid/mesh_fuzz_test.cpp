// Whatever the bytes of a mesh file, they are a mesh or refused in one line.

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include "models/error.h"
#include "models/solid/mesh_check.h"
#include "models/solid/parse_mesh.h"
#include "tests/models/solid/grid_mesh.h"
#include "tests/models/solid/mesh_texts.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Reads and checks a text; returns whether it is a mesh.
bool is_mesh(const std::string& text) {
  try {
    solid::check_mesh(*solid::parse_mesh(text, "f", 1.0));
    return true;
  } catch (const InputError& error) {
    const std::string message = error.what();
    REQUIRE(message.starts_with("f"));
    REQUIRE(message.find('\n') == std::string::npos);
    REQUIRE(message.find("expected") != std::string::npos);
    return false;
  }
}

std::vector<std::string> make_texts() {
  spatial::SolidMesh tets = make_grid_mesh({.kind = spatial::ElementKind::tet10});
  const spatial::SolidMesh hexes =
      make_grid_mesh({.cells = {2, 1, 1}, .kind = spatial::ElementKind::hex20});
  number_with_gaps(tets);
  std::vector<std::string> texts;
  for (const spatial::SolidMesh* mesh : {&std::as_const(tets), &hexes}) {
    for (const MshForm form : {MshForm::text, MshForm::binary, MshForm::swapped_binary}) {
      texts.push_back(write_msh22(*mesh, form));
      texts.push_back(write_msh41(*mesh, form));
    }
    texts.push_back(write_inp(*mesh));
  }
  return texts;
}

}  // namespace

TEST_CASE("mesh files cut short anywhere are refused") {
  for (const std::string& text : make_texts()) {
    CHECK(is_mesh(text));
    for (std::size_t length = 0; length < text.size(); length += 7) is_mesh(text.substr(0, length));
  }
}

TEST_CASE("mesh files with bytes or lines changed at random are meshes or refused") {
  std::mt19937 random(39);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::vector<std::string> words{"-1",
                                       "0",
                                       "1e999",
                                       "nan",
                                       "999999999999",
                                       "2147483647",
                                       ",",
                                       "\n",
                                       "*",
                                       "$",
                                       "*NODE\n",
                                       "$Nodes\n",
                                       "\"",
                                       "1000000000",
                                       "inf",
                                       ", GENERATE\n1, 2000000000, 1\n"};
  for (const std::string& text : make_texts())
    for (int run = 0; run < 400; ++run) {
      std::string changed = text;
      for (std::size_t k = 1 + below(4); k > 0; --k) {
        const std::size_t at = below(changed.size());
        switch (below(4)) {
          case 0:
            changed[at] = static_cast<char>(below(256));
            break;
          case 1:
            changed.insert(at, words[below(words.size())]);
            break;
          case 2:
            changed.erase(at, 1 + below(30));
            break;
          default:
            changed.insert(at, changed.substr(below(changed.size()), 1 + below(200)));
        }
      }
      is_mesh(changed);
    }
}

TEST_CASE("rubbish is no mesh") {
  std::mt19937 random(7);
  for (int run = 0; run < 500; ++run) {
    std::string text = run % 3 == 0 ? "$MeshFormat\n4.1 1 8\n\1" : run % 3 == 1 ? "*NODE\n" : "";
    for (int k = 0; k < 300; ++k) text += static_cast<char>(random() % 256);
    CHECK_FALSE(is_mesh(text));
  }
}
