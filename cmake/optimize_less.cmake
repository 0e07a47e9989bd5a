# Code without hot loops: a release compiles it at -O1, in two thirds of the time. What an app or a test calls of the
# libraries below stays as fast as it is.
function(etendue_optimize_less)
  foreach(target IN LISTS ARGN)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "LIBRARY|EXECUTABLE" AND NOT type STREQUAL "INTERFACE_LIBRARY")
      target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
  endforeach()
endfunction()
