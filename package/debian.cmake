# `cpack -G DEB`: the program (spoke), the library (libspoke-dev; if shared, also libspokeX.Y, which the
# program and the Python package then need) and, if it is built, the Python package (python3-spoke). What
# programs and shared libraries depend on besides is found by dpkg-shlibdeps.
set(SPOKE_PACKAGE_MAINTAINER "The Spoke developers <spoke@localhost>" CACHE STRING
    "Maintainer of the Debian packages: Name <address>")
set(release 1)
set(runtime_package libspoke${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

set(CPACK_PACKAGE_NAME spoke)
set(CPACK_PACKAGE_VENDOR "The Spoke developers")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_RESOURCE_FILE_README ${PROJECT_SOURCE_DIR}/README.md)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL development)
if(SPOKE_PROGRAM)
  list(APPEND CPACK_COMPONENTS_ALL program)
endif()
if(BUILD_SHARED_LIBS)
  list(APPEND CPACK_COMPONENTS_ALL library)
endif()
if(TARGET spoke_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${release})
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${SPOKE_PACKAGE_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
if(BUILD_SHARED_LIBS)
  # Before 1.0 programs need the minor version that they were built with; Spoke's own the very same.
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/package)
  set(this_library "${runtime_package} (= ${PROJECT_VERSION}-${release})")
endif()
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(what "Spoke simulates rotors with flexible blades. Every integration step is a task graph, run
on one thread or many with the same bits.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME spoke)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "dynamics of rotors with flexible blades
${what} This package contains the program, scenario files and the documentation.")

if(SPOKE_SHARES_ENGINE)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS ${this_library})
endif()

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${runtime_package})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "dynamics of rotors with flexible blades (library)
${what} This package contains the shared library.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libspoke-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "dynamics of rotors with flexible blades (development files)
${what} This package contains what programs that embed Spoke are built with.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
if(BUILD_SHARED_LIBS)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", ${this_library}")
else()
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    ", libspdlog-dev, libtbb-dev (>= 2021), libtomlplusplus-dev, zlib1g-dev")
endif()
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "g++, pkg-config")

# Of the interpreter's versions the one that it was built for, as the module's name says.
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-spoke)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "dynamics of rotors with flexible blades (Python 3)
${what} This package contains the Python module spoke.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3-numpy")
if(TARGET spoke_python)
  get_target_property(minor spoke_python SPOKE_PYTHON_MINOR)
  math(EXPR next_minor "${minor} + 1")
  string(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    ", python3 (>= 3.${minor}), python3 (<< 3.${next_minor})")
endif()
if(SPOKE_SHARES_ENGINE)
  string(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS ", ${this_library}")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, spoke")

# Each Debian package carries the licence under this name; a plain installation need not.
foreach(component program library development python)
  string(TOUPPER ${component} COMPONENT)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
include(CPack)
