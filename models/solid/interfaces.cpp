// Interfaces of a solid: their nodes, and moments about the first.

#include "models/solid/interfaces.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "models/error.h"
#include "models/solid/choose_nodes.h"
#include "models/solid/mesh_check.h"

namespace spoke::solid {
namespace {

using spatial::SolidBody;
using spatial::SolidInterface;
using spatial::Vector;

/// Refuses rigid interfaces that share nodes with others.
void check_shared(const SolidBody& body, const SolidGeometry& geometry) {
  std::vector<int> owner(geometry.mesh->nodes.size(), -1);
  // Rigid ones first: an average one may share its nodes with average ones only.
  for (const auto kind : {spatial::InterfaceKind::rigid, spatial::InterfaceKind::average})
    for (std::size_t k = 0; k < body.interfaces.size(); ++k) {
      if (body.interfaces[k].kind != kind) continue;
      for (const int node : geometry.interfaces[k].nodes) {
        int& other = owner[static_cast<std::size_t>(node)];
        if (other >= 0)
          refuse_field(
              "interface." +
                  std::to_string(std::max<std::size_t>(k, static_cast<std::size_t>(other)) + 1) +
                  ".nodes",
              "shares " + name_of_node(*geometry.mesh, node) + " with interface \"" +
                  body.interfaces[std::min<std::size_t>(k, static_cast<std::size_t>(other))].name +
                  "\", expected nodes of its own (or both interfaces of kind \"average\")");
        if (kind == spatial::InterfaceKind::rigid) other = static_cast<int>(k);
      }
    }
}

}  // namespace

void refuse_field(const std::string& key, const std::string& what) {
  throw InputError(what, {.key = key});
}

std::string show_number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void check_length_scale(double length_scale) {
  if (!(length_scale > 0.0) || !std::isfinite(length_scale))
    refuse_field("scale.length", "is " + show_number(length_scale) +
                                     ", expected metres by the file's unit of length");
}

void find_interfaces(const SolidBody& body, SolidGeometry& geometry) {
  if (body.interfaces.empty()) refuse_field("interface", "is missing, expected at least one");
  NodeChooser chooser(*geometry.mesh);
  for (std::size_t k = 0; k < body.interfaces.size(); ++k) {
    const SolidInterface& interface = body.interfaces[k];
    const std::string key = "interface." + std::to_string(k + 1);
    if (interface.point && !interface.point->allFinite())
      refuse_field(key + ".point", "is not finite, expected a place [m]");
    for (std::size_t other = 0; other < k; ++other)
      if (body.interfaces[other].name == interface.name)
        refuse_field(key + ".name", "is \"" + interface.name + "\", as of interface " +
                                        std::to_string(other + 1) + ", expected another name");
    try {
      geometry.interfaces.push_back(chooser.choose_interface(interface));
    } catch (const InputError& error) {
      refuse_field(key + ".nodes", error.what());
    }
  }
  check_shared(body, geometry);
}

void move_moments_to_first(SolidGeometry& geometry, const Vector& about) {
  const Vector S = geometry.first_moment, p = geometry.interfaces.front().point - about;
  geometry.first_moment = S - geometry.mass * p;
  geometry.second_moment +=
      -S * p.transpose() - p * S.transpose() + geometry.mass * p * p.transpose();
}

}  // namespace spoke::solid
