// The program "spoke-whole", which `spoke` starts for commands and scenarios that need the whole
// engine.

#include "program/cli/commands.h"

namespace spoke::cli {

void require_enough(const Scenario&) {}
void require_enough(const Arguments&) {}

}  // namespace spoke::cli

int main(int argc, char** argv) {
  return spoke::cli::run_program(spoke::cli::make_commands(), argc, argv);
}
