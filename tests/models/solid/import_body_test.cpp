// A solid of matrices is that of the mesh which they come from.

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

#include "models/solid/kept_geometry.h"
#include "models/solid/solid.h"
#include "spoke/error.h"
#include "tests/models/solid/matrix_files.h"
#include "tests/temporary_folder.h"

using namespace spoke;

namespace {

/// Sets the folder of the cache, and puts back at the end what was there.
class CacheFolder {
 public:
  explicit CacheFolder(const std::string& folder) {
    if (const char* set = std::getenv("SPOKE_CACHE")) before_ = set;
    setenv("SPOKE_CACHE", folder.c_str(), 1);
  }
  ~CacheFolder() { before_ ? setenv("SPOKE_CACHE", before_->c_str(), 1) : unsetenv("SPOKE_CACHE"); }
  CacheFolder(const CacheFolder&) = delete;
  CacheFolder& operator=(const CacheFolder&) = delete;

 private:
  std::optional<std::string> before_;
};

}  // namespace

TEST_CASE("imported matrices: constants are those of the mesh") {
  const test::TemporaryFolder folder;
  const CacheFolder cache((folder / "cache").string());
  const test::AssembledMatrices box =
      test::assemble({.cells = {4, 1, 1}, .lengths = {0.8, 0.1, 0.06}});
  spatial::SolidBody meshed;
  meshed.mesh = std::make_shared<spatial::SolidMesh>(box.mesh);
  meshed.material = {.youngs_modulus = 7e10, .poissons_ratio = 0.33, .density = 2700.0};
  meshed.modes = 6;
  meshed.geometric_stiffening = false;
  meshed.interfaces = {{.name = "root", .nodes = "X0"}, {.name = "tip", .nodes = "X1"}};
  spatial::SolidBody imported = meshed;
  imported.mesh = nullptr;
  imported.material.reset();
  imported.matrices = test::write_calculix(folder.path(), box);
  imported.matrices->nodes = (folder / "bar.inp").string();
  test::write_text(folder / "bar.inp", test::inp_text(box.mesh, ""));
  for (spatial::SolidBody* body : {&meshed, &imported})
    for (spatial::SolidInterface& interface : body->interfaces)
      interface.point = spatial::Vector(interface.name == "root" ? 0.0 : 0.8, 0.05, 0.03);

  const auto expected = solid::make_constants(meshed, {});
  for (int k = 0; k < 2; ++k) {  // the second time from the cache
    const auto constants = solid::make_constants(imported, {});
    CHECK(!constants->mesh);
    CHECK(constants->stress.size() == 0);
    CHECK(constants->mass == doctest::Approx(expected->mass).epsilon(1e-12));
    CHECK((constants->S0 - expected->S0).norm() < 1e-12);
    CHECK((constants->J0 - expected->J0).norm() < 1e-12);
    REQUIRE(constants->frequencies.size() == 6);
    for (std::size_t mode = 0; mode < 6; ++mode)
      CHECK(constants->frequencies[mode] ==
            doctest::Approx(expected->frequencies[mode]).epsilon(1e-9));
    const Eigen::VectorXd &W2 = constants->reduced()->stiffness,
                          &expected_W2 = expected->reduced()->stiffness;
    REQUIRE(W2.size() == 12);
    for (int mode = 0; mode < 12; ++mode)
      CHECK(W2[mode] == doctest::Approx(expected_W2[mode]).epsilon(1e-9));
  }
}

TEST_CASE(
    "imported matrices: too little memory is told at their stiffness, of a mesh at the mesh") {
  const test::TemporaryFolder folder;
  const test::AssembledMatrices box =
      test::assemble({.cells = {2, 1, 1}, .lengths = {0.4, 0.1, 0.06}});
  spatial::SolidBody body;
  body.geometric_stiffening = false;
  body.interfaces = {{.name = "root", .nodes = spatial::BoxNodes{{0, 0, 0}, {0, 1, 1}}}};
  const auto find_key = [](const spatial::SolidBody& of) -> std::string {
    try {
      find_constants(*solid::find_geometry(of), {}, "subsystem.1.body.2", {.memory = 1.0});
    } catch (const InputError& error) {
      CHECK(std::string(error.what()).starts_with(error.place().key + ": needs 0.0"));
      return error.place().key;
    }
    return "";
  };
  body.mesh = std::make_shared<spatial::SolidMesh>(box.mesh);
  body.material = {.youngs_modulus = 7e10, .poissons_ratio = 0.33, .density = 2700.0};
  CHECK(find_key(body) == "subsystem.1.body.2.mesh");
  body.mesh = nullptr;
  body.material.reset();
  body.matrices = test::write_calculix(folder.path(), box);
  CHECK(find_key(body) == "subsystem.1.body.2.stiffness");
}
