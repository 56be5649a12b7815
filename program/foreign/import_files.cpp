// Kinds of files, what names what, and the scenario of all of them.

#include "program/foreign/import_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "models/error.h"
#include "models/solid/mesh_text.h"
#include "program/foreign/aerodyn_reader.h"
#include "program/foreign/air_writer.h"
#include "program/foreign/discon_reader.h"
#include "program/foreign/elastodyn_reader.h"
#include "program/foreign/inflowwind_reader.h"
#include "program/foreign/input_lines.h"
#include "program/foreign/openfast_main.h"
#include "program/foreign/scenario_writer.h"
#include "program/foreign/servodyn_reader.h"
#include "program/foreign/windio_reader.h"

namespace spoke::foreign {
namespace {

enum Kind {
  beamdyn_primary,
  beamdyn_blade,
  elastodyn_primary,
  elastodyn_blade,
  elastodyn_tower,
  aerodyn_primary,
  aerodyn_blade,
  openfast_main,
  inflowwind,
  servodyn,
  discon,
  windio,
  kind_count
};

constexpr const char* kKindNames[kind_count] = {"BeamDyn, primary file",
                                                "BeamDyn, blade file",
                                                "ElastoDyn, primary file",
                                                "ElastoDyn, blade file",
                                                "ElastoDyn, tower file",
                                                "AeroDyn, primary file",
                                                "AeroDyn, blade file",
                                                "OpenFAST, main file",
                                                "InflowWind",
                                                "ServoDyn",
                                                "ROSCO, DISCON.IN",
                                                "WindIO"};

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return capitals;
}

Kind find_kind(const SourceFile& source) {
  const std::string ending = in_capitals(std::filesystem::path(source.name).extension().string());
  if (ending == ".YAML" || ending == ".YML") return windio;
  const std::string_view line = std::string_view(source.text).substr(0, source.text.find('\n'));
  const std::string first = in_capitals(line);
  const auto says = [&](const char* word) { return first.find(word) != std::string::npos; };
  if (says("BEAMDYN")) return says("BLADE") ? beamdyn_blade : beamdyn_primary;
  if (says("ELASTODYN"))
    return says("BLADE") ? elastodyn_blade : says("TOWER") ? elastodyn_tower : elastodyn_primary;
  if (says("AERODYN")) return says("BLADE") ? aerodyn_blade : aerodyn_primary;
  if (says("INFLOWWIND")) return inflowwind;
  if (says("SERVODYN")) return servodyn;
  if (ending == ".FST" || says("OPENFAST")) return openfast_main;
  if (is_discon(source.text)) return discon;
  refuse(source.name, 1,
         "found " + solid::show_text(solid::trim(line)) +
             ", expected the first line of a file of OpenFAST that names BEAMDYN, ELASTODYN, "
             "AERODYN, INFLOWWIND or SERVODYN, and BLADE or TOWER where it is of one; a file "
             ".fst or .yaml; or parameters of ROSCO, with VS_ControlMode");
}

/// The files by kind, those that others name as well.
class FoundFiles {
 public:
  FoundFiles(const std::vector<SourceFile>& files, const ReadFile& read) : read_(read) {
    for (const SourceFile& file : files) {
      const Kind kind = find_kind(file);
      if (files_[kind])
        refuse(file.name, 1,
               std::string("is a second file of the kind \"") + kKindNames[kind] +
                   "\", expected one; the first is " + files_[kind]->name);
      files_[kind] = file;
    }
  }

  bool has(Kind kind) const { return files_[kind].has_value(); }
  const SourceFile& get(Kind kind) const { return *files_[kind]; }

  /// Returns the path of a file that another one names, which says `what` it should be.
  std::string find_named(Kind by, const NamedFile& named, const std::string& what) const {
    namespace fs = std::filesystem;
    const SourceFile& source = get(by);
    const auto is_control = [](unsigned char c) { return c < ' '; };
    if (named.name.empty() || std::any_of(named.name.begin(), named.name.end(), is_control))
      refuse(source.name, named.line, "names no file, expected " + what);
    return (fs::path(source.name).parent_path() / named.name).lexically_normal().string();
  }

  /// Returns such a file.
  SourceFile read_named(Kind by, const NamedFile& named, const std::string& what) const {
    const SourceFile& source = get(by);
    SourceFile file{find_named(by, named, what), {}};
    try {
      file.text = read_(file.name);
    } catch (const InputError& error) {
      refuse(source.name, named.line,
             "names a file that cannot be read: " + std::string(error.what()));
    }
    return file;
  }

  /// Reads a file that another one names, unless one of its kind is there.
  void add_named(Kind kind, Kind by, const NamedFile& named) {
    if (has(kind)) return;
    SourceFile file =
        read_named(by, named, "one of the kind \"" + std::string(kKindNames[kind]) + '"');
    if (const Kind is = find_kind(file); is != kind)
      refuse(file.name, 1,
             std::string("is of the kind \"") + kKindNames[is] + "\", expected \"" +
                 kKindNames[kind] + "\", as which " + place(get(by).name, named.line) +
                 " names it");
    files_[kind] = std::move(file);
  }

 private:
  std::array<std::optional<SourceFile>, kind_count> files_;
  const ReadFile& read_;
};

void note_source(const SourceFile& source, Kind kind, FoundModel& model) {
  model.sources.push_back(source.name + ": " + kKindNames[kind]);
}

void read_beamdyn(FoundFiles& files, FoundModel& model) {
  const SourceFile& source = files.get(beamdyn_primary);
  const BeamDynPrimary primary = read_beamdyn_primary(source);
  files.add_named(beamdyn_blade, beamdyn_primary, {primary.blade_file, primary.blade_file_line});
  const SourceFile& blade_source = files.get(beamdyn_blade);
  const BeamDynBlade blade = read_beamdyn_blade(blade_source);
  const BladeAxis axis(primary.points);
  BeamTable beam = merge_stations(axis, blade.sections);
  beam.length = {primary.points.back().x, "kp_zr of " + primary.points.back().from};
  beam.remarks.emplace_back(
      "Stations are those of the key points, kp_zr, and of the sections, eta of which is a share "
      "of "
      "the arc length of the axis; sweep is -kp_yr, prebend kp_xr, twist -initial_twist in rad.");
  if (blade.asymmetry > 1e-6)
    beam.remarks.emplace_back("Matrices were made symmetric; entries differed by up to " +
                              std::to_string(100.0 * blade.asymmetry) + " % of their diagonal.");
  model.blade = std::move(beam);
  model.damping = {blade.mu, blade.ratios, blade.damping_from};
  if (model.title.empty()) model.title = primary.title;
  note_source(source, beamdyn_primary, model);
  note_source(blade_source, beamdyn_blade, model);
  model.leave_out(Loss::detail, source.name +
                                    ": BeamDyn's method, its mesh and quadrature, the pitch "
                                    "actuator and outputs");
  if (primary.members > 1)
    model.leave_out(Loss::theory, source.name +
                                      ": ends of members, at which BeamDyn's axis may have a "
                                      "kink; the scenario's is one spline");
}

/// Reads a blade of ElastoDyn, or a tower, whose length is that of a primary file or an option.
template <class Read>
void read_by_length(const FoundFiles& files, Kind kind, const Value& found,
                    const std::optional<double>& given, const char* option, FoundModel& model,
                    const Read& read) {
  const SourceFile& source = files.get(kind);
  Value length = found;
  if (given) length = {*given, option};
  if (!(length.number > 0.0))
    refuse(source.name, 1,
           std::string("does not say how long it is, expected ") + option +
               " METERS or ElastoDyn's primary file besides");
  read(source, length, model);
  note_source(source, kind, model);
}

void read_elastodyn(FoundFiles& files, const ImportOptions& options, FoundModel& model) {
  ElastoDynPrimary primary;
  if (files.has(elastodyn_primary)) {
    const SourceFile& source = files.get(elastodyn_primary);
    primary = read_elastodyn_primary(source, model);
    note_source(source, elastodyn_primary, model);
    if (!model.blade) files.add_named(elastodyn_blade, elastodyn_primary, primary.blade);
    files.add_named(elastodyn_tower, elastodyn_primary, primary.tower);
  }
  if (files.has(elastodyn_blade))
    read_by_length(files, elastodyn_blade, primary.blade_length, options.blade_length, "--length",
                   model, read_elastodyn_blade);
  if (model.blade) model.blade->tip_mass = primary.tip_mass;
  if (!files.has(elastodyn_tower)) return;
  read_by_length(files, elastodyn_tower, primary.tower_height, options.tower_height, "--height",
                 model, read_elastodyn_tower);
  model.tower->tip_mass = primary.yaw_bearing_mass;
}

/// Reads the aerofoils that nodes of a blade use; returns their names, by BlAFID.
std::vector<std::string> read_airfoils(const FoundFiles& files, const AeroDynPrimary& primary,
                                       const std::vector<AeroDynNode>& nodes, FoundModel& model) {
  std::vector<std::string> names(primary.airfoils.size());
  int with_more = 0;
  for (const AeroDynNode& node : nodes) {
    std::string& name = names[node.airfoil];
    if (!name.empty()) continue;
    const SourceFile file =
        files.read_named(aerodyn_primary, primary.airfoils[node.airfoil], "an aerofoil file");
    std::vector<FoundAirfoil>& airfoils = model.air->airfoils;
    name = choose_airfoil_name(std::filesystem::path(file.name).stem().string(), airfoils);
    const AeroDynPolars read = read_aerodyn_polars(file, primary);
    airfoils.push_back(make_airfoil(read.polars, name, file.name));
    if (read.has_more) ++with_more;
  }
  if (with_more > 0)
    model.leave_out(Loss::theory, files.get(aerodyn_primary).name + ": further tables of " +
                                      std::to_string(with_more) +
                                      " aerofoils, of which AFTabMod 1 uses the first");
  return names;
}

void read_aerodyn(FoundFiles& files, FoundModel& model) {
  const SourceFile& source = files.get(aerodyn_primary);
  const AeroDynPrimary primary = read_aerodyn_primary(source, model);
  files.add_named(aerodyn_blade, aerodyn_primary, primary.blade);
  const SourceFile& blade = files.get(aerodyn_blade);
  const auto nodes = read_aerodyn_blade(blade, primary.airfoils.size());
  add_aerodyn_blade(nodes, blade.name, read_airfoils(files, primary, nodes, model), model);
  if (model.tower) read_aerodyn_tower(source, -model.ground.number, model);
  note_source(source, aerodyn_primary, model);
  note_source(blade, aerodyn_blade, model);
  model.sources.push_back(std::to_string(model.air->airfoils.size()) +
                          " aerofoil files that it names");
}

/// Reads the main file, and those that it names.
OpenFastMain read_main(FoundFiles& files, FoundModel& model) {
  const SourceFile& source = files.get(openfast_main);
  OpenFastMain main = read_openfast_main(source, model);
  note_source(source, openfast_main, model);
  const auto add = [&](Kind kind, const NamedFile& named) {
    if (named.line > 0) files.add_named(kind, openfast_main, named);
  };
  add(elastodyn_primary, main.elastodyn);
  if (!files.has(elastodyn_blade)) add(beamdyn_primary, main.beamdyn);
  add(aerodyn_primary, main.aerodyn);
  if (files.has(aerodyn_primary)) add(inflowwind, main.inflowwind);
  add(servodyn, main.servodyn);
  return main;
}

/// Takes from the main file what modules have by "default".
void use_main(const OpenFastMain& main, const FoundFiles& files, FoundModel& model) {
  model.title = main.title;
  if (model.air && model.air->density.number == 0.0) model.air->density = main.density;
  if (model.air && model.air->viscosity.number == 0.0) model.air->viscosity = main.viscosity;
  if (files.has(servodyn) || model.holds_speed) return;
  model.generator.emplace().from =
      "CompServo 0, " + files.get(openfast_main).name + ": nothing brakes the generator";
}

void read_wind(const FoundFiles& files, const ImportOptions& options, FoundModel& model) {
  const SourceFile& source = files.get(inflowwind);
  const InflowWindFile file = read_inflowwind(source, model);
  FoundWind& wind = *model.air->wind;
  note_source(source, inflowwind, model);
  if (file.uniform.line > 0) {
    const SourceFile table = files.read_named(inflowwind, file.uniform, "a table of wind");
    read_uniform_wind(table, file, model);
    wind.from = table.name;
    model.sources.push_back(table.name + ": table of a uniform wind");
  }
  if (file.turbsim.line == 0) return;
  wind.file = files.find_named(inflowwind, file.turbsim, "a file of TurbSim (.bts)");
  wind.from = "FileName_BTS, " + place(source.name, file.turbsim.line);
  const std::string ending = in_capitals(std::filesystem::path(wind.file).extension().string());
  if (ending != ".BTS" || !options.is_there(wind.file))
    refuse(source.name, file.turbsim.line,
           "FileName_BTS is \"" + printable(file.turbsim.name) + "\", but there is no file " +
               printable(wind.file) + ", expected a file of TurbSim (.bts)");
  model.sources.push_back(wind.file + ": wind of TurbSim, which the scenario names");
}

/// Reads the parameters that a library would, if they are of ROSCO, in place of one that is not
/// there.
bool read_in_place(const FoundFiles& files, const NamedFile& input, FoundModel& model) {
  if (input.name.empty()) return false;
  SourceFile parameters;
  try {
    parameters = files.read_named(servodyn, input, "the file that the library reads");
  } catch (const InputError&) {
    return false;  // as if it were not there
  }
  if (!is_discon(parameters.text)) return false;
  read_discon(parameters, model);
  note_source(parameters, discon, model);
  return true;
}

void read_servo(FoundFiles& files, const ImportOptions& options, FoundModel& model) {
  const SourceFile& source = files.get(servodyn);
  const ServoDynFile file = read_servodyn(source, model);
  note_source(source, servodyn, model);
  if (!model.library) return;
  FoundLibrary& library = *model.library;
  library.file = files.find_named(servodyn, file.library, "a shared library");
  if (!options.is_there(library.file) && !model.laws) read_in_place(files, file.input, model);
  if (model.laws) {
    model.leave_out(Loss::theory, place(source.name, file.library.line) + ": the library " +
                                      printable(library.file) +
                                      ", in whose place [control.turbine] has its laws");
    model.library.reset();
    return;
  }
  if (!file.input.name.empty())
    library.input = files.find_named(servodyn, file.input, "the file that the library reads");
  const auto miss = [&](const std::string& name, const NamedFile& named) {
    if (name.empty() || options.is_there(name)) return;
    library.is_there = false;
    model.leave_out(Loss::part, place(source.name, named.line) + ": names " + printable(name) +
                                    ", which is not there: the drive holds RotSpeed, the blades "
                                    "BlPitch(1); [control.library] stands in comments");
  };
  miss(library.file, file.library);
  if (library.is_there) miss(library.input, file.input);
}

/// Lets laws take over what other files move, and says what of these goes.
void take_over(FoundModel& model) {
  TurbineLaws& laws = *model.laws;
  if (model.holds_speed && laws.torque) {
    model.leave_out(Loss::part,
                    model.laws_from + ": the torque, since GenDOF False holds the speed");
    laws.torque.reset();
    laws.smoothing.reset();
  }
  if (laws.torque) model.generator.reset();
  const auto drop = [&model](std::optional<FoundManeuver>& maneuver, const char* what) {
    if (!maneuver) return;
    model.leave_out(Loss::part, maneuver->from + ": the override of the controlled " + what);
    maneuver.reset();
  };
  if (model.controls_pitch()) drop(model.pitch_maneuver, "pitch");
  if (!model.controls_yaw()) return;
  drop(model.yaw.maneuver, "yaw");
  if (!model.yaw.moves) return;
  model.yaw.moves = false;
  model.leave_out(Loss::value,
                  model.yaw.stiffness.from + ": the nacelle follows what yaws it without a spring");
}

/// What a turbine has besides these files.
void note_missing(const FoundFiles& files, FoundModel& model) {
  const bool has_main = files.has(openfast_main), has_rotor = files.has(elastodyn_primary);
  if (has_rotor && !has_main) {
    std::string missing = files.has(servodyn)
                              ? ""
                              : "torque of the generator, control of speed and pitch (the drive "
                                "holds RotSpeed), yaw (the nacelle is fixed to the tower), ";
    if (!files.has(inflowwind)) missing += "wind, ";
    model.leave_out(Loss::part, "in other files of a turbine: " + missing +
                                    "foundation, soil, water, floater and moorings (the foot of "
                                    "the tower is held)");
    if (!model.air) model.leave_out(Loss::part, "in other files of a turbine: the air");
  } else if (model.tower && !has_rotor && !files.has(windio)) {
    model.leave_out(
        Loss::part,
        "in other files of a turbine: the rotor and all else that the tower carries, "
        "foundation, soil, water, floater and moorings (the foot of the tower is held)");
  }
  if (!model.tower && !model.has_rotor)
    model.leave_out(Loss::part, "gravity: the files do not say which way is down");
}

/// Refuses files that would go unused, or say the same twice.
void check_use(const FoundFiles& files) {
  if (files.has(beamdyn_blade) && !files.has(beamdyn_primary))
    refuse(files.get(beamdyn_blade).name, 1,
           "has no key points, expected BeamDyn's primary file besides");
  const std::array<Kind, 3> blades{beamdyn_primary, elastodyn_blade, windio};
  const SourceFile* first = nullptr;
  for (const Kind kind : blades) {
    if (!files.has(kind)) continue;
    if (first)
      refuse(files.get(kind).name, 1,
             "is a second description of a blade, expected one; the first "
             "is " +
                 first->name);
    first = &files.get(kind);
  }
  if (files.has(aerodyn_blade) && !files.has(aerodyn_primary))
    refuse(files.get(aerodyn_blade).name, 1,
           "has no names of aerofoils, expected AeroDyn's primary file besides");
  for (const Kind kind : {openfast_main, elastodyn_primary, elastodyn_tower, aerodyn_primary})
    if (files.has(windio) && files.has(kind))
      refuse(files.get(kind).name, 1,
             "given along with " + files.get(windio).name + ", expected an ontology by itself");
  if (files.has(servodyn) && !files.has(elastodyn_primary))
    refuse(files.get(servodyn).name, 1,
           "has no rotor to control, expected ElastoDyn's primary file besides");
  if (files.has(inflowwind) && !files.has(aerodyn_primary))
    refuse(files.get(inflowwind).name, 1,
           "has no blades for its wind, expected AeroDyn's primary file besides");
  if (files.has(discon) && !files.has(elastodyn_primary) && !files.has(windio))
    refuse(files.get(discon).name, 1,
           "has no rotor to control, expected the main file of its turbine besides, or an ontology "
           "of WindIO");
  if (files.has(aerodyn_primary) && !first && !files.has(elastodyn_primary))
    refuse(files.get(aerodyn_primary).name, 1,
           "has no structure of the blades, expected files of BeamDyn or ElastoDyn besides");
}

Scenario check_scenario(const std::string& text, const std::string& file) {
  try {
    return parse_scenario(text, "scenario");
  } catch (const InputError& error) {
    refuse(file, 0, "makes a scenario that is refused: " + std::string(error.what()));
  }
}

/// Writes the scenario and its tables, and checks it.
Imported write_imported(FoundModel& model, const std::string& first, const ImportOptions& options) {
  std::stable_sort(model.left_out.begin(), model.left_out.end(),
                   [](const LeftOut& a, const LeftOut& b) { return a.loss < b.loss; });
  Imported imported;
  const ScenarioPlaces places{options.folder, options.airfoil_folder, options.wind_table};
  imported.text = write_scenario(model, &places);
  // Its tables are not there yet.
  imported.scenario = check_scenario(write_scenario(model), first);
  if (model.air) {
    for (const FoundAirfoil& airfoil : model.air->airfoils)
      imported.tables.push_back(
          {airfoil_path(options.airfoil_folder, airfoil.airfoil.name), airfoil.table});
    if (model.air->wind && !model.air->wind->table.empty())
      imported.tables.push_back({options.wind_table, model.air->wind->table});
  }
  imported.sources = model.sources;
  for (const LeftOut& left_out : model.left_out) imported.left_out.push_back(left_out.text);
  return imported;
}

}  // namespace

Imported import_files(const std::vector<SourceFile>& files, const ReadFile& read,
                      const ImportOptions& options) {
  FoundFiles found(files, read);
  FoundModel model;
  std::optional<OpenFastMain> main;
  if (found.has(openfast_main) && !found.has(windio)) main = read_main(found, model);
  check_use(found);
  if (found.has(discon)) {
    read_discon(found.get(discon), model);
    note_source(found.get(discon), discon, model);
  }
  if (found.has(aerodyn_primary)) model.air.emplace();
  if (found.has(beamdyn_primary)) read_beamdyn(found, model);
  if (found.has(windio)) {
    read_windio(found.get(windio), model);
    note_source(found.get(windio), windio, model);
  }
  read_elastodyn(found, options, model);
  if (found.has(aerodyn_primary)) read_aerodyn(found, model);
  if (found.has(inflowwind)) read_wind(found, options, model);
  if (found.has(servodyn)) read_servo(found, options, model);
  if (main) use_main(*main, found, model);
  if (model.laws) take_over(model);
  note_missing(found, model);
  return write_imported(model, files.front().name, options);
}

}  // namespace spoke::foreign
