# Every library and tool that the build takes from the system, each as one target:
#
#   Vulkan::Headers volk vma spirv_cross      the GPU side; glslc itself is the program ${GLSLC}
#   embree xxhash                             the reference
#   openexr PNG::PNG turbojpeg                pictures
#   ZLIB::ZLIB                                pictures within pages
#   meshoptimizer::meshoptimizer              compressed geometry
#   glm::glm nlohmann_json::nlohmann_json CLI11::CLI11 Threads::Threads
#   GTest::gtest GTest::gtest_main            tests only
#
# One that is missing stops the configuration with one line that names its Debian package.

function(lueur_missing what package)
  message(FATAL_ERROR "${what} is missing: run `./run setup`, or install the package ${package}.")
endfunction()

# Finds a CMake package quietly; `package` is the Debian package to name when there is none.
macro(lueur_find name target package)
  find_package(${name} QUIET ${ARGN})
  if(NOT TARGET ${target})
    lueur_missing(${name} ${package})
  endif()
endmacro()

# Makes the INTERFACE target `target` from the pkg-config module `module`.
function(lueur_find_module target module package)
  pkg_check_modules(${target} QUIET IMPORTED_TARGET ${module})
  if(NOT TARGET PkgConfig::${target})
    lueur_missing(${module} ${package})
  endif()
  add_library(${target} INTERFACE)
  target_link_libraries(${target} INTERFACE PkgConfig::${target})
endfunction()

find_program(LUEUR_CCACHE ccache)
mark_as_advanced(LUEUR_CCACHE)
if(LUEUR_CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${LUEUR_CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${LUEUR_CCACHE})
endif()

find_package(PkgConfig QUIET)
if(NOT PKG_CONFIG_FOUND)
  lueur_missing(pkg-config pkg-config)
endif()
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)

# Shaders are compiled by glslc and their interface is read back by SPIRV-Cross.
find_program(GLSLC glslc)
if(NOT GLSLC)
  lueur_missing(glslc glslc)
endif()
lueur_find_module(spirv_cross spirv-cross-c-shared libspirv-cross-c-shared-dev)

# Vulkan is loaded at run time through volk, so nothing links libvulkan.
lueur_find(VulkanHeaders Vulkan::Headers libvulkan-dev CONFIG)
find_path(LUEUR_VOLK_FOLDER volk.c)
mark_as_advanced(LUEUR_VOLK_FOLDER)
if(NOT LUEUR_VOLK_FOLDER)
  lueur_missing(volk libvulkan-volk-dev)
endif()
add_library(volk STATIC ${LUEUR_VOLK_FOLDER}/volk.c)
target_include_directories(volk SYSTEM PUBLIC ${LUEUR_VOLK_FOLDER})
target_compile_definitions(volk PUBLIC VK_NO_PROTOTYPES)
target_link_libraries(volk PUBLIC Vulkan::Headers ${CMAKE_DL_LIBS})

# Debian 12 does not package VMA; `./run setup` then leaves its header in .deps/include.
find_path(LUEUR_VMA_FOLDER vk_mem_alloc.h HINTS ${PROJECT_SOURCE_DIR}/.deps/include)
mark_as_advanced(LUEUR_VMA_FOLDER)
if(NOT LUEUR_VMA_FOLDER)
  lueur_missing("The Vulkan Memory Allocator" libvulkan-memory-allocator-dev)
endif()
add_library(vma INTERFACE)
target_include_directories(vma SYSTEM INTERFACE ${LUEUR_VMA_FOLDER})
target_link_libraries(vma INTERFACE volk)

# Rays on the CPU, and hashes of what was rendered.
lueur_find(embree embree libembree-dev CONFIG)
lueur_find_module(xxhash libxxhash libxxhash-dev)

# Pictures.
lueur_find_module(openexr OpenEXR libopenexr-dev)
lueur_find(PNG PNG::PNG libpng-dev)
lueur_find(ZLIB ZLIB::ZLIB zlib1g-dev)
lueur_find_module(turbojpeg libturbojpeg libturbojpeg0-dev)

# Depth runs from 0 to 1 in Vulkan, and angles are radians: every user of glm must agree on both.
lueur_find(glm glm::glm libglm-dev CONFIG)
set_property(TARGET glm::glm APPEND PROPERTY INTERFACE_COMPILE_DEFINITIONS
             GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_FORCE_RADIANS GLM_ENABLE_EXPERIMENTAL)
lueur_find(meshoptimizer meshoptimizer::meshoptimizer libmeshoptimizer-dev CONFIG)
lueur_find(nlohmann_json nlohmann_json::nlohmann_json nlohmann-json3-dev CONFIG)
lueur_find(CLI11 CLI11::CLI11 libcli11-dev CONFIG)
if(LUEUR_TESTS)
  lueur_find(GTest GTest::gtest_main libgtest-dev)
endif()
