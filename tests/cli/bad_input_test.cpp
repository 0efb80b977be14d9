// SPDX-License-Identifier: Apache-2.0
// Bad input gets one clear message and the right exit status: 2 for what the user gave, 4 where there is no device.
#include "tests/cli/program.h"

namespace lamina {
namespace {

using BadInput = ProgramTest;

TEST_F(BadInput, MissingScene) {
  const Outcome outcome = lamina_program("compare /no/such/model.glb");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_SAYS(outcome.output, "/no/such/model.glb");
}

TEST_F(BadInput, UnknownBuiltinScene) {
  const Outcome outcome = lamina_program("plan haert");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_SAYS(outcome.output, "heart");
}

TEST_F(BadInput, TruncatedModel) {
  const auto file = write("cut.glb", std::string("glTF\x02\x00\x00\x00\xff\x00\x00\x00", 12));
  const Outcome outcome = lamina_program("compare " + file.string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_SAYS(outcome.output, "cut.glb");
}

TEST_F(BadInput, UnknownKeyInScene) {
  square_model();
  const auto file = write("scene.toml", "[scene]\nmodel = \"square.gltf\"\n[objects.square]\ntickness = 3\n");
  const Outcome outcome = lamina_program("compare " + file.string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_SAYS(outcome.output, "scene.toml:4");
  EXPECT_SAYS(outcome.output, "did you mean 'thickness'?");
}

TEST_F(BadInput, Sizes) {
  for (const std::string size : {"0x0", "512x0", "100000x100000", "-1x5", "512", "512x512x3", "axb"}) {
    const Outcome outcome = lamina_program("compare " + square_model() + " --size=" + size);
    EXPECT_EQ(outcome.status, 2) << size;
    EXPECT_SAYS(outcome.output, "--size");
  }
}

TEST_F(BadInput, SizeBeyondTheDevice) {
  const Outcome outcome = lamina_program("compare " + square_model() + " --size 60000x8 --out " + (folder_ / "out").string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_SAYS(outcome.output, "60000x8 is larger than");
}

TEST_F(BadInput, NoSuchDevice) {
  const Outcome outcome =
      lamina_program("compare " + square_model() + " --backend vulkan --device nonesuch --out " + (folder_ / "out").string());
  EXPECT_EQ(outcome.status, 4);
  EXPECT_SAYS(outcome.output, "nonesuch");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(BadInput, UnknownBackendVariantAndOption) {
  EXPECT_EQ(lamina_program("compare " + square_model() + " --backend vulcan").status, 2);
  const Outcome outcome = lamina_program("compare " + square_model() + " --variant vertex_norml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_SAYS(outcome.output, "did you mean 'vertex_normal'?");
  EXPECT_EQ(lamina_program("compare " + square_model() + " --nonsense").status, 2);
  EXPECT_EQ(lamina_program("").status, 2);
}

TEST_F(BadInput, UnwritableFolder) {
  write("file", "in the way");
  const Outcome outcome =
      lamina_program("compare " + square_model() + " --backend vulkan --out " + (folder_ / "file" / "out").string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_SAYS(outcome.output, "--out");
}

TEST_F(BadInput, NotARecord) {
  write("record.jsonl", "{\"kind\":\"cell\"}\n");
  const Outcome outcome = lamina_program("report " + folder_.string());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_SAYS(outcome.output, "record.jsonl:1");
}

// Fog that cannot be: one message each, with file and line.
TEST_F(BadInput, Fog) {
  square_model();
  const auto plan = [&](const std::string& rest) {
    const auto file = write("scene.toml", "[scene]\nmodel = \"square.gltf\"\n" + rest);
    const Outcome outcome = lamina_program("plan " + file.string());
    EXPECT_EQ(outcome.status, 2) << rest;
    return outcome.output;
  };
  EXPECT_SAYS(plan("[objects.square.fog]\n"), "volume_fog needs a closed hull, and its mesh is open");
  EXPECT_SAYS(plan("[effects.volume_fog]\ndensity = -1\n"), "scene.toml:4");
  EXPECT_SAYS(plan("[objects.square.fog]\nshare = 1.5\n"), "scene.toml:4");
  EXPECT_SAYS(plan("[objects.square.fog]\nvolume = \"hloe\"\n"), "did you mean 'hole'?");
  EXPECT_SAYS(plan("[effects.volume_fog]\nreach = -2\n"), "scene.toml:4");
}

// Two Vulkan devices of one name: the same driver, found twice.
TEST_F(BadInput, PartOfTwoDevicesNames) {
  std::filesystem::path driver;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/usr/share/vulkan/icd.d", none))
    if (entry.path().filename().string().starts_with("lvp_icd")) driver = entry.path();
  if (driver.empty()) GTEST_SKIP() << "lavapipe's driver file is not in /usr/share/vulkan/icd.d";
  std::filesystem::copy_file(driver, folder_ / "again.json", std::filesystem::copy_options::overwrite_existing);
  ::setenv("VK_ICD_FILENAMES", (driver.string() + ":" + (folder_ / "again.json").string()).c_str(), 1);
  const std::string compare = "compare heart --size 16x16 --backend vulkan --out " + out().string() + " --device ";
  const Outcome both = lamina_program(compare + "llvmpipe");
  const Outcome none_of_them = lamina_program(compare + "geforce");
  ::unsetenv("VK_ICD_FILENAMES");
  EXPECT_EQ(both.status, 2);
  EXPECT_SAYS(both.output, "2 devices have this in their names");
  EXPECT_SAYS(both.output, "1: llvmpipe");
  EXPECT_EQ(none_of_them.status, 4);
}

TEST_F(BadInput, ListSaysWhatDevicesCan) {
  const Outcome list = lamina_program("list");
  EXPECT_EQ(list.status, 0);
  EXPECT_SAYS(list.output, "storage in fragment shaders");
  EXPECT_SAYS(list.output, "timestamps of ");
  const auto json = nlohmann::json::parse(lamina_program("list --json").output);
  for (const nlohmann::json& backend : json.at("backends"))
    for (const nlohmann::json& device : backend.at("devices")) EXPECT_GT(device.at("timestamp_bits"), 0) << device;
  EXPECT_GT(json.at("parameters").size(), 20u);
  EXPECT_GT(json.at("effects").size(), 8u);
}

TEST_F(BadInput, HelpAndVersionAreNotErrors) {
  EXPECT_EQ(lamina_program("--help").status, 0);
  EXPECT_EQ(lamina_program("compare --help").status, 0);
  EXPECT_EQ(lamina_program("--version").status, 0);
}

}  // namespace
}  // namespace lamina
