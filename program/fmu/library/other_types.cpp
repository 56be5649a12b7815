// Functions of FMI 3.0 for types of which this FMU has no variables, and for clocks: they take no
// references.

#include <cstddef>

#include "program/fmu/fmi3.h"
#include "program/fmu/library/answers.h"

using References = const fmi3ValueReference[];
using spoke::fmu::no_variables;
using std::size_t;

SPOKE_FMI3 fmi3Status fmi3GetFloat32(fmi3Instance instance, References, size_t count, fmi3Float32[],
                                     size_t) {
  return no_variables(instance, "fmi3GetFloat32", count);
}
SPOKE_FMI3 fmi3Status fmi3SetFloat32(fmi3Instance instance, References, size_t count,
                                     const fmi3Float32[], size_t) {
  return no_variables(instance, "fmi3SetFloat32", count);
}
SPOKE_FMI3 fmi3Status fmi3GetInt8(fmi3Instance instance, References, size_t count, fmi3Int8[],
                                  size_t) {
  return no_variables(instance, "fmi3GetInt8", count);
}
SPOKE_FMI3 fmi3Status fmi3SetInt8(fmi3Instance instance, References, size_t count, const fmi3Int8[],
                                  size_t) {
  return no_variables(instance, "fmi3SetInt8", count);
}
SPOKE_FMI3 fmi3Status fmi3GetUInt8(fmi3Instance instance, References, size_t count, fmi3UInt8[],
                                   size_t) {
  return no_variables(instance, "fmi3GetUInt8", count);
}
SPOKE_FMI3 fmi3Status fmi3SetUInt8(fmi3Instance instance, References, size_t count,
                                   const fmi3UInt8[], size_t) {
  return no_variables(instance, "fmi3SetUInt8", count);
}
SPOKE_FMI3 fmi3Status fmi3GetInt16(fmi3Instance instance, References, size_t count, fmi3Int16[],
                                   size_t) {
  return no_variables(instance, "fmi3GetInt16", count);
}
SPOKE_FMI3 fmi3Status fmi3SetInt16(fmi3Instance instance, References, size_t count,
                                   const fmi3Int16[], size_t) {
  return no_variables(instance, "fmi3SetInt16", count);
}
SPOKE_FMI3 fmi3Status fmi3GetUInt16(fmi3Instance instance, References, size_t count, fmi3UInt16[],
                                    size_t) {
  return no_variables(instance, "fmi3GetUInt16", count);
}
SPOKE_FMI3 fmi3Status fmi3SetUInt16(fmi3Instance instance, References, size_t count,
                                    const fmi3UInt16[], size_t) {
  return no_variables(instance, "fmi3SetUInt16", count);
}
SPOKE_FMI3 fmi3Status fmi3GetInt32(fmi3Instance instance, References, size_t count, fmi3Int32[],
                                   size_t) {
  return no_variables(instance, "fmi3GetInt32", count);
}
SPOKE_FMI3 fmi3Status fmi3SetInt32(fmi3Instance instance, References, size_t count,
                                   const fmi3Int32[], size_t) {
  return no_variables(instance, "fmi3SetInt32", count);
}
SPOKE_FMI3 fmi3Status fmi3GetUInt32(fmi3Instance instance, References, size_t count, fmi3UInt32[],
                                    size_t) {
  return no_variables(instance, "fmi3GetUInt32", count);
}
SPOKE_FMI3 fmi3Status fmi3SetUInt32(fmi3Instance instance, References, size_t count,
                                    const fmi3UInt32[], size_t) {
  return no_variables(instance, "fmi3SetUInt32", count);
}
SPOKE_FMI3 fmi3Status fmi3GetInt64(fmi3Instance instance, References, size_t count, fmi3Int64[],
                                   size_t) {
  return no_variables(instance, "fmi3GetInt64", count);
}
SPOKE_FMI3 fmi3Status fmi3SetInt64(fmi3Instance instance, References, size_t count,
                                   const fmi3Int64[], size_t) {
  return no_variables(instance, "fmi3SetInt64", count);
}
SPOKE_FMI3 fmi3Status fmi3GetUInt64(fmi3Instance instance, References, size_t count, fmi3UInt64[],
                                    size_t) {
  return no_variables(instance, "fmi3GetUInt64", count);
}
SPOKE_FMI3 fmi3Status fmi3SetUInt64(fmi3Instance instance, References, size_t count,
                                    const fmi3UInt64[], size_t) {
  return no_variables(instance, "fmi3SetUInt64", count);
}
SPOKE_FMI3 fmi3Status fmi3GetBoolean(fmi3Instance instance, References, size_t count, fmi3Boolean[],
                                     size_t) {
  return no_variables(instance, "fmi3GetBoolean", count);
}
SPOKE_FMI3 fmi3Status fmi3SetBoolean(fmi3Instance instance, References, size_t count,
                                     const fmi3Boolean[], size_t) {
  return no_variables(instance, "fmi3SetBoolean", count);
}
SPOKE_FMI3 fmi3Status fmi3GetString(fmi3Instance instance, References, size_t count, fmi3String[],
                                    size_t) {
  return no_variables(instance, "fmi3GetString", count);
}
SPOKE_FMI3 fmi3Status fmi3SetString(fmi3Instance instance, References, size_t count,
                                    const fmi3String[], size_t) {
  return no_variables(instance, "fmi3SetString", count);
}
SPOKE_FMI3 fmi3Status fmi3GetBinary(fmi3Instance instance, References, size_t count, size_t[],
                                    fmi3Binary[], size_t) {
  return no_variables(instance, "fmi3GetBinary", count);
}
SPOKE_FMI3 fmi3Status fmi3SetBinary(fmi3Instance instance, References, size_t count, const size_t[],
                                    const fmi3Binary[], size_t) {
  return no_variables(instance, "fmi3SetBinary", count);
}
SPOKE_FMI3 fmi3Status fmi3GetClock(fmi3Instance instance, References, size_t count, fmi3Clock[]) {
  return no_variables(instance, "fmi3GetClock", count);
}
SPOKE_FMI3 fmi3Status fmi3SetClock(fmi3Instance instance, References, size_t count,
                                   const fmi3Clock[]) {
  return no_variables(instance, "fmi3SetClock", count);
}
SPOKE_FMI3 fmi3Status fmi3GetIntervalDecimal(fmi3Instance instance, References, size_t count,
                                             fmi3Float64[], fmi3IntervalQualifier[]) {
  return no_variables(instance, "fmi3GetIntervalDecimal", count);
}
SPOKE_FMI3 fmi3Status fmi3GetIntervalFraction(fmi3Instance instance, References, size_t count,
                                              fmi3UInt64[], fmi3UInt64[], fmi3IntervalQualifier[]) {
  return no_variables(instance, "fmi3GetIntervalFraction", count);
}
SPOKE_FMI3 fmi3Status fmi3GetShiftDecimal(fmi3Instance instance, References, size_t count,
                                          fmi3Float64[]) {
  return no_variables(instance, "fmi3GetShiftDecimal", count);
}
SPOKE_FMI3 fmi3Status fmi3GetShiftFraction(fmi3Instance instance, References, size_t count,
                                           fmi3UInt64[], fmi3UInt64[]) {
  return no_variables(instance, "fmi3GetShiftFraction", count);
}
SPOKE_FMI3 fmi3Status fmi3SetIntervalDecimal(fmi3Instance instance, References, size_t count,
                                             const fmi3Float64[]) {
  return no_variables(instance, "fmi3SetIntervalDecimal", count);
}
SPOKE_FMI3 fmi3Status fmi3SetIntervalFraction(fmi3Instance instance, References, size_t count,
                                              const fmi3UInt64[], const fmi3UInt64[]) {
  return no_variables(instance, "fmi3SetIntervalFraction", count);
}
SPOKE_FMI3 fmi3Status fmi3SetShiftDecimal(fmi3Instance instance, References, size_t count,
                                          const fmi3Float64[]) {
  return no_variables(instance, "fmi3SetShiftDecimal", count);
}
SPOKE_FMI3 fmi3Status fmi3SetShiftFraction(fmi3Instance instance, References, size_t count,
                                           const fmi3UInt64[], const fmi3UInt64[]) {
  return no_variables(instance, "fmi3SetShiftFraction", count);
}
