# Configures, builds and tests the same sources against ParaView's VTK, in <build>/paraview.
include(ExternalProject)
set(nested_dir "${PROJECT_BINARY_DIR}/paraview")
ExternalProject_Add(RANSMeshingParaView
  DEPENDS Core Surface TetGen BoundaryLayer IO # one after the other: ccache then has the kernel
  SOURCE_DIR "${PROJECT_SOURCE_DIR}"
  BINARY_DIR "${nested_dir}"
  INSTALL_COMMAND ""
  BUILD_ALWAYS ON
  USES_TERMINAL_BUILD ON
  CMAKE_CACHE_ARGS
    -DRANSMESHING_FOR_PARAVIEW:BOOL=ON
    -DRANSMESHING_BUILD_TESTING:BOOL=${RANSMESHING_BUILD_TESTING}
    -DRANSMESHING_PARAVIEW_PREFIX:PATH=${RANSMESHING_PARAVIEW_PREFIX}
    -DRANSMESHING_WARNINGS_AS_ERRORS:BOOL=${RANSMESHING_WARNINGS_AS_ERRORS}
    -DCMAKE_BUILD_TYPE:STRING=${CMAKE_BUILD_TYPE}
    -DCMAKE_INSTALL_PREFIX:PATH=${CMAKE_INSTALL_PREFIX}
    -DPython3_EXECUTABLE:FILEPATH=${Python3_EXECUTABLE})

# Not its component "development": nobody links the plugin's libraries.
foreach(component IN ITEMS runtime Unspecified)
  install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" --install \"${nested_dir}\"
    --component ${component} --prefix \"\${CMAKE_INSTALL_PREFIX}\" COMMAND_ERROR_IS_FATAL ANY)")
endforeach()

if(RANSMESHING_BUILD_TESTING)
  add_test(NAME ParaViewTree
    COMMAND "${CMAKE_CTEST_COMMAND}" --test-dir "${nested_dir}" --output-on-failure --no-tests=error)
  # Two xvfb-run that start at once may choose the same display.
  set_tests_properties(ParaViewTree PROPERTIES LABELS paraview TIMEOUT 900 RESOURCE_LOCK display)
endif()
