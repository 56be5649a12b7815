// An importer that has nothing of Spoke: loads the FMU in a folder, makes steps, prints the outputs
// as hexadecimal numbers, and then the libraries that its process has loaded.
//   alone FOLDER TOKEN LIBRARY OUTPUTS FIRST STEP COUNT

#include <dlfcn.h>
#include <link.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

void* library = nullptr;

template <class Function>
Function* find(const char* name) {
  void* found = dlsym(library, name);
  if (!found) std::exit(3);
  return reinterpret_cast<Function*>(found);
}

void print(void*, int status, const char* category, const char* text) {
  std::printf("message %d %s %s\n", status, category, text);
}

int print_library(dl_phdr_info* info, std::size_t, void*) {
  std::printf("library %s\n", info->dlpi_name);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 8) return 2;
  library = dlopen(argv[3], RTLD_NOW);
  if (!library) {
    std::printf("%s\n", dlerror());
    return 1;
  }
  using Make =
      void*(const char*, const char*, const char*, bool, bool, bool, bool, const std::uint32_t*,
            std::size_t, void*, void (*)(void*, int, const char*, const char*), void*);
  void* instance = find<Make>("fmi3InstantiateCoSimulation")(
      "alone", argv[2], argv[1], false, true, false, false, nullptr, 0, nullptr, print, nullptr);
  if (!instance) return 1;
  using Enter = int(void*, bool, double, double, bool, double);
  find<Enter>("fmi3EnterInitializationMode")(instance, false, 0.0, 0.0, true, 1.0);
  find<int(void*)>("fmi3ExitInitializationMode")(instance);
  const auto outputs = static_cast<std::size_t>(std::atoi(argv[4]));
  std::vector<std::uint32_t> references;
  for (std::size_t k = 0; k < outputs; ++k)
    references.push_back(static_cast<std::uint32_t>(std::atoi(argv[5])) +
                         static_cast<std::uint32_t>(k));
  std::vector<double> values(outputs);
  const double step = std::atof(argv[6]);
  for (int k = 0; k < std::atoi(argv[7]); ++k) {
    bool event = false, ends = false, early = false;
    double reached = 0.0;
    using Step = int(void*, double, double, bool, bool*, bool*, bool*, double*);
    if (find<Step>("fmi3DoStep")(instance, k * step, step, true, &event, &ends, &early, &reached) !=
        0)
      return 1;
  }
  using Get = int(void*, const std::uint32_t*, std::size_t, double*, std::size_t);
  find<Get>("fmi3GetFloat64")(instance, references.data(), outputs, values.data(), outputs);
  for (const double value : values) std::printf("value %a\n", value);
  dl_iterate_phdr(print_library, nullptr);
  find<void(void*)>("fmi3FreeInstance")(instance);
  return dlclose(library);
}
