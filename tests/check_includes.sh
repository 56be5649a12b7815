#!/usr/bin/env bash
# Checks who includes whom:
#   examples, bench, tests -> engine -> models, graph     (models and graph do not know each other)
# and inside engine: report knows nothing of it; kernels below formulations, these below the step
# graph, integration, simulation, cli. Threads (oneTBB, OpenMP) are seen in graph/*.cpp only, tests apart.
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/.."
failures=0

# refuse PATTERN REASON FILE...: no file may include a path that matches the pattern.
refuse() {
  local pattern=$1 reason=$2 found
  shift 2
  found=$(grep -nE "#include [\"<]$pattern" "$@" /dev/null)
  [ -z "$found" ] && return
  printf '%s:\n%s\n' "$reason" "$found"
  failures=$((failures + 1))
}

sources() { find "$@" -name '*.h' -o -name '*.cpp'; }

refuse '(engine|models|Eigen)/' 'graph/ knows no physics' $(sources graph)
refuse '(engine|graph)/' 'models/ knows neither engine nor graph' $(sources models)
refuse '(tests|bench|examples)/' 'engine/ knows no user of its' $(sources engine)
refuse '(oneapi/)?tbb/|omp\.h' 'threads belong to graph/' $(sources engine models)
refuse '(oneapi/)?tbb/|omp\.h' 'no runtime in a public header' graph/*.h
refuse '(toml\+\+|spdlog|CLI|nlohmann)' 'no library but Eigen in the headers of models/ and engine/' \
  $(find models engine -maxdepth 1 -name '*.h' ! -name 'toml_*')

# Layers of the engine, lowest first: no file includes a header of a later layer.
layers=(
  'report/'
  'apart lanes log flex_layout elastic_block clock load.h load.cpp section load_data step_data step_trace memory'
  'kinematics body_terms hub natural_frequencies marker_motion load_terms'
  'formulation/'
  'integrator/generalized_alpha integrator/rk4 integrator/method integrator/step_control'
  'step_context model_memory state_copy state_values pass_ends samples shape'
  'step_parts step_graph_builder'
  'integrator/time_stepper'
  'step_recording'
  'step_runner'
  'warnings observations'
  'sensors diagnosis model_identity saved_state'
  'simulation'
  'output_file sensor_file byte_order'
  'machine json/'
  'results'
  'checkpoint vtk_series run_report/'
  'spoke'
  'compare/'
  'reproduce/'
  'predict/'
  'trace/'
  'cli/'
)
later=''
for ((k = ${#layers[@]} - 1; k >= 0; --k)); do
  files=()
  for name in ${layers[k]}; do
    files+=($(find engine -path "engine/$name*" \( -name '*.h' -o -name '*.cpp' \)))
    [ ${#files[@]} -gt 0 ] || { echo "layer of engine without a file: $name"; failures=$((failures + 1)); }
  done
  [ -n "$later" ] && refuse "engine/($later)" "engine: a lower layer includes a higher one" "${files[@]}"
  for name in ${layers[k]}; do later="${later:+$later|}$name"; done
done

# Every source of the engine belongs to a layer.
for file in $(sources engine); do
  [[ $file =~ ^engine/($later) ]] || { echo "engine file without a layer: $file"; failures=$((failures + 1)); }
done
exit $((failures > 0))
