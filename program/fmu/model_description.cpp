// Writes elements and attributes in the order of the standard's schema.

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

std::string write_variable(const Variable& variable, unsigned reference, const char* causality) {
  std::string text = "    <Float64" + attribute("name", variable.name) +
                     fmt::format(" valueReference=\"{}\"", reference);
  if (!variable.description.empty()) text += attribute("description", variable.description);
  text += fmt::format(" causality=\"{}\" variability=\"continuous\"", causality);
  if (!variable.unit.empty()) text += attribute("unit", variable.unit);
  return text;
}

std::string write_variables(const ModelDescription& model) {
  std::string text = "  <ModelVariables>\n";
  text +=
      write_variable({"time", "s", "Simulation time", 0.0}, kTimeReference, "independent") + "/>\n";
  unsigned reference = kFirstReference;
  for (const Variable& input : model.inputs)
    text += write_variable(input, reference++, "input") + attribute("start", input.start) + "/>\n";
  for (const Variable& output : model.outputs)
    text += write_variable(output, reference++, "output") + " initial=\"calculated\"/>\n";
  return text + "  </ModelVariables>\n";
}

std::string write_structure(const ModelDescription& model) {
  std::string text = "  <ModelStructure>\n";
  const auto first = kFirstReference + static_cast<unsigned>(model.inputs.size());
  for (const char* element : {"Output", "InitialUnknown"})
    for (unsigned k = 0; k < model.outputs.size(); ++k)
      text += fmt::format("    <{} valueReference=\"{}\"/>\n", element, first + k);
  return text + "  </ModelStructure>\n";
}

std::string write_co_simulation(const ModelDescription& model) {
  return "  <CoSimulation" + attribute("modelIdentifier", model.identifier) +
         " canBeInstantiatedOnlyOncePerProcess=\"false\" canGetAndSetFMUState=\"true\""
         " canSerializeFMUState=\"true\" canHandleVariableCommunicationStepSize=\"true\"" +
         attribute("fixedInternalStepSize", model.step) +
         " canReturnEarlyAfterIntermediateUpdate=\"false\" hasEventMode=\"false\""
         " providesEvaluateDiscreteStates=\"false\"/>\n";
}

}  // namespace

std::string write_model_description(const ModelDescription& model) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<fmiModelDescription fmiVersion=\"3.0\"" +
      attribute("modelName", model.name) + attribute("instantiationToken", model.token);
  if (!model.description.empty()) text += attribute("description", model.description);
  text += " generationTool=\"Spoke " SPOKE_VERSION "\" variableNamingConvention=\"flat\">\n";
  text += write_co_simulation(model);
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
  return text + write_variables(model) + write_structure(model) + "</fmiModelDescription>\n";
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
