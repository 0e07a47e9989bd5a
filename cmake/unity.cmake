# Sources of a target compiled several at a time: nearly all the time that a source takes to compile goes into headers,
# which one batch parses once. Names of unnamed namespaces must then differ within a target.
option(ETENDUE_UNITY_BUILD "Compile sources several at a time: faster from scratch, slower after one edit" ON)

# Compiles the targets below a folder in batches. A target with an instruction set of its own (ETENDUE_OWN_ISA) is one
# source; a source with options of its own stays alone by CMake's rule.
function(etendue_unity_build folder batch)
  etendue_targets_below(${folder} targets)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(own_isa ${target} ETENDUE_OWN_ISA)
    if(NOT own_isa AND type MATCHES "STATIC_LIBRARY|MODULE_LIBRARY|EXECUTABLE")
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
      # Each source counts as a header then, whose types should not hold types of an unnamed namespace.
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    endif()
  endforeach()
endfunction()
