# lueur_library(NAME SOURCES … [PUBLIC …] [PRIVATE …] [HEADERS …]) makes the static library of one
# folder. HEADERS are precompiled for it alone: for headers that are slow and that most of its files
# include, or where it is compiled with other options than the house.
# lueur_test(NAME SOURCES … LINK … [LABELS …]) makes one GoogleTest program beside it.
# lueur_node_test(NAME COMMAND SCRIPT [ARGUMENTS…] LABELS …) makes a test that node runs. It skips
# itself where what it needs is missing, which `./run test` brings.
# The first two carry the warnings and sanitizers of the whole house.

add_library(lueur_options INTERFACE)
target_compile_options(lueur_options INTERFACE -Wall -Wextra -Wshadow -Wundef -Wconversion
                       -Wno-sign-conversion -Wno-missing-field-initializers
                       -Werror)
# GCC 12 warns of std::string's own code (GCC bug 105329), and forgets with precompiled headers that it
# is the system's.
target_compile_options(lueur_options INTERFACE
                       $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow>)
if(LUEUR_SANITIZE)
  string(REPLACE ";" "," _sanitizers "${LUEUR_SANITIZE}")
  target_compile_options(lueur_options INTERFACE -fsanitize=${_sanitizers}
                         -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(lueur_options INTERFACE -fsanitize=${_sanitizers})
endif()

# Headers that most files need, precompiled once for all libraries and once for all tests: reading them
# anew takes longer than most files do. A file still includes what it uses: `./run lint` builds without.
set(LUEUR_COMMON_HEADERS <algorithm> <array> <filesystem> <functional> <map> <memory> <optional> <span>
    <string> <string_view> <utility> <variant> <vector> <glm/glm.hpp>)

# lueur_precompiled(NAME LINK … OPTIONS … HEADERS …) makes the target whose headers others reuse.
function(lueur_precompiled name)
  cmake_parse_arguments(arg "" "" "LINK;OPTIONS;HEADERS" ${ARGN})
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "" @ONLY)
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE ${arg_LINK} glm::glm lueur_options)
  target_compile_options(${name} PRIVATE ${arg_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS} ${LUEUR_COMMON_HEADERS})
endfunction()

function(lueur_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE;HEADERS" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} glm::glm lueur_options)
  target_compile_options(${name} PRIVATE -pthread)
  if(arg_HEADERS)
    target_precompile_headers(${name} PRIVATE ${arg_HEADERS} ${LUEUR_COMMON_HEADERS})
    return()
  endif()
  if(NOT TARGET lueur_headers)
    lueur_precompiled(lueur_headers OPTIONS -pthread)
  endif()
  target_precompile_headers(${name} REUSE_FROM lueur_headers)
endfunction()

function(lueur_test name)
  if(NOT LUEUR_TESTS)
    return()
  endif()
  cmake_parse_arguments(arg "" "" "SOURCES;LINK;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gtest GTest::gtest_main glm::glm
                        lueur_options)
  # Tests are compiled more often than they run: -O1 takes four fifths of the time of -O2.
  set(options -pthread $<$<CONFIG:Release>:-O1>)
  target_compile_options(${name} PRIVATE ${options})
  if(NOT TARGET lueur_test_headers)
    lueur_precompiled(lueur_test_headers LINK GTest::gtest OPTIONS ${options} HEADERS <gtest/gtest.h>)
  endif()
  target_precompile_headers(${name} REUSE_FROM lueur_test_headers)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT 600)
  # Vulkan drivers are unloaded with memory still held, which the leak checker can neither name nor
  # leave out; tests without a device keep it.
  if("address" IN_LIST LUEUR_SANITIZE AND arg_LABELS MATCHES "gpu|golden|program")
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "ASAN_OPTIONS=detect_leaks=0")
  endif()
endfunction()

function(lueur_node_test name)
  cmake_parse_arguments(arg "" "" "COMMAND;LABELS" ${ARGN})
  find_program(LUEUR_NODE node)
  mark_as_advanced(LUEUR_NODE)
  if(NOT LUEUR_NODE)
    message(STATUS "node is missing: ${name} is left out")
    return()
  endif()
  add_test(NAME ${name} COMMAND ${LUEUR_NODE} ${arg_COMMAND})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT 300 SKIP_RETURN_CODE 77)
endfunction()
