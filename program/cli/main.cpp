// The program "spoke": command line in, exit status out.

#include "program/cli/commands.h"

int main(int argc, char** argv) {
  return spoke::cli::run_program(spoke::cli::make_commands(), argc, argv);
}
