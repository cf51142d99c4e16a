# IIB_INSTRUMENT: the build that watches. The flags hold for every target, as a sanitizer has to see all of a program.
set(IIB_INSTRUMENT "" CACHE STRING "What watches the program: address (with undefined behaviour), thread, coverage, coverage-ros")
set_property(CACHE IIB_INSTRUMENT PROPERTY STRINGS "" address thread coverage coverage-ros)

if(IIB_INSTRUMENT STREQUAL "address")
  # Locals on the heap, which catch the use of one after its function has returned, cost a fifth of
  # the time, and compilers warn of it.
  # float-cast-overflow is not part of undefined, but is how a wild position becomes a cell key.
  # The counters of branches are for the fuzzers of test/fuzz, which share this build.
  set(flags -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all
    -fsanitize-coverage=inline-8bit-counters,pc-table -fsanitize-address-use-after-return=never
    -fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/ubsan_ignored.txt)
  add_compile_definitions(_GLIBCXX_ASSERTIONS IIB_SANITIZED)
elseif(IIB_INSTRUMENT STREQUAL "thread")
  set(flags -fsanitize=thread -fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/tsan_ignored.txt)
  add_compile_definitions(IIB_SANITIZED)
elseif(IIB_INSTRUMENT STREQUAL "coverage")
  # Counters of loops that run on several threads would lose counts without atomic.
  set(flags --coverage -fprofile-update=atomic)
elseif(IIB_INSTRUMENT STREQUAL "coverage-ros")
  # Only src/ros counts: a core that counts would be too slow for the limits of time of the tests with a master.
  add_link_options(--coverage)
elseif(IIB_INSTRUMENT)
  message(FATAL_ERROR
    "IIB_INSTRUMENT is ${IIB_INSTRUMENT}; it may be address, thread, coverage, coverage-ros or empty")
endif()
set(IIB_TEST_PATIENCE_S 60)  # until a test counts as hanging
if(flags)
  set(IIB_TEST_PATIENCE_S 600)
  add_compile_options(${flags} -g1 -fno-omit-frame-pointer)
  add_link_options(${flags})
endif()
