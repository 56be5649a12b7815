// A build without libyaml-cpp reads no YAML.

#include "program/foreign/input_lines.h"
#include "program/foreign/windio_reader.h"

namespace spoke::foreign {

void read_windio(const SourceFile& source, FoundModel& /*model*/) {
  refuse(source.name, 0,
         "is YAML, which this build does not read; expected a build with libyaml-cpp "
         "(Debian: libyaml-cpp-dev)");
}

}  // namespace spoke::foreign
