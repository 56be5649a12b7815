// Puts the tables of levels together.

#include "tests/engine/bodies/space/system/levels.h"

namespace spoke::test {
namespace {

const std::string kStage =
    "body=[ { name='stage', kind='rigid', mass=9, center=[0.02,0.01,0.1], inertia=[0.4,0.5,0.6] }";
}  // namespace

const std::string kBoom =
    "{ name='boom', kind='beam', length=1, bodies=1, elements=2, strain='nonlinear',"
    " sections={ mass_per_length=1.5, axial_stiffness=2e4, lag_stiffness=300, flap_stiffness=200,"
    " torsion_stiffness=150 } }";
std::string make_hub_of(const std::string& name, const std::string& drive,
                        const std::string& axle) {
  return "[[rotor]]\nname='" + name +
         "'\nhub={ mass=0.5, center=[0.02,0,0], inertia=0.3, drive={ " + drive + " } }\naxle={ " +
         axle + " }\n";
}

const std::string kOnBush = "[support]\n" + kStage;
const std::string kFlying =
    "[support]\nfrom='free'\nmass=30\ninertia=[2,3,4]\nangular_velocity=[0.1,-0.2,0.3]\n" + kStage;

const std::string kLevelsWeight = "[gravity]\nacceleration=[0.3,0.2,-9.81]\n";

namespace {

std::string bush(const std::string& base) {
  return "{ name='bush', parent='" + base +
         "', child='stage', kind='bushing', offset=[0,0,0.3],"
         " stiffness=[4e3,5e3,6e3,2e3,2e3,3e3] }";
}

std::string rigid(const std::string& name, double mass) {
  const std::string size = std::to_string(0.02 * mass);
  return "{ name='" + name + "', kind='rigid', mass=" + std::to_string(mass) +
         ", center=[0.15,0.02,0.01], inertia=[" + size + ',' + size + ',' + size + "] }";
}

/// A hinge; what is on the hub of a rotor hangs at 0.2 m from its axis.
std::string hinge(const std::string& parent, const std::string& child, const std::string& more) {
  return "{ name='" + child + "', parent='" + parent + "', child='" + child +
         "', offset=[0.2,0,0.05], " + more + " }";
}

/// The loads act on the innermost level, a sensor looks at it.
std::string finish(const std::string& weight, const std::string& subsystem) {
  return "[[load]]\nsubsystem='" + subsystem +
         "'\nbody='leaf'\nforce=[0,0.4,0.3]\nframe='inertial'\npoint=[0.1,0,0]\n" +
         "[[hub_load]]\nrotor='top'\nforce=[0,0.3,0]\nposition=[0.1,0,0]\n" + weight +
         "[[sensor]]\nname='watched'\nquantity='velocity'\nframe='inertial'\nsubsystem='" +
         subsystem + "'\nbody='leaf'\n[integration]\nstep=1e-3\nduration=1\n";
}

}  // namespace

std::string replace(std::string text, const std::string& old, const std::string& made) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at))
    text.replace(at, old.size(), made);
  return text;
}

namespace {

const std::string kOnStage = "body='stage', offset=[0,0.1,0.4], orientation=[0.2,0.1,0]";
const std::string kOnBoom = "body='boom', station=0.7, offset=[0,0,0.1], orientation=[0,0.4,0]";
const std::string kOnTwig = "body='twig', offset=[0.3,0,0], orientation=[0.5,0,0]";

std::string speed_of_leaf(const LevelsCase& of) {
  return of.is_at_rest ? "" : ", initial_speed=1.2";
}

}  // namespace

std::string make_levels(const LevelsCase& of, const std::string& base, const std::string& weight) {
  const auto name_ends = [](const std::string& text) {
    return replace(replace(text, "TO(", "subsystem='"), ")", "', ");
  };
  const std::string loops = name_ends(of.loops), couplings = name_ends(of.couplings);
  return "world='space'\n" + of.support + " ]\njoint=[ " + bush(base) + " ]\n" +
         make_hub_of("main", of.is_at_rest ? "kind='fixed'" : "kind='free', initial_speed=4",
                     kOnStage) +
         make_hub_of("middle",
                     "kind='" + of.drive + "'" + (of.drive == "free" ? ", initial_speed=-6" : ""),
                     "subsystem='boom', " + kOnBoom) +
         make_hub_of("top", "kind='fixed'", "subsystem='twig', " + kOnTwig) +
         "[[subsystem]]\nname='arm'\nrotor='main'\nbody=[ " + rigid("arm", 2) + " ]\njoint=[ " +
         hinge("hub", "arm",
               "orientation=[0,0,2.5], kind='universal', axes=[[0,1,0],[0,0,1]], "
               "initial=[0.02,0.01]" +
                   of.arm) +
         " ]\n[[subsystem]]\nname='boom'\nrotor='main'\nbody=[ " + kBoom + " ]\njoint=[ " +
         hinge("hub", "boom", "kind='fixed'") +
         " ]\n[[subsystem]]\nname='twig'\nrotor='middle'\nbody=[ " + rigid("twig", 1) +
         " ]\njoint=[ " + hinge("hub", "twig", "kind='revolute', axis=[0,1,0]" + of.damping) +
         " ]\n[[subsystem]]\nname='leaf'\nrotor='top'\nbody=[ " + rigid("leaf", 0.4) +
         " ]\njoint=[ " +
         hinge("hub", "leaf",
               "kind='revolute', axis=[0,0,1], initial=0.1" + speed_of_leaf(of) + of.damping) +
         " ]\n" + (loops.empty() ? "" : "loop=[ " + loops + " ]\n") +
         (couplings.empty() ? "" : "coupling=[ " + couplings + " ]\n") + finish(weight, "leaf");
}

std::string make_one_level(const LevelsCase& of, const std::string& base,
                           const std::string& weight) {
  std::string loops = of.loops, couplings = replace(of.couplings, ".axle", "axle");
  for (const char* name : {"boom", "arm", "twig", "support"})
    for (std::string* text : {&loops, &couplings})
      *text = replace(*text, "TO(" + std::string(name) + ")", "");
  const auto hub_body = [](const std::string& name) {
    return "{ name='" + name + "hub', kind='rigid', mass=0.5, center=[0.02,0,0], inertia=0.3 }";
  };
  const auto axle = [](const std::string& name, const std::string& kind, const std::string& place) {
    return "{ name='" + name + "axle', child='" + name + "hub', " + kind + ", " +
           replace(place, "body=", "parent=") + " }";
  };
  const std::string revolute = "kind='revolute', axis=[0,0,1], ";
  // The hub load of "top" turns with it.
  return "world='space'\n" + of.support + ", " + hub_body("main") + ", " + rigid("arm", 2) + ", " +
         kBoom + ", " + hub_body("middle") + ", " + rigid("twig", 1) + ", " + hub_body("top") +
         ", " + rigid("leaf", 0.4) + " ]\njoint=[ " + bush(base) + ", " +
         axle("main", of.is_at_rest ? "kind='fixed'" : revolute + "initial_speed=4", kOnStage) +
         ", " +
         hinge("mainhub", "arm",
               "orientation=[0,0,2.5], kind='universal', axes=[[0,1,0],[0,0,1]], "
               "initial=[0.02,0.01]" +
                   of.arm) +
         ", " + hinge("mainhub", "boom", "kind='fixed'") + ", " +
         axle("middle", of.drive == "free" ? revolute + "initial_speed=-6" : "kind='fixed'",
              kOnBoom) +
         ", " + hinge("middlehub", "twig", "kind='revolute', axis=[0,1,0]" + of.damping) + ", " +
         axle("top", "kind='fixed'", kOnTwig) + ", " +
         hinge("tophub", "leaf",
               "kind='revolute', axis=[0,0,1], initial=0.1" + speed_of_leaf(of) + of.damping) +
         " ]\n" + (loops.empty() ? "" : "loop=[ " + loops + " ]\n") +
         (couplings.empty() ? "" : "coupling=[ " + couplings + " ]\n") +
         replace(
             finish(weight, "support"), "[[hub_load]]\nrotor='top'\nforce=[0,0.3,0]\nposition",
             "[[load]]\nsubsystem='support'\nbody='tophub'\nframe='body'\nforce=[0,0.3,0]\npoint");
}

std::string with_dummy(const std::string& text) {
  const std::size_t at = text.find("[[load]]");
  return text.substr(0, at) +
         "[[rotor]]\nname='none'\nhub={ mass=1e-9, inertia=1e-9, drive={ kind='fixed' } }\n"
         "axle={ body='stage' }\n" +
         text.substr(at);
}

}  // namespace spoke::test
