// Keywords of Abaqus and CalculiX, by what they mean for a body. Within steps only loads and
// conditions are told; procedures and output say nothing of the body.

#include "models/solid/inp_keywords.h"

#include <algorithm>
#include <array>

namespace spoke::solid {
namespace {

constexpr const char* kTies = "interfaces tie nodes, as kind = \"rigid\" or \"average\"";
constexpr const char* kStructures = "elements of volumes only";
constexpr const char* kJoints = "springs, dampers and joints belong to the scenario";
constexpr const char* kMasses = "*MASS at nodes of the body, or a rigid body on an interface";
constexpr const char* kContact = "bodies that share their nodes, or stops of joints";
constexpr const char* kMatrices = "format and files of matrices in the scenario";

struct NotBuilt {
  std::string_view key;
  const char* instead;
};
constexpr std::array kNotBuilt{
    NotBuilt{"EQUATION", kTies},
    NotBuilt{"MPC", kTies},
    NotBuilt{"NETWORKMPC", kTies},
    NotBuilt{"TIE", kTies},
    NotBuilt{"RIGIDBODY", kTies},
    NotBuilt{"COUPLING", kTies},
    NotBuilt{"KINEMATIC", kTies},
    NotBuilt{"DISTRIBUTING", kTies},
    NotBuilt{"KINEMATICCOUPLING", kTies},
    NotBuilt{"DISTRIBUTINGCOUPLING", kTies},
    NotBuilt{"SHELLTOSOLIDCOUPLING", kTies},
    NotBuilt{"EMBEDDEDELEMENT", kTies},
    NotBuilt{"CYCLICSYMMETRYMODEL", kTies},
    NotBuilt{"FASTENER", kTies},
    NotBuilt{"FASTENERPROPERTY", kTies},
    NotBuilt{"RELEASE", kTies},
    NotBuilt{"PRE-TENSIONSECTION", kTies},
    NotBuilt{"PRETENSIONSECTION", kTies},
    NotBuilt{"CONTACT", kContact},
    NotBuilt{"CONTACTPAIR", kContact},
    NotBuilt{"SPRING", kJoints},
    NotBuilt{"DASHPOT", kJoints},
    NotBuilt{"JOINT", kJoints},
    NotBuilt{"GAP", kJoints},
    NotBuilt{"CONNECTORSECTION", kJoints},
    NotBuilt{"SHELLSECTION", kStructures},
    NotBuilt{"SHELLGENERALSECTION", kStructures},
    NotBuilt{"MEMBRANESECTION", kStructures},
    NotBuilt{"BEAMSECTION", kStructures},
    NotBuilt{"BEAMGENERALSECTION", kStructures},
    NotBuilt{"FRAMESECTION", kStructures},
    NotBuilt{"COHESIVESECTION", kStructures},
    NotBuilt{"GASKETSECTION", kStructures},
    NotBuilt{"FLUIDSECTION", kStructures},
    NotBuilt{"FLUIDSECTIONS", kStructures},
    NotBuilt{"EULERIANSECTION", kStructures},
    NotBuilt{"USERSECTION", kStructures},
    NotBuilt{"USERELEMENT", kStructures},
    NotBuilt{"UELPROPERTY", kStructures},
    NotBuilt{"REBAR", kStructures},
    NotBuilt{"REBARLAYER", kStructures},
    NotBuilt{"IMPERFECTION", "nodes at their places"},
    NotBuilt{"ROTARYINERTIA", kMasses},
    NotBuilt{"NONSTRUCTURALMASS", kMasses},
    NotBuilt{"MASSADJUST", kMasses},
    NotBuilt{"HEATCAP", kStructures},
    NotBuilt{"MATRIXINPUT", kMatrices},
    NotBuilt{"MATRIXASSEMBLE", kMatrices},
    NotBuilt{"SUBSTRUCTUREPROPERTY", kMatrices},
};

constexpr std::array<std::string_view, 24> kLeftOut{"BOUNDARY",
                                                    "CLOAD",
                                                    "DLOAD",
                                                    "DSLOAD",
                                                    "INITIALCONDITIONS",
                                                    "TEMPERATURE",
                                                    "BASEMOTION",
                                                    "SUBMODEL",
                                                    "MODELCHANGE",
                                                    "DAMPING",
                                                    "GLOBALDAMPING",
                                                    "MODALDAMPING",
                                                    "PLASTIC",
                                                    "CREEP",
                                                    "CYCLICHARDENING",
                                                    "RATEDEPENDENT",
                                                    "DEFORMATIONPLASTICITY",
                                                    "VISCOELASTIC",
                                                    "HYPERELASTIC",
                                                    "HYPERFOAM",
                                                    "USERMATERIAL",
                                                    "DRUCKERPRAGER",
                                                    "MOHRCOULOMB",
                                                    "INITIALSTRAININCREASE"};

constexpr std::array<std::string_view, 58> kHarmless{"HEADING",
                                                     "PREPRINT",
                                                     "PART",
                                                     "ENDPART",
                                                     "ASSEMBLY",
                                                     "ENDASSEMBLY",
                                                     "INSTANCE",
                                                     "ENDINSTANCE",
                                                     "STEP",
                                                     "ENDSTEP",
                                                     "AMPLITUDE",
                                                     "RESTART",
                                                     "NODEFILE",
                                                     "NODEPRINT",
                                                     "NODEOUTPUT",
                                                     "ELFILE",
                                                     "ELPRINT",
                                                     "ELEMENTOUTPUT",
                                                     "CONTACTOUTPUT",
                                                     "ENERGYOUTPUT",
                                                     "OUTPUT",
                                                     "FILEOUTPUT",
                                                     "CONTACTFILE",
                                                     "CONTACTPRINT",
                                                     "SECTIONPRINT",
                                                     "FILEFORMAT",
                                                     "TIMEPOINTS",
                                                     "FILTER",
                                                     "MONITOR",
                                                     "NOANALYSIS",
                                                     "PHYSICALCONSTANTS",
                                                     "CONDUCTIVITY",
                                                     "SPECIFICHEAT",
                                                     "LATENTHEAT",
                                                     "EXPANSION",
                                                     "ELECTRICALCONDUCTIVITY",
                                                     "MAGNETICPERMEABILITY",
                                                     "FLUIDCONSTANTS",
                                                     "SPECIFICGASCONSTANT",
                                                     "DEPVAR",
                                                     "ORIENTATION",
                                                     "TRANSFORM",
                                                     "DISTRIBUTION",
                                                     "DISTRIBUTIONTABLE",
                                                     "SECTIONCONTROLS",
                                                     "HOURGLASSSTIFFNESS",
                                                     "SURFACEINTERACTION",
                                                     "SURFACEBEHAVIOR",
                                                     "SURFACESECTION",
                                                     "FRICTION",
                                                     "CONTACTDAMPING",
                                                     "GAPCONDUCTANCE",
                                                     "GAPHEATGENERATION",
                                                     "FILMPROPERTY",
                                                     "DESIGNVARIABLES",
                                                     "DESIGNRESPONSE",
                                                     "NODALTHICKNESS",
                                                     "USERDEFINEDFIELD"};

}  // namespace

InpKeywordMeaning find_inp_meaning(std::string_view key, bool is_in_step) {
  const auto not_built = std::find_if(kNotBuilt.begin(), kNotBuilt.end(),
                                      [key](const NotBuilt& entry) { return entry.key == key; });
  if (not_built != kNotBuilt.end()) return {InpMeaning::not_built, not_built->instead};
  const auto is_in = [key](const auto& keys) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  const bool is_left_out = is_in(kLeftOut) || (!is_in_step && !is_in(kHarmless));
  return {is_left_out ? InpMeaning::left_out : InpMeaning::harmless, ""};
}

}  // namespace spoke::solid
