# IIB_FUZZ: the flags hold for the code under test too: the fuzzer follows its branches, and what it
# finds has a stack. Without NDEBUG, so that Eigen holds its own promises.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
  message(FATAL_ERROR "IIB_FUZZ needs clang's libFuzzer; scripts/check/fuzz configures it")
endif()
set(sanitizers -fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow
  -fno-sanitize-recover=all -fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/ubsan_ignored.txt)
add_compile_options(${sanitizers} -g1 -O2)
add_link_options(${sanitizers})
