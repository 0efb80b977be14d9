// SPDX-License-Identifier: Apache-2.0
// Where the program's own data is: variants/ and shaders/.
#pragma once

#include <filesystem>

namespace lamina {

// The folder that LAMINA_HOME in the environment names. Without it, what lies beside the executable: the executable's own
// folder (a build tree, where these are links), or ../share/lamina from there (an installed program). Throws Error(bad_input)
// where it lacks variants/ or shaders/, naming the places.
std::filesystem::path home_folder();

// The same for an executable in `beside`, with LAMINA_HOME as given: null or "" where it is not set.
std::filesystem::path home_folder(const std::filesystem::path& beside, const char* lamina_home);

}  // namespace lamina
