# Language, build type, output folders and warnings: what holds for every target.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Another python3 may stand before the system's on PATH, but VTK's modules are the system's.
if(EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that VTK was wrapped for")
endif()

# The nested tree compiles the kernel once more: ccache, where there is one, makes that free.
find_program(RANSMESHING_CCACHE ccache)
mark_as_advanced(RANSMESHING_CCACHE)
if(RANSMESHING_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${RANSMESHING_CCACHE}")
endif()

# Build tree and install tree have one layout, so that what is found relative to a library (the
# worker program) is found in both.
set(CMAKE_INSTALL_LIBDIR lib CACHE PATH "Libraries")
include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
# From a library, from a program in bin, from lib/python3/dist-packages/ransmeshing.
set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../${CMAKE_INSTALL_LIBDIR};$ORIGIN/../../..")
set(RANSMESHING_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/RANSMeshing")
set(RANSMESHING_PYTHON_DIR "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages")
if(RANSMESHING_FOR_PARAVIEW) # the modules lie in lib/paraview-5.11/plugins/RANSMeshing
  set(RANSMESHING_WORKER_FROM_LIBRARY "../../../../${CMAKE_INSTALL_BINDIR}/ransmesh-tetgen-worker")
else()
  set(RANSMESHING_WORKER_FROM_LIBRARY "../${CMAKE_INSTALL_BINDIR}/ransmesh-tetgen-worker")
endif()

option(RANSMESHING_WARNINGS_AS_ERRORS "Compiler warnings are errors" OFF)
set(RANSMESHING_WARNINGS -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND RANSMESHING_WARNINGS -Wno-restrict) # wrong about std::string + (GCC bug 105329)
endif()
if(RANSMESHING_WARNINGS_AS_ERRORS)
  list(APPEND RANSMESHING_WARNINGS -Werror)
endif()

set(RANSMESHING_SANITIZERS "" CACHE STRING "Sanitizers, for example address,undefined")
if(RANSMESHING_SANITIZERS)
  add_compile_options(-fsanitize=${RANSMESHING_SANITIZERS} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${RANSMESHING_SANITIZERS})
endif()
