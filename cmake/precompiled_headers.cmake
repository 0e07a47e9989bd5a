# One precompiled header for the libraries and the program, another for the tests: standard library, Eigen, fmt, and
# GoogleTest are parsed once, which halves the time that most sources take to compile.
option(ETENDUE_PRECOMPILE_HEADERS "Parse the headers of libraries once" ON)

# Definitions and flags that change what a header means must be the same for all who read it parsed.
add_library(etendue_header_flags INTERFACE)
target_link_libraries(etendue_header_flags INTERFACE etendue_options Eigen3::Eigen fmt::fmt OpenMP::OpenMP_CXX)
# GCC 12 forgets that a precompiled header comes from the system, and warns of copies in std::string + "literal" that
# have no end (GCC bug 105651). The address sanitizer watches real ones.
target_compile_options(etendue_header_flags INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>)
add_library(etendue_test_header_flags INTERFACE)
target_link_libraries(etendue_test_header_flags INTERFACE etendue_header_flags)
target_compile_definitions(etendue_test_header_flags INTERFACE GTEST_HAS_PTHREAD=1)  # as GoogleTest's target does

# A precompiled header that all who link `flags` can read.
function(etendue_precompiled_header name flags)
  file(WRITE ${PROJECT_BINARY_DIR}/${name}.cpp "")
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE ${flags})
  target_precompile_headers(${name} PRIVATE ${ARGN})
  # The bytes of a precompiled header depend on where the checkout lies; ccache knows it by these versions instead.
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/CMakeFiles/${name}.dir/cmake_pch.hxx.gch.sum
       CONTENT "${ARGN} ${CMAKE_CXX_COMPILER_VERSION} ${Eigen3_VERSION} ${fmt_VERSION} ${GTest_VERSION}\n")
endfunction()

# Lets every compiled target below a folder read a precompiled header. Targets with instruction sets of their own
# (ETENDUE_OWN_ISA), with CGAL's rounding, or with the language standard of VTK and OpenEXR cannot.
function(etendue_use_precompiled_header name flags folder)
  etendue_targets_below(${folder} targets)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(own_isa ${target} ETENDUE_OWN_ISA)
    get_target_property(libraries ${target} LINK_LIBRARIES)
    if(own_isa OR libraries MATCHES "CGAL::|VTK::|OpenEXR::" OR NOT type MATCHES "STATIC_LIBRARY|EXECUTABLE")
      continue()
    endif()
    target_link_libraries(${target} PRIVATE ${flags})
    target_precompile_headers(${target} REUSE_FROM ${name})
  endforeach()
endfunction()
