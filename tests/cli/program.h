// SPDX-License-Identifier: Apache-2.0
// Runs the program itself, as a user does.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>

#include "harness/quality/quality.h"
#include "harness/record/record.h"
#include "harness/scene/textures.h"
#include "tests/folder.h"

namespace lamina {

struct Outcome {
  int status = -1;
  std::string output;  // standard output and error together
};

inline Outcome lamina_program(const std::string& arguments) {
  const std::string command = std::string(LAMINA_PROGRAM) + " " + arguments + " 2>&1";
  Outcome outcome;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> buffer;
  while (const size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) outcome.output.append(buffer.data(), count);
  const int status = ::pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

class ProgramTest : public InFolder<> {
 protected:
  // A run's folder, and the record there.
  std::filesystem::path out() const { return folder_ / "out"; }
  Record record() const { return read_record(out() / "record.jsonl"); }
  // The picture of a cell as it was written.
  DisplayImage picture(const CellRow& cell) const {
    const Texels texels = load_texels(out() / cell.image, /*srgb_colour=*/true);
    return to_display(image_of(texels));
  }
  // The layered material's baseline and two more, for what is the same with all of its variants.
  static constexpr const char* few_variants = " --variant normal_map_taps --variant vertex_normal";
  // A model that loads in no time: one square, without textures.
  std::string square_model() {
    const float corners[4][8] = {
        {-1, 1, 0, 0, 0, 1, 0, 0}, {1, 1, 0, 0, 0, 1, 1, 0}, {1, -1, 0, 0, 0, 1, 1, 1}, {-1, -1, 0, 0, 0, 1, 0, 1}};
    const uint16_t indices[6] = {0, 2, 1, 0, 3, 2};
    std::string bytes(reinterpret_cast<const char*>(corners), sizeof corners);
    bytes.append(reinterpret_cast<const char*>(indices), sizeof indices);
    write("square.bin", bytes);
    return write("square.gltf",
                 R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"square","mesh":0}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3}]}],
      "buffers":[{"uri":"square.bin","byteLength":140}],
      "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":128,"byteStride":32},{"buffer":0,"byteOffset":128,"byteLength":12}],
      "accessors":[{"bufferView":0,"byteOffset":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]},
                   {"bufferView":0,"byteOffset":12,"componentType":5126,"count":4,"type":"VEC3"},
                   {"bufferView":0,"byteOffset":24,"componentType":5126,"count":4,"type":"VEC2"},
                   {"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}]})")
        .string();
  }
};

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

}  // namespace lamina
