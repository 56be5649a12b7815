// Switches of modules, names of their files, and the environment.

#include "program/foreign/openfast_main.h"

#include "models/support/quantity.h"

namespace spoke::foreign {
namespace {

/// Reads a switch, 0 if it is missing.
int read_main_switch(KeyedLines& reader, const char* key, int most) {
  return reader.has(key) ? reader.count(key, 0, most) : 0;
}

/// Refuses a model of a module that no scenario has.
[[noreturn]] void refuse_switch(KeyedLines& reader, const char* key, int value,
                                const char* expected) {
  reader.lines().refuse(std::string(key) + " is " + std::to_string(value) + ", expected " +
                        expected);
}

/// Reads the name of a module's file, which must be there.
NamedFile take_file(KeyedLines& reader, const char* key, const char* other) {
  if (!reader.has(key) && !reader.has(other)) reader.seek(key);  // refuses
  return reader.file(key, other);
}

void read_structure(KeyedLines& reader, OpenFastMain& main, FoundModel& model) {
  const int elastic = reader.count("CompElast", 1, 3);
  if (elastic == 3)
    refuse_switch(reader, "CompElast", elastic,
                  "1, ElastoDyn, or 2, with BeamDyn for the blades; a rigid turbine is not read");
  main.elastodyn = take_file(reader, "EDFile", "EDFile");
  if (elastic == 1) return;
  main.beamdyn = take_file(reader, "BDBldFile(1)", "BDBldFile1");
  for (const char* other : {"BDBldFile(2)", "BDBldFile(3)"})
    if (reader.has(other) && reader.text(other) != main.beamdyn.name)
      model.leave_out(Loss::value, std::string(other) + ", " + reader.lines().place() +
                                       ", which is another file than that of blade 1: all blades "
                                       "have that of blade 1");
}

void read_air_files(KeyedLines& reader, OpenFastMain& main, FoundModel& model) {
  // Up to version 3 AeroDyn 14 was 1, which is AeroDisk since.
  const int aero = reader.count("CompAero", 0, 3);
  if (aero == 1 || aero == 3)
    refuse_switch(reader, "CompAero", aero, "0, none, or 2, AeroDyn of version 15 or later");
  if (aero == 0) return;
  main.aerodyn = take_file(reader, "AeroFile", "AeroFile");
  const int inflow = reader.count("CompInflow", 0, 2);
  if (inflow == 2)
    model.leave_out(Loss::part, "CompInflow, " + reader.lines().place() +
                                    ", which is 2: wind of another program; the air is at rest");
  if (inflow == 1) main.inflowwind = take_file(reader, "InflowFile", "InflowFile");
}

/// What carries the tower in other modules.
void note_foundation(KeyedLines& reader, FoundModel& model) {
  constexpr std::pair<const char*, const char*> kModules[] = {{"CompSub", "the substructure"},
                                                              {"CompMooring", "moorings"},
                                                              {"CompHydro", "water and its loads"},
                                                              {"CompSeaSt", "waves and current"},
                                                              {"CompIce", "ice"},
                                                              {"CompSoil", "soil"}};
  constexpr int most = 100;
  for (const auto& [key, what] : kModules)
    if (const int value = read_main_switch(reader, key, most); value != 0)
      model.leave_out(Loss::part, std::string(key) + ", " + reader.lines().place() + ", which is " +
                                      std::to_string(value) + ": " + what +
                                      "; the foot of the tower is held");
}

void read_environment(KeyedLines& reader, OpenFastMain& main, FoundModel& model) {
  if (const int medium = read_main_switch(reader, "MHK", 2); medium != 0)
    refuse_switch(reader, "MHK", medium, "0: a turbine in water is not read");
  if (reader.has("Gravity")) model.gravity = reader.at_least("Gravity", 0.0);
  if (reader.has("AirDens")) main.density = reader.positive("AirDens");
  if (reader.has("KinVisc")) main.viscosity = reader.positive("KinVisc");
}

}  // namespace

OpenFastMain read_openfast_main(const SourceFile& source, FoundModel& model) {
  KeyedLines reader(source);
  OpenFastMain main;
  main.title = reader.take_head("a main file of OpenFAST");
  model.duration = reader.positive("TMax");
  main.time_step = reader.positive("DT");
  if (reader.has("DT_Out") && !is_same_word(reader.text("DT_Out"), "default"))
    model.interval = reader.positive("DT_Out");
  read_structure(reader, main, model);
  read_air_files(reader, main, model);
  if (reader.count("CompServo", 0, 1) == 1)
    main.servodyn = take_file(reader, "ServoFile", "ServoFile");
  note_foundation(reader, model);
  read_environment(reader, main, model);
  if (reader.has("MirrorRotor") && !reader.is_off("MirrorRotor"))
    reader.lines().refuse("MirrorRotor is True, expected False: a mirrored rotor is not read");
  model.leave_out(Loss::detail,
                  source.name + ": time step and integration, outputs, linearization, pictures");
  return main;
}

}  // namespace spoke::foreign
