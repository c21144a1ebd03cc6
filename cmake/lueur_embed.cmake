# lueur_embed(TARGET FILES …) embeds text files into TARGET at build time.
#
# Each file "plot.js" in the folder src/report/page becomes "report/page/plot.js.inc" on the include
# path of TARGET's own sources: one raw string literal, to be included where a literal may stand.
# Run as a script (cmake -P, with INPUT and OUTPUT) this file writes one such literal.

if(CMAKE_SCRIPT_MODE_FILE)
  file(READ "${INPUT}" text)
  string(FIND "${text}" ")lueur\"" end)
  if(NOT end EQUAL -1)
    message(FATAL_ERROR "${INPUT}: may not hold the end mark of the literal that it becomes")
  endif()
  file(WRITE "${OUTPUT}" "R\"lueur(${text})lueur\"\n")
  return()
endif()

set(LUEUR_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(lueur_embed target)
  cmake_parse_arguments(arg "" "" "FILES" ${ARGN})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/src ${CMAKE_CURRENT_SOURCE_DIR})
  set(generated ${PROJECT_BINARY_DIR}/embedded)
  foreach(file ${arg_FILES})
    set(output ${generated}/${folder}/${file}.inc)
    add_custom_command(
      OUTPUT ${output}
      COMMAND ${CMAKE_COMMAND} -DINPUT=${CMAKE_CURRENT_SOURCE_DIR}/${file} -DOUTPUT=${output}
              -P ${LUEUR_EMBED_SCRIPT}
      DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file} ${LUEUR_EMBED_SCRIPT}
      COMMENT "Embedding ${folder}/${file}"
      VERBATIM)
    target_sources(${target} PRIVATE ${output})
  endforeach()
  target_include_directories(${target} PRIVATE ${generated})
endfunction()
