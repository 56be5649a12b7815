// The code of toml++, which Spoke elsewhere takes from a shared library.

#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
