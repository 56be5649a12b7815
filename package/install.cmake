# What `cmake --install` installs, in components: `program`, `development`, `library` if shared, which
# the program then needs, and `python` if its package is built.
# All paths are relative to the prefix, so that the tree can be moved.
set(cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/spoke)
set(models_folder ${CMAKE_INSTALL_DATADIR}/spoke/models)

# Building the program alone, as `./spoke run` does, leaves most of this unbuilt: said in one line before
# anything is copied (the space keeps CMake from wrapping it). COMPONENT is the one that is installed,
# FILE what it cannot do without.
function(spoke_require_built component file)
  install(CODE "
if(NOT EXISTS \"${file}\")
  message(FATAL_ERROR \" Spoke is not built yet, run first: cmake --build ${PROJECT_BINARY_DIR}\")
endif()" COMPONENT ${component})
endfunction()
spoke_require_built(development $<TARGET_FILE:spoke_library>)
spoke_require_built(development ${headers_stamp})
if(BUILD_SHARED_LIBS)
  spoke_require_built(library $<TARGET_FILE:spoke_library>)
endif()
if(SPOKE_PROGRAM)
  get_property(commands GLOBAL PROPERTY SPOKE_COMMANDS)
  foreach(program spoke ${commands})
    spoke_require_built(program $<TARGET_FILE:${program}>)
  endforeach()
endif()

# Programs and the Python module find the library that they share from where they lie themselves.
function(spoke_find_library_from folder)
  if(SPOKE_SHARES_ENGINE)
    file(RELATIVE_PATH to_library /${folder} /${CMAKE_INSTALL_LIBDIR})
    set_target_properties(${ARGN} PROPERTIES INSTALL_RPATH "$ORIGIN/${to_library}")
  endif()
endfunction()

install(TARGETS spoke_library EXPORT spokeTargets
  LIBRARY COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development)
install(DIRECTORY ${public_headers}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT spokeTargets NAMESPACE spoke:: DESTINATION ${cmake_folder} COMPONENT development)

configure_package_config_file(spokeConfig.cmake.in spokeConfig.cmake
  INSTALL_DESTINATION ${cmake_folder} PATH_VARS models_folder)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/spokeConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/spokeConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/spokeConfigVersion.cmake
  DESTINATION ${cmake_folder} COMPONENT development)

# pkg-config: a static library hands what it needs to whoever links it.
set(pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH pc_to_prefix /${pc_folder} /)
string(REGEX REPLACE "/$" "" pc_to_prefix ${pc_to_prefix})
set(pc_requires "eigen3 >= 3.4")
set(pc_libraries "")
if(NOT BUILD_SHARED_LIBS)
  string(APPEND pc_requires ", spdlog, tbb >= 2021, tomlplusplus, zlib")
  list(TRANSFORM openmp_libraries REPLACE "^([^-/].*)$" "-l\\1" OUTPUT_VARIABLE pc_libraries)
  list(TRANSFORM pc_libraries PREPEND " ")
  list(JOIN pc_libraries "" pc_libraries)
endif()
configure_file(spoke.pc.in spoke.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/spoke.pc DESTINATION ${pc_folder} COMPONENT development)

if(SPOKE_PROGRAM)
  set_target_properties(spoke PROPERTIES EXPORT_NAME program)
  spoke_find_library_from(${CMAKE_INSTALL_BINDIR} spoke ${commands})
  install(TARGETS spoke EXPORT spokeProgramTargets RUNTIME COMPONENT program)
  install(TARGETS ${commands} RUNTIME COMPONENT program)
  if(TARGET spoke_fmu_library)
    spoke_require_built(program $<TARGET_FILE:spoke_fmu_library>)
    install(TARGETS spoke_fmu_library
      LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/spoke COMPONENT program)
  endif()
  # Man pages are made of the help of the program that is installed.
  install(CODE "
execute_process(
  COMMAND bash \"${CMAKE_CURRENT_LIST_DIR}/make_man_pages.sh\" \"$<TARGET_FILE:spoke>\"
    ${PROJECT_VERSION} \"${CMAKE_CURRENT_BINARY_DIR}/man1\"
  COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
  install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR}
    COMPONENT program)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/completion.bash RENAME spoke
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
  install(EXPORT spokeProgramTargets NAMESPACE spoke:: DESTINATION ${cmake_folder} COMPONENT program)
endif()
if(TARGET spoke_python)
  spoke_require_built(python $<TARGET_FILE:spoke_python>)
  get_target_property(python_sources spoke_python SPOKE_SOURCES)
  spoke_find_library_from(${SPOKE_PYTHON_DESTINATION}/spoke spoke_python)
  install(TARGETS spoke_python
    LIBRARY DESTINATION ${SPOKE_PYTHON_DESTINATION}/spoke COMPONENT python)
  install(FILES ${python_sources} DESTINATION ${SPOKE_PYTHON_DESTINATION}/spoke COMPONENT python)
endif()
file(GLOB scenarios CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/models/*.toml)
install(FILES ${scenarios} DESTINATION ${models_folder} COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models/studies ${PROJECT_SOURCE_DIR}/models/meshes
  ${PROJECT_SOURCE_DIR}/models/airfoils
  DESTINATION ${models_folder}
  COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/LICENSE
  ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/spoke COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/spoke
  COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/spoke
  COMPONENT program PATTERN "*.sh" EXCLUDE PATTERN "*.dot" EXCLUDE)
