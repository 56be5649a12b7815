// The program "spoke": command line in, exit status out. It makes runs, and starts the programs of
// other commands.

#include "program/cli/commands.h"

int main(int argc, char** argv) {
  return spoke::cli::run_program(spoke::cli::list_commands({spoke::cli::make_run()}), argc, argv);
}
