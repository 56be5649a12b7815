// Writes elements and attributes in the order of the standard's schemas.

#include "program/fmu/model_description.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>

#include "program/fmu/contents.h"
#include "program/fmu/unit.h"
#include "program/report/markup.h"

namespace spoke::fmu {
namespace {

/// Numbers in the fewest digits that read back equal.
std::string attribute(const char* name, double value) {
  return fmt::format(" {}=\"{}\"", name, value);
}
std::string attribute(const char* name, const std::string& text) {
  return fmt::format(" {}=\"{}\"", name, report::escape(text));
}

/// Returns the units of all variables, each once, in the order in which they come.
std::vector<std::string> units_of(const ModelDescription& model) {
  std::vector<std::string> units{"s"};
  for (const auto* variables : {&model.inputs, &model.outputs})
    for (const Variable& variable : *variables)
      if (!variable.unit.empty() &&
          std::find(units.begin(), units.end(), variable.unit) == units.end())
        units.push_back(variable.unit);
  return units;
}

std::string write_unit(const std::string& name) {
  std::string text = "    <Unit" + attribute("name", name);
  const std::optional<Unit> unit = parse_unit(name);
  if (!unit) return text + "/>\n";
  text += "><BaseUnit";
  for (std::size_t k = 0; k < kBaseUnits.size(); ++k)
    if (unit->exponents[k] != 0)
      text += fmt::format(" {}=\"{}\"", kBaseUnits[k], unit->exponents[k]);
  return text + "/></Unit>\n";
}

// What differs between the versions.

/// FMI 3.0: a variable is an element of its type.
class Version3 {
 public:
  static std::string attributes(const ModelDescription& model) {
    return " fmiVersion=\"3.0\"" + attribute("modelName", model.name) +
           attribute("instantiationToken", model.token);
  }
  static std::string capabilities(const ModelDescription& model) {
    return " canBeInstantiatedOnlyOncePerProcess=\"false\" canGetAndSetFMUState=\"true\""
           " canSerializeFMUState=\"true\" canHandleVariableCommunicationStepSize=\"true\"" +
           attribute("fixedInternalStepSize", model.step) +
           " canReturnEarlyAfterIntermediateUpdate=\"false\" hasEventMode=\"false\""
           " providesEvaluateDiscreteStates=\"false\"";
  }
  static std::string variable(const std::string& common, const std::string& own,
                              const std::string& number) {
    return "    <Float64" + common + own + number + "/>\n";
  }
  static std::string structure(const ModelDescription& model) {
    std::string text;
    const auto first = kFirstReference + static_cast<unsigned>(model.inputs.size());
    for (const char* element : {"Output", "InitialUnknown"})
      for (unsigned k = 0; k < model.outputs.size(); ++k)
        text += fmt::format("    <{} valueReference=\"{}\"/>\n", element, first + k);
    return text;
  }
};

/// FMI 2.0: a variable is a ScalarVariable with its type inside, and has a number from 1 on.
class Version2 {
 public:
  static std::string attributes(const ModelDescription& model) {
    return " fmiVersion=\"2.0\"" + attribute("modelName", model.name) +
           attribute("guid", model.token);
  }
  static std::string capabilities(const ModelDescription&) {
    return " canHandleVariableCommunicationStepSize=\"true\" canInterpolateInputs=\"false\""
           " maxOutputDerivativeOrder=\"0\" canRunAsynchronuously=\"false\""
           " canBeInstantiatedOnlyOncePerProcess=\"false\""
           " canNotUseMemoryManagementFunctions=\"true\" canGetAndSetFMUstate=\"true\""
           " canSerializeFMUstate=\"true\" providesDirectionalDerivative=\"false\"";
  }
  static std::string variable(const std::string& common, const std::string& own,
                              const std::string& number) {
    return "    <ScalarVariable" + common + own + "><Real" + number + "/></ScalarVariable>\n";
  }
  static std::string structure(const ModelDescription& model) {
    std::string text;
    const std::size_t first = 2 + model.inputs.size();  // behind the time
    for (const char* element : {"Outputs", "InitialUnknowns"}) {
      if (model.outputs.empty()) break;
      text += fmt::format("    <{}>\n", element);
      for (std::size_t k = 0; k < model.outputs.size(); ++k)
        text += fmt::format("      <Unknown index=\"{}\"/>\n", first + k);
      text += fmt::format("    </{}>\n", element);
    }
    return text;
  }
};

std::string write_common(const Variable& variable, unsigned reference) {
  std::string text =
      attribute("name", variable.name) + fmt::format(" valueReference=\"{}\"", reference);
  if (!variable.description.empty()) text += attribute("description", variable.description);
  return text;
}

std::string write_number(const Variable& variable) {
  return variable.unit.empty() ? "" : attribute("unit", variable.unit);
}

template <class Version>
std::string write_variables(const ModelDescription& model) {
  const auto kind = [](const char* causality, const char* rest = "") {
    return fmt::format(" causality=\"{}\" variability=\"continuous\"{}", causality, rest);
  };
  const Variable time{"time", "s", "Simulation time", 0.0};
  std::string text =
      "  <ModelVariables>\n" + Version::variable(write_common(time, kTimeReference),
                                                 kind("independent"), write_number(time));
  unsigned reference = kFirstReference;
  for (const Variable& input : model.inputs)
    text += Version::variable(write_common(input, reference++), kind("input"),
                              write_number(input) + attribute("start", input.start));
  for (const Variable& output : model.outputs)
    text += Version::variable(write_common(output, reference++),
                              kind("output", " initial=\"calculated\""), write_number(output));
  return text + "  </ModelVariables>\n";
}

template <class Version>
std::string write(const ModelDescription& model) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription" +
                     Version::attributes(model);
  if (!model.description.empty()) text += attribute("description", model.description);
  text += " generationTool=\"Spoke " SPOKE_VERSION "\" variableNamingConvention=\"flat\">\n";
  text += "  <CoSimulation" + attribute("modelIdentifier", model.identifier) +
          Version::capabilities(model) + "/>\n";
  text += "  <UnitDefinitions>\n";
  for (const std::string& unit : units_of(model)) text += write_unit(unit);
  text +=
      "  </UnitDefinitions>\n"
      "  <LogCategories>\n"
      "    <Category name=\"logStatusWarning\" description=\"Doubtful results\"/>\n"
      "    <Category name=\"logStatusError\" description=\"Errors\"/>\n"
      "  </LogCategories>\n"
      "  <DefaultExperiment startTime=\"0\"" +
      attribute("stopTime", model.duration) + attribute("stepSize", model.interval) + "/>\n";
  return text + write_variables<Version>(model) + "  <ModelStructure>\n" +
         Version::structure(model) + "  </ModelStructure>\n</fmiModelDescription>\n";
}

}  // namespace

std::string write_model_description(const ModelDescription& model, FmiVersion version) {
  return version == FmiVersion::two ? write<Version2>(model) : write<Version3>(model);
}

std::string make_identifier(const std::string& name) {
  std::string identifier;
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    const bool is_digit = c >= '0' && c <= '9';
    if (is_digit && identifier.empty()) identifier = "_";
    identifier += is_letter || is_digit ? c : '_';
  }
  return identifier;
}

}  // namespace spoke::fmu
