#pragma once

// modelDescription.xml of an FMU.

#include <string>
#include <vector>

namespace spoke::fmu {

/// The versions of the standard of which there are FMUs; the values are theirs.
enum class FmiVersion { two = 2, three = 3 };

/// A variable of a model description, a number.
struct Variable {
  std::string name;
  std::string unit;         ///< as Spoke writes it; empty: none
  std::string description;  ///< may be empty
  double start = 0.0;       ///< of an input
};

/// What a model description says.
struct ModelDescription {
  std::string name;         ///< of the model
  std::string identifier;   ///< name of the shared object without its ending, a name of C
  std::string token;        ///< instantiationToken, in 2.0 guid
  std::string description;  ///< may be empty
  double step = 0.0;        ///< of the integration [s]
  double duration = 0.0;    ///< of the scenario [s]
  double interval = 0.0;    ///< communication step that is suggested, a multiple of `step` [s]
  std::vector<Variable> inputs, outputs;
};

/// Returns the file. Value references are those of contents.h.
std::string write_model_description(const ModelDescription& model, FmiVersion version);

/// Returns the name as an identifier of C: other letters become "_", and a leading digit gets one.
std::string make_identifier(const std::string& name);

}  // namespace spoke::fmu
