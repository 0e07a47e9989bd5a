# cmake --install BUILD [--component NAME]: program, development.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS etendue RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(TARGETS etendue_library EXPORT etendue-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/app/api/include/etendue
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN "*.h")

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/etendue)
install(EXPORT etendue-targets NAMESPACE etendue:: DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/etendue-config.cmake.in
  ${PROJECT_BINARY_DIR}/etendue-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/etendue-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/etendue-config.cmake ${PROJECT_BINARY_DIR}/etendue-config-version.cmake
  DESTINATION ${package_folder} COMPONENT development)

# The libraries beside this one, which is static.
set(PC_LIBRARIES "")
foreach(library IN LISTS ETENDUE_LIBRARIES_BESIDE)
  if(library STREQUAL "OpenMP::OpenMP_CXX")
    string(APPEND PC_LIBRARIES " ${OpenMP_CXX_FLAGS}")
  elseif(library STREQUAL "OpenEXR::OpenEXR")
    string(APPEND PC_LIBRARIES " -lOpenEXR")
  else()
    string(APPEND PC_LIBRARIES " $<TARGET_LINKER_FILE:${library}>")
  endif()
endforeach()
foreach(name IN LISTS ETENDUE_NAMES_BESIDE)
  string(APPEND PC_LIBRARIES " -l${name}")
endforeach()
# The prefix, from the folder of the file: the installed tree may be moved.
file(RELATIVE_PATH PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/etendue.pc.in ${PROJECT_BINARY_DIR}/etendue.pc.in @ONLY)
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/etendue.pc INPUT ${PROJECT_BINARY_DIR}/etendue.pc.in)
install(FILES ${PROJECT_BINARY_DIR}/etendue.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
