# Writes OUTPUT from TEMPLATE with the commit of the checkout SOURCE; a file that would stay the same keeps its date, so
# that nothing is compiled or linked again. "-modified" follows where tracked files differ from the commit.
find_package(Git QUIET)
set(ETENDUE_COMMIT "unknown")
if(GIT_FOUND AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --abbrev=40 --match= --dirty=-modified
    WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE
    RESULT_VARIABLE fault ERROR_QUIET)
  if(fault EQUAL 0)
    set(ETENDUE_COMMIT ${described})
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
