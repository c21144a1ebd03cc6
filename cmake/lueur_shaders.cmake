# lueur_shaders(TARGET FILES …) compiles GLSL with glslc and embeds the SPIR-V into TARGET.
#
# Each file "gather.comp" in the folder src/techniques/hierarchical becomes one constant
#   lueur::shaders::techniques_hierarchical_gather_comp   (gpu::ShaderCode)
# declared in the generated header "techniques/hierarchical/shaders.h". A name that does not exist
# fails to compile, and a shader that nobody names is still compiled, so that it cannot rot.

function(lueur_shaders target)
  cmake_parse_arguments(arg "" "" "FILES" ${ARGN})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/src ${CMAKE_CURRENT_SOURCE_DIR})
  set(generated ${PROJECT_BINARY_DIR}/shaders)
  set(output ${generated}/${folder})
  file(MAKE_DIRECTORY ${output})

  # Made by a script: names follow the files, not the house's style.
  string(CONCAT header "// NOLINTBEGIN\n#pragma once\n#include \"gpu/shader.h\"\n"
         "namespace lueur::shaders {\n")
  string(CONCAT source "// NOLINTBEGIN\n#include \"${folder}/shaders.h\"\n"
         "namespace lueur::shaders {\nnamespace {\n")
  set(definitions "}\n")
  foreach(file ${arg_FILES})
    string(MAKE_C_IDENTIFIER "${folder}_${file}" name)
    set(include ${output}/${file}.inc)
    add_custom_command(
      OUTPUT ${include}
      COMMAND ${GLSLC} --target-env=vulkan1.3 -O -g -Werror -mfmt=c -I${PROJECT_SOURCE_DIR}/src
              -MD -MF ${include}.d -MT ${include} -o ${include} ${CMAKE_CURRENT_SOURCE_DIR}/${file}
      DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file}
      DEPFILE ${include}.d
      COMMENT "Compiling shader ${folder}/${file}"
      VERBATIM)
    list(APPEND includes ${include})
    string(APPEND header "extern const gpu::ShaderCode ${name};\n")
    string(APPEND source "constexpr uint32_t words_${name}[] =\n#include \"${folder}/${file}.inc\"\n;\n")
    string(APPEND definitions "const gpu::ShaderCode ${name}{\"${folder}/${file}\", words_${name}};\n")
  endforeach()
  string(APPEND header "}\n// NOLINTEND\n")
  string(APPEND definitions "}\n// NOLINTEND\n")
  file(CONFIGURE OUTPUT ${output}/shaders.h CONTENT "${header}" @ONLY)
  file(CONFIGURE OUTPUT ${output}/shaders.cpp CONTENT "${source}${definitions}" @ONLY)
  target_sources(${target} PRIVATE ${output}/shaders.cpp ${includes})
  set_source_files_properties(${output}/shaders.cpp PROPERTIES OBJECT_DEPENDS "${includes}")
  target_include_directories(${target} PUBLIC ${generated})
endfunction()
