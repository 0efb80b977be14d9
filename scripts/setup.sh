# SPDX-License-Identifier: Apache-2.0
# Sourced by run and test: installs what is missing from Debian 12's packages, configures and builds a preset.

# name of the package: what it is for
packages=(
  g++ cmake ninja-build ccache mold pkg-config git python3 python3-glad   # building; python3-glad makes the OpenGL loader
  libvulkan-dev mesa-vulkan-drivers vulkan-validationlayers               # Vulkan and lavapipe
  libosmesa6-dev libegl-dev libgl1-mesa-dri                               # OpenGL in memory, and surfaceless
  glslang-dev glslang-tools spirv-tools spirv-headers libspirv-cross-c-shared-dev   # shaders; CMake asks for the tools too
  libopenimageio-dev libopencv-contrib-dev                                # images, metrics
  libtinygltf-dev libdraco-dev libmeshoptimizer-dev                       # models, and what compresses them
  libglm-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libfmt-dev libxxhash-dev
  libembree-dev libtbb-dev                                                # casting rays for bakes and truths
  libboost-dev                                                            # references to hundreds of bits
  libgtest-dev libgmock-dev libbenchmark-dev libxml2-utils python3-yaml time          # tests, benchmarks
)

install_missing_packages() {
  local missing=() name
  command -v npm >/dev/null || packages+=(npm)   # the report's chart library; CMake calls it, once
  for name in "${packages[@]}"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || missing+=("$name")
  done
  [ ${#missing[@]} -eq 0 ] && return
  echo "installing: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "not root and no sudo: install these packages and call again: ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# What tests/browser drives the report's page with; where it cannot be fetched, those tests are skipped and say so.
install_browser_tests() {
  local folder=tests/browser
  [ -e "$folder/node_modules/.package-lock.json" ] && [ ! "$folder/package-lock.json" -nt "$folder/node_modules/.package-lock.json" ] && return
  npm ci --prefix "$folder" --ignore-scripts --no-audit --no-fund --loglevel=error >/dev/null &&
    touch "$folder/node_modules/.package-lock.json" ||
    echo "the browser tests' packages cannot be fetched; those tests will be skipped" >&2
}

# build_preset PRESET [TARGET...]
build_preset() {
  local preset=$1
  shift
  [ -f "build/$preset/build.ninja" ] || cmake --preset "$preset" >/dev/null
  cmake --build --preset "$preset" ${1:+--target "$@"}
}
