// The texts of --help.

#include "program/cli/help_texts.h"

namespace spoke::cli {

const char* const kStudySummary = "Run a scenario many times, with other values";
const char* const kImportSummary = "Make a scenario of files of other programs";
const char* const kFmuSummary = "Make an FMU of a scenario, for other programs to simulate with";
const char* const kExportSummary = "Write a blade of a scenario as files of another program";
const char* const kVerifySummary = "Compare results with published and exact ones";
const char* const kCompareSummary = "Measure which executor and number of threads is fastest here";
const char* const kReproduceSummary = "Repeat the paper's evaluation on this machine";

const char* const kStatusText = R"(Exit status:
  0  done
  1  a fault in spoke itself
  2  bad command line or scenario, or output that cannot be written;
     the message on stderr says file:line:column, key, what is wrong and what is expected
  3  the simulation diverged; results so far are kept
  129, 130, 143  SIGHUP, SIGINT or SIGTERM ended a run; results so far are kept
)";

const char* const kMeasuringStatusText = R"(Exit status:
  0  done
  1  a fault in spoke itself
  2  bad command line or scenario, output that cannot be written, or nothing could be measured;
     the message on stderr says what is wrong
  3  the simulation diverged; nothing is written
  129, 130, 143  SIGHUP, SIGINT or SIGTERM ended it (as a shell reports that); nothing is written
)";

const char* const kRunText = R"(Output files, in the folder of --out:
  sensors.csv   a row per output time: t, tip displacements, hub motion and torque, energies,
                root loads, and what the scenario's [[sensor]] tables ask for
  summary.json  all values in force, machine, steps, wall time, hash of the final state, and
                the extremes of every sensor over all steps; of models in air statistics:
                means, deviations, and damage-equivalent ranges of root moments
  report.html   a page to look at: plots over time, the rotor moving, all numbers; needs no network
  vtk/          with --vtk: blades.pvd for ParaView and a file for each output time, two with
                solids
  checkpoint.spoke  with --checkpoint-every: what --resume goes on from, see docs/checkpoint.md

mpirun -n P spoke run ... shares the model out over P processes, with the same files
(docs/machines.md).

The first Ctrl-C (SIGINT), SIGTERM or SIGHUP completes the step, writes rows, summary and
checkpoint, and ends; a second one ends at once.

Examples:
  spoke run models/wu_haug_rotor.toml --set blade.bodies=8 --set integration.step=0.01
  spoke run long.toml --checkpoint-every 60
  spoke run long.toml --checkpoint-every 60 --resume results/long/checkpoint.spoke
)";

const char* const kCheckText =
    R"(Prints subsystems, bodies, coordinates and joints, nodes and edges of the step graph, lowest and
highest natural frequency at rest, the largest step that rk4 is stable at, and the step in force; of
a model in space its tree of bodies and joints and its mass, too, and rk4's step at the largest
speed of the drive if that is less than the one at rest. Writes no files but that of --html, which
shows wrong twists and axes before a run. Warns on stderr if the scenario's method is rk4 and
its step is not stable.

Example:
  spoke check models/wu_haug_rotor.toml --set blade.elements=8
  spoke check models/nrel_5mw_rotor.toml --html model.html
)";

const char* const kReduceText =
    R"(Reduces every body of kind "solid" as all commands do, and prints its mesh, mass and interfaces; the
frequencies of its vibration modes with all interfaces held, and of the modes that its deformation is
made of: these and the static shapes of its interfaces, made orthonormal; damping, time and memory.
Warns on stderr of meshes of linear elements, which are too stiff. See docs/scenario.md.

What is made is kept in files of a folder and read from there by every command, with the same bits:
$SPOKE_CACHE, else $XDG_CACHE_HOME/spoke, else $HOME/.cache/spoke; SPOKE_CACHE=none keeps nothing.
Such a file may be removed at any time. Writes no other files.

Examples:
  spoke reduce models/solid_bracket.toml
  spoke reduce models/solid_bracket.toml --set subsystem.1.body.1.modes=40 --force
)";

const char* const kStaticText =
    R"(Newton's method with a line search, and load steps where it needs them. Loads, motors and prescribed
joints have the values that their curves end with, pitch by the azimuth its mean. Where the hub turns,
gravity, wind and loads of constant direction count with their part along the axis. Says whether small
motions about it decay.

Output files, in the folder of --out:
  static.html         the model in equilibrium, deflections, tips, joints, wrench of the hub
  static.json         everything
  section_forces.csv  forces and moments along the blades
  section_air.csv     flow and forces of the air along the blades, if there is air

Example:
  spoke static models/articulated_rotor.toml --speed 36
)";

const char* const kModesText =
    R"(About the equilibrium of spoke static, in the frame that turns with the hub: eigenvalues of the
linearised model, real ones at rest without damping, else complex ones. With --frame fixed as seen
from outside, in multi-blade coordinates: collective, progressive and regressive modes of 3 or more
equal blades, and the whirls of shafts; with --frame floquet of any blades, by harmonics, about the
motion that gravity across the axis causes. A rotor on a support, and a shaft in bearings, are seen
from outside unless --frame says otherwise, with modes like "tower fore-aft" and "whirl 1 forward".
See docs/modes.md.

Output files, in the folder of --out:
  modes.html  the chosen mode as a moving picture
  modes.csv   a row per mode
  modes.json  everything, shapes included

Example:
  spoke modes models/nrel_5mw_rotor.toml --speed 1.267 --count 6
  spoke modes models/nrel_5mw_rotor.toml --frame fixed --count 9
  spoke modes helicopter.toml --speed 36 --speed tail=180
)";

const char* const kCampbellText =
    R"(The modes of spoke modes at each speed, on all processors, followed from speed to speed by their
shapes, with further speeds where that is in doubt; where they meet 1 to 6 times the speed; how far
that is from the speed of the drive.

Output files, in the folder of --out:
  campbell.html  the diagram, damping over speed, the chosen mode moving, crossings
  campbell.csv   a row per speed and mode
  campbell.json  the same, and the crossings

Example:
  spoke campbell models/nrel_5mw_rotor.toml --speeds 0:2:0.1 --count 4
  spoke campbell models/nrel_5mw_rotor.toml --speeds 0:2:0.1 --count 6 --frame fixed
)";

const char* const kCriticalText =
    R"(The least value in the range at which an equilibrium is lost or a mode stops decaying: buckling and
divergence, flutter, critical speeds of shafts, limit points, jumps to another steady state.
Equilibria are followed from value to value; the first change is narrowed down to 1e-10 by bisection.
A value that is found in none of the range is no error. See docs/modes.md.

Output files, in the folder of --out:
  critical.html  the critical mode as a moving picture, frequencies and growth over the range
  critical.csv   a row per value and mode
  critical.json  everything, with the shape of the critical mode

Examples:
  spoke critical models/nrel_5mw_rotor.toml --of speed --from 0 --to 4
  spoke critical column.toml --of load=push --from 0 --to 3
)";

const char* const kPerformanceText =
    R"(Steady states of the rotor in uniform wind along its axis. Over wind speeds, where the drive is a torque
by speed the rotor turns as fast as the air drives it; from the set point of [control.pitch] on, pitch
holds that. Else it turns with the speed of the drive. Over tip-speed ratios and pitch: a map of C_P and
C_T at one wind speed. Blades deform unless --rigid is given; the support is rigid. See
docs/aerodynamics.md.

Output files, in the folder of --out:
  performance.html  the curves
  Cp_Ct_Cq.txt      of a map: tables of coefficients, as the controller ROSCO reads them
  performance.csv   a row per operating point
  performance.json  the same

Examples:
  spoke performance models/nrel_5mw_in_wind.toml --wind 3:25:1
  spoke performance models/nrel_5mw_in_wind.toml --tip-speed-ratio 2:14:0.5 --pitch -10:10:2 --rigid
)";

const char* const kLinearizeText =
    R"(Small motions x about the equilibrium of spoke static, in the frame that turns with the hub:
x' = A x + B u, y = C x + D u; u: factors of loads, motors, the drive's torque; y: tips, joints and
the scenario's sensors whose frames turn with the hub. With --frame fixed, the usual frame of a
rotor that turns on a support, as seen from outside, in multi-blade coordinates: states, inputs and
outputs of 3 or more equal blades are their collective, cosine and sine amplitudes, which support
and hub, along axes that stand, meet with constant matrices. See docs/modes.md.

Output files, in the folder of --out:
  A.mtx, B.mtx, C.mtx, D.mtx  the matrices (Matrix Market: scipy.io.mmread reads them)
  linear.json                 names and units of states, inputs and outputs

Examples:
  spoke linearize models/articulated_rotor.toml --speed 40
  spoke linearize models/nrel_5mw_turbine.toml --speed 1.2
)";

const char* const kWindText =
    R"(Generates the turbulence of [wind.turbulence], adds the mean wind with its profile, and writes both as a
full-field file of TurbSim, periodic (identifier 8): for other programs, or for `file` of [wind]. A gust
is left out. Velocities are rounded to a 65535th of their range. See docs/wind.md.

Examples:
  spoke wind models/nrel_5mw_in_wind.toml --out wind.bts
  spoke wind models/nrel_5mw_in_wind.toml --set wind.turbulence.seed=2 --out wind_2.bts
)";

const char* const kSchemaText =
    R"(Prints every key that a scenario may have, with its meaning, unit, default and range. An editor that
knows TOML completes and checks scenarios by the JSON schema: see docs/scenario.md. Rules over several
keys are not in it; spoke check knows them.

Examples:
  spoke schema --json > spoke.schema.json
  spoke schema --markdown
)";

const char* const kNewText =
    R"(Writes NAME.toml, a small scenario with a comment on each line, which runs as it is:
  rotor       three elastic blades on a hub
  turbine     a wind turbine on its tower, in the wind
  helicopter  a rotor with hinges and pitch, in hover
  mechanism   a slider-crank with an elastic rod
  part        a solid from a mesh, NAME.inp
A file that is there already is left as it is.

Examples:
  spoke new turbine mine
  spoke run mine.toml
)";

const char* const kHelpText =
    R"(Prints all keys of this name with their tables, meaning, unit, default and range, and of a table its keys.
All of them, with examples, are in docs/scenario.md; `spoke --help` lists the commands.

Examples:
  spoke help hub.drive.speed
  spoke help blade.joint
)";

const char* const kDoctorText =
    R"(Says which version and commit this is, what it was built with and without, which of its commands
are built, which programs of others it finds, and where it keeps and writes files. What is missing is
named with what it is for and with Debian's package.

Examples:
  spoke doctor
)";

const char* const kTraceText =
    R"(Records which thread runs which node of the step graph when, in the steps that follow --from. The
steps are those of spoke run: same graph, same executor, same bits. Steps that are less than half a
window run without windows, and as long as auto has not chosen, it runs them serially: a line says
so. If the simulation diverges meanwhile, the steps before are written. Then simulates the steps on
other numbers of threads, with the nodes as costly as they were: by a list schedule that costs
nothing, and by the plan that auto would take.

Output files, in the folder of --out:
  trace.json  Chrome trace events, for https://ui.perfetto.dev and chrome://tracing
  graph.dot   the step graph, coloured by share of the time, with its longest path
  trace.html  graph and threads side by side, in one page, if the program was built with it

Example:
  spoke trace models/wu_haug_rotor.toml --formulation subsystem --executor flow_graph
)";

const char* const kProgramText = R"(Examples:
  spoke run models/wu_haug_rotor.toml
  spoke check models/wu_haug_rotor.toml
  spoke reduce models/solid_bracket.toml
  spoke static models/articulated_rotor.toml
  spoke modes models/nrel_5mw_rotor.toml
  spoke campbell models/nrel_5mw_rotor.toml --speeds 0:2:0.1
  spoke critical models/nrel_5mw_rotor.toml --of speed --from 0 --to 4
  spoke performance models/nrel_5mw_in_wind.toml --wind 3:25:1
  spoke new turbine mine
  spoke help hub.drive.speed
  spoke import blade_BeamDyn.dat --out blade.toml
  spoke export beamdyn models/nrel_5mw_rotor.toml --out nrel_5mw_BeamDyn.dat
  spoke fmu models/wu_haug_rotor.toml --out rotor.fmu
  spoke compare models/wu_haug_rotor.toml
  spoke trace models/wu_haug_rotor.toml
  spoke reproduce

"spoke run --help" and so on explain options and output of the commands.
)";

}  // namespace spoke::cli
