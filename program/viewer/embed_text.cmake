# cmake -DFUNCTION=spoke::report::run_script -DHEADER=program/report/run_script.h -DOUTPUT=run_script.cpp
#       "-DINPUTS=a.js|b.js" -P embed_text.cmake
# Makes a source file with the function, which HEADER declares, that returns the files' text, one after
# the other.
string(REGEX REPLACE "::[^:]*$" "" namespace "${FUNCTION}")
string(REGEX REPLACE "^.*::" "" name "${FUNCTION}")
string(REPLACE "|" ";" INPUTS "${INPUTS}")
set(parts "")
foreach(input IN LISTS INPUTS)
  file(READ "${input}" text)
  string(FIND "${text}" ")embedded\"" end)
  if(NOT end EQUAL -1)
    message(FATAL_ERROR "${input}: contains the end mark of embedded texts, )embedded\"")
  endif()
  string(REGEX MATCH "[^ -~\n]" other "${text}")
  if(other)
    message(FATAL_ERROR "${input}: contains other characters than ASCII and line feeds")
  endif()
  # A compiler need not take literals of more than 64 kB, however they are put together.
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 16000 part)
    string(APPEND parts "      R\"embedded(${part})embedded\",\n")
    math(EXPR at "${at} + 16000")
  endwhile()
endforeach()
file(WRITE "${OUTPUT}" "#include \"${HEADER}\"

#include <initializer_list>
#include <string>

namespace ${namespace} {

std::string_view ${name}() {
  static const std::string kText = [] {
    std::string text;
    for (const std::string_view part : std::initializer_list<std::string_view>{
${parts}         })
      text += part;
    return text;
  }();
  return kText;
}

}  // namespace ${namespace}
")
