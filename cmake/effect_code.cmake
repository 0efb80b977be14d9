# SPDX-License-Identifier: Apache-2.0
# The C++ of effects: every folder of harness/effects is compiled, and a generated file calls its add_FOLDER().
file(GLOB effect_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/harness/effects/*/*.cpp)
set(effect_folders "")
foreach(source ${effect_sources})
  cmake_path(GET source PARENT_PATH folder)
  cmake_path(GET folder FILENAME folder)
  list(APPEND effect_folders ${folder})
  set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
endforeach()
list(REMOVE_DUPLICATES effect_folders)
set(effect_declarations "")
set(effect_calls "")
foreach(folder ${effect_folders})
  string(APPEND effect_declarations "void add_${folder}(EffectCode& code);\n")
  string(APPEND effect_calls "    add_${folder}(made);\n")
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/effect_code.cpp @ONLY CONTENT [[
// SPDX-License-Identifier: Apache-2.0
#include "harness/manifest/effect_code.h"
namespace lamina {
@effect_declarations@
const EffectCode& effect_code() {
  static const EffectCode code = [] {
    EffectCode made;
@effect_calls@    return made;
  }();
  return code;
}
}
]])
add_library(lamina_effects STATIC ${effect_sources} ${PROJECT_BINARY_DIR}/generated/effect_code.cpp)
# Effects do not know each other, so neither do their names: files are joined within a folder alone.
set_target_properties(lamina_effects PROPERTIES UNITY_BUILD_MODE GROUP)
