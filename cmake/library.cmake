# All rooms as one library for other programs, but for MPI. Its interface is app/api/include.
set(room_objects "")
foreach(folder base mesh solver app)
  etendue_targets_below(${folder} targets)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "STATIC_LIBRARY|OBJECT_LIBRARY" AND NOT target STREQUAL "etendue_rank_session")
      list(APPEND room_objects $<TARGET_OBJECTS:${target}>)
    endif()
  endforeach()
endforeach()

# What a program that links the static library needs beside it.
set(ETENDUE_LIBRARIES_BESIDE
  fmt::fmt VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel VTK::CommonMath VTK::CommonMisc
  VTK::FiltersGeneral VTK::IOGeometry VTK::IOImage VTK::IOXML OpenEXR::OpenEXR PNG::PNG OpenMP::OpenMP_CXX)
set(ETENDUE_NAMES_BESIDE tomlplusplus muparser tet embree3 mpfr gmp)

add_library(etendue_library STATIC ${room_objects})
target_link_libraries(etendue_library INTERFACE ${ETENDUE_LIBRARIES_BESIDE} ${ETENDUE_NAMES_BESIDE})
target_include_directories(etendue_library INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/app/api/include> $<INSTALL_INTERFACE:include>)
target_compile_features(etendue_library INTERFACE cxx_std_20)
set_target_properties(etendue_library PROPERTIES
  OUTPUT_NAME etendue EXPORT_NAME etendue LINKER_LANGUAGE CXX)
