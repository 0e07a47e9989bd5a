# Man pages and shell completions, from the help and the keys that the program prints.
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_Interpreter_FOUND)
  message(STATUS "Man pages and completions are left out: no Python interpreter")
  return()
endif()
set(manual ${PROJECT_BINARY_DIR}/manual)
set(manual_files
  ${manual}/etendue.1 ${manual}/etendue-case.5 ${manual}/etendue.bash ${manual}/_etendue ${manual}/etendue.fish)
add_custom_command(OUTPUT ${manual_files}
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/packaging/write_manual $<TARGET_FILE:etendue> ${manual}
  DEPENDS etendue ${PROJECT_SOURCE_DIR}/packaging/write_manual
  COMMENT "Writing man pages and completions")
add_custom_target(etendue_manual ALL DEPENDS ${manual_files})

install(FILES ${manual}/etendue.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${manual}/etendue-case.5 DESTINATION ${CMAKE_INSTALL_MANDIR}/man5 COMPONENT program)
install(FILES ${manual}/etendue.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME etendue
  COMPONENT program)
install(FILES ${manual}/_etendue DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES ${manual}/etendue.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)

add_test(NAME Manual.HasEveryCommandOptionAndKey
  COMMAND ${PROJECT_SOURCE_DIR}/packaging/check_manual $<TARGET_FILE:etendue> ${manual})
set_tests_properties(Manual.HasEveryCommandOptionAndKey PROPERTIES LABELS unit TIMEOUT 60)
