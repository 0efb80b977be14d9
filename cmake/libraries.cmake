# SPDX-License-Identifier: Apache-2.0
# Debian's libraries, each behind one name. Headers are system headers: their warnings are not ours.
find_package(PkgConfig REQUIRED)
find_package(fmt REQUIRED)
find_package(Threads REQUIRED)
find_package(Python3 COMPONENTS Interpreter)

add_library(lib_glm INTERFACE)
target_compile_definitions(lib_glm INTERFACE GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_FORCE_RADIANS)

# OpenImageIO's own configuration asks for Python bindings that are not needed here.
find_library(OPENIMAGEIO OpenImageIO REQUIRED)
find_library(OPENIMAGEIO_UTIL OpenImageIO_Util REQUIRED)
find_path(IMATH_INCLUDE half.h PATH_SUFFIXES Imath REQUIRED)
add_library(lib_images INTERFACE)
target_include_directories(lib_images SYSTEM INTERFACE ${IMATH_INCLUDE})
target_link_libraries(lib_images INTERFACE ${OPENIMAGEIO} ${OPENIMAGEIO_UTIL})

add_library(lib_gltf INTERFACE)
find_library(DRACO draco REQUIRED)
find_library(MESHOPTIMIZER meshoptimizer REQUIRED)
target_link_libraries(lib_gltf INTERFACE tinygltf ${DRACO} ${MESHOPTIMIZER})

find_package(embree 3 REQUIRED)
find_package(TBB REQUIRED)
add_library(lib_embree INTERFACE)
target_link_libraries(lib_embree INTERFACE embree TBB::tbb)

find_package(tomlplusplus REQUIRED)
add_library(lib_toml INTERFACE)
target_link_libraries(lib_toml INTERFACE tomlplusplus::tomlplusplus)

find_package(Vulkan REQUIRED)
add_library(lib_vulkan INTERFACE)
target_link_libraries(lib_vulkan INTERFACE Vulkan::Vulkan)

# OpenGL's entry points come from a loader that glad makes at build time, so that OSMesa and EGL can each bring their own.
find_library(OSMESA_LIBRARY OSMesa REQUIRED)
find_library(EGL_LIBRARY EGL REQUIRED)
set(GLAD_DIR ${CMAKE_BINARY_DIR}/glad)
add_custom_command(
  OUTPUT ${GLAD_DIR}/src/gl.c ${GLAD_DIR}/include/glad/gl.h
  COMMAND /usr/bin/python3 -m glad --quiet --reproducible --out-path ${GLAD_DIR} --api gl:core=4.5
          --extensions GL_ARB_gl_spirv,GL_KHR_debug c
  COMMENT "Generating the OpenGL loader")
add_library(lamina_glad STATIC ${GLAD_DIR}/src/gl.c)
target_include_directories(lamina_glad SYSTEM PUBLIC ${GLAD_DIR}/include)
add_library(lib_opengl INTERFACE)
target_link_libraries(lib_opengl INTERFACE lamina_glad ${OSMESA_LIBRARY} ${EGL_LIBRARY})

find_package(glslang REQUIRED)
find_package(SPIRV-Tools REQUIRED)
find_package(SPIRV-Tools-opt REQUIRED)
pkg_check_modules(SPIRV_CROSS REQUIRED IMPORTED_TARGET spirv-cross-c-shared)
add_library(lib_spirv INTERFACE)
target_link_libraries(lib_spirv INTERFACE glslang::glslang glslang::SPIRV glslang::glslang-default-resource-limits
  SPIRV-Tools-opt SPIRV-Tools-static PkgConfig::SPIRV_CROSS)
# Debian builds glslang without run-time type information, which the sanitizer's check of virtual tables would link against.
set_source_files_properties(${PROJECT_SOURCE_DIR}/harness/shader/compile.cpp PROPERTIES COMPILE_OPTIONS -fno-sanitize=vptr)

# Debian's OpenCVConfig.cmake comes only with the whole of OpenCV; three of its libraries are all that is needed here.
add_library(lib_opencv INTERFACE)
find_path(OPENCV_INCLUDE opencv2/quality.hpp PATH_SUFFIXES opencv4 REQUIRED)
target_include_directories(lib_opencv SYSTEM INTERFACE ${OPENCV_INCLUDE})
foreach(module core imgproc quality)
  find_library(OPENCV_${module} opencv_${module} REQUIRED)
  target_link_libraries(lib_opencv INTERFACE ${OPENCV_${module}})
endforeach()

find_package(nlohmann_json REQUIRED)
add_library(lib_json INTERFACE)
target_link_libraries(lib_json INTERFACE nlohmann_json::nlohmann_json)

find_package(CLI11 REQUIRED)
add_library(lib_cli INTERFACE)
target_link_libraries(lib_cli INTERFACE CLI11::CLI11)

find_package(GTest REQUIRED)

# Asks SPIR-V's header for code that other files do not want, so it is compiled by itself.
set_source_files_properties(${PROJECT_SOURCE_DIR}/harness/shader/spirv_module.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
