// Makes a load of a function.

#include "engine/load.h"

#include <utility>

namespace spoke {
namespace {

class FunctionLoad final : public Load {
 public:
  FunctionLoad(std::string name, std::vector<Marker> markers, LoadFunction function)
      : name_(std::move(name)), markers_(std::move(markers)), function_(std::move(function)) {}

  std::string name() const override { return name_; }
  std::vector<Marker> markers() const override { return markers_; }
  void evaluate(double t, std::span<const MarkerMotion> in, std::span<Wrench> out) const override {
    function_(t, in, out);
  }

 private:
  std::string name_;
  std::vector<Marker> markers_;
  LoadFunction function_;
};

}  // namespace

std::shared_ptr<const Load> make_load(std::string name, std::vector<Marker> markers,
                                      LoadFunction function) {
  return std::make_shared<const FunctionLoad>(std::move(name), std::move(markers),
                                              std::move(function));
}

}  // namespace spoke
