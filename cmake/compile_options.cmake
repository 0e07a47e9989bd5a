# Warnings for our own code, the one floating-point contract, and the sanitizers.
# Everything of ours links etendue_options; nothing else does.
add_library(etendue_options INTERFACE)
target_include_directories(etendue_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(etendue_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  # GCC 12 sees overlapping copies in std::string + "literal" where there are none (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # The same bits on every machine and for every number of threads: no contraction to fused
  # multiply-add behind our back, no value-changing optimisation.
  -ffp-contract=off)

# Baseline of a packaged build; the kernels choose wider instruction sets at run time.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  # (a target with instruction-set flags of its own sets ETENDUE_OWN_ISA: the last -march would win).
  target_compile_options(etendue_options INTERFACE
    $<$<AND:$<CONFIG:Release>,$<NOT:$<BOOL:$<TARGET_PROPERTY:ETENDUE_OWN_ISA>>>>:-march=x86-64-v2>)
endif()

if(ETENDUE_WERROR)
  target_compile_options(etendue_options INTERFACE -Werror)
endif()

if(ETENDUE_SANITIZE)
  # The address sanitizer sees what null pointers, wrong sizes and pointers that overflow lead to; to check each
  # of them costs a quarter of the time to compile. Divisions of floating-point numbers by zero are left out: 1/0 is
  # meant, as a slope of a jump or a distance that any other is below.
  target_compile_options(etendue_options INTERFACE -fsanitize=address,undefined,float-cast-overflow
                         -fno-sanitize-recover=all -fno-sanitize=null,object-size,pointer-overflow,alignment,vptr
                         -fno-omit-frame-pointer)
  target_link_options(etendue_options INTERFACE -fsanitize=address,undefined)
endif()
if(ETENDUE_SANITIZE_THREADS)
  target_compile_options(etendue_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(etendue_options INTERFACE -fsanitize=thread)
endif()
if(ETENDUE_FUZZ)
  # libFuzzer follows the branches of all our code; what its inputs do wrong the other two find.
  target_compile_options(etendue_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(etendue_options INTERFACE -fsanitize=address,undefined)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
