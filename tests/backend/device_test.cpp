// SPDX-License-Identifier: Apache-2.0
// Opening, choosing and describing devices, and what a backend refuses.
#include "tests/backend/rig.h"

namespace lamina {
namespace {

using BackendDevice = BackendTest;
LAMINA_ON_EVERY_BACKEND(BackendDevice);

TEST(BackendNames, AtLeastOneBackendOpensHere) {
  size_t devices = 0;
  for (const std::string_view name : backend_names()) devices += survey_devices(name).usable.size();
  EXPECT_GT(devices, 0u);
}

TEST(BackendNames, UnknownBackendIsNamedWithItsNearest) {
  const Error error = error_of([] { open_backend("vulcan"); });
  EXPECT_EQ(error.kind(), ErrorKind::bad_input);
  EXPECT_NE(error.message().find("vulkan"), std::string::npos) << error.what();
}

TEST_P(BackendDevice, InfoIsFilled) {
  const DeviceInfo& info = backend().info();
  EXPECT_EQ(info.backend, GetParam());
  EXPECT_EQ(info.api, GetParam() == "vulkan" ? Api::vulkan : Api::opengl);
  EXPECT_FALSE(info.device.empty());
  EXPECT_FALSE(info.driver.empty());
  EXPECT_FALSE(info.api_version.empty());
  EXPECT_GE(info.max_texture_size, 4096u);  // the least that Vulkan 1.3 allows; OpenGL 4.5 asks for 16384
}

TEST_P(BackendDevice, ListHoldsTheDeviceThatOpensByItsIndexAndPartOfItsName) {
  const std::string opened = backend().info().device;
  close();
  const std::vector<DeviceInfo> devices = survey_devices(GetParam()).usable;
  bool listed = false;
  for (size_t i = 0; i < devices.size(); ++i) {
    listed = listed || devices[i].device == opened;
    EXPECT_EQ(open_backend(GetParam(), {.device = std::to_string(i)})->info().device, devices[i].device);
  }
  EXPECT_TRUE(listed) << opened;
  std::string shouted = opened.substr(1, 5);
  std::transform(shouted.begin(), shouted.end(), shouted.begin(), [](unsigned char c) { return std::toupper(c); });
  EXPECT_EQ(open_backend(GetParam(), {.device = shouted})->info().device, opened);
}

TEST_P(BackendDevice, UnknownDeviceIsAnErrorThatListsWhatThereIs) {
  const std::string there = backend().info().device;
  close();
  for (const std::string wanted : {"no such device", "4711"}) {
    const Error error = error_of([&] { open_backend(GetParam(), {.device = wanted}); });
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
    EXPECT_NE(error.message().find(there), std::string::npos) << error.what();
  }
}

TEST_P(BackendDevice, TexturesThatCannotBeAreRefused) {
  const uint32_t most = backend().info().max_texture_size;
  const auto kind_of = [&](const TextureDesc& desc, std::vector<std::vector<std::byte>> levels = {}) {
    return error_of([&] { backend().create_texture(desc, levels); }).kind();
  };
  EXPECT_EQ(kind_of({.name = "no size", .width = 0, .height = 0}), ErrorKind::bad_input);
  EXPECT_EQ(kind_of({.name = "no width", .width = 0, .height = 4}), ErrorKind::bad_input);
  EXPECT_EQ(kind_of({.name = "no height", .width = 4, .height = 0}), ErrorKind::bad_input);
  EXPECT_EQ(kind_of({.name = "too wide", .width = most + 1, .height = 1}), ErrorKind::bad_input);
  EXPECT_EQ(kind_of({.name = "too high", .width = 1, .height = most + 1}), ErrorKind::bad_input);
  EXPECT_EQ(kind_of({.name = "no levels", .width = 4, .height = 4, .levels = 0}), ErrorKind::bad_input);
  EXPECT_EQ(kind_of({.name = "many levels", .width = 4, .height = 4, .levels = 4}), ErrorKind::bad_input);
  EXPECT_EQ(kind_of({.name = "short texels", .width = 2, .height = 2}, {std::vector<std::byte>(15)}), ErrorKind::bad_input);
}

TEST_P(BackendDevice, WidestTextureThatIsPromisedCanBeMade) {
  const uint32_t most = backend().info().max_texture_size;
  backend().destroy(target(Format::r8_unorm, most, 1));
  backend().destroy(target(Format::r8_unorm, 1, most));
}

TEST_P(BackendDevice, BuffersThatCannotBeAreRefused) {
  EXPECT_EQ(error_of([&] { backend().create_buffer("empty", BufferUse::storage, 0); }).kind(), ErrorKind::bad_input);
  const BufferId four = backend().create_buffer("four", BufferUse::uniform, 4);
  EXPECT_EQ(error_of([&] { backend().write_buffer(four, std::vector<std::byte>(8)); }).kind(), ErrorKind::bad_input);
}

TEST_P(BackendDevice, WordsThatAreNotSpirvAreRefused) {
  const std::vector<uint32_t> vertex = shader(Stage::vertex, full_screen).spirv;
  const auto refused = [&](std::vector<uint32_t> fragment) {
    PipelineDesc desc{.name = "garbage", .stages = {{Stage::vertex, vertex}, {Stage::fragment, std::move(fragment)}}};
    desc.colors = {Format::rgba8_unorm};
    return error_of([&] { backend().create_pipeline(desc); });
  };
  EXPECT_EQ(refused({}).kind(), ErrorKind::failed);
  EXPECT_EQ(refused({1, 2, 3, 4, 5, 6, 7, 8}).kind(), ErrorKind::failed);
  EXPECT_EQ(refused({vertex[0]}).kind(), ErrorKind::failed);  // the magic number and nothing after it
  EXPECT_EQ(refused({1, 2, 3, 4, 5, 6, 7, 8}).subject(), "garbage");
}

TEST_P(BackendDevice, StaleHandlesAreErrors) {
  const TextureId texture = target(Format::rgba8_unorm, 2, 2);
  const BufferId buffer = backend().create_buffer("gone", BufferUse::storage, 16);
  backend().destroy(texture);
  backend().destroy(buffer);
  EXPECT_THROW(backend().read_texture(texture), Error);
  EXPECT_THROW(backend().read_buffer(buffer), Error);
  EXPECT_THROW(run({raster(texture, {})}), Error);
  target(Format::rgba8_unorm, 2, 2);  // takes no one's place
  EXPECT_THROW(backend().read_texture(texture), Error);
}

TEST_P(BackendDevice, PassThatDoesNotFitTogetherIsBadInput) {
  const TextureId large = target(Format::rgba32_float, 4, 4), small = target(Format::rgba32_float, 2, 2);
  const TextureId other = target(Format::rgba8_unorm, 4, 4);
  const PipelineId draws = pipeline(full_screen, "layout(location = 0) out vec4 c; void main() { c = vec4(1); }");
  const PipelineId reads = pipeline(full_screen, R"(
layout(binding = 3) uniform sampler2D picture;
layout(location = 0) out vec4 c;
void main() { c = texelFetch(picture, ivec2(0), 0); })");
  const PipelineId mesh = pipeline("layout(location = 0) in vec3 position; void main() { gl_Position = vec4(position, 1); }",
                                   "layout(location = 0) out vec4 c; void main() { c = vec4(1); }");
  const auto kind_of = [&](const Pass& pass) { return error_of([&] { run({pass}); }).kind(); };

  Pass uneven = raster(large, {});
  uneven.colors.push_back({.texture = small});
  EXPECT_EQ(kind_of(uneven), ErrorKind::bad_input);
  EXPECT_EQ(kind_of(raster(other, {triangles(draws)})), ErrorKind::bad_input) << "another target format than the pipeline's";
  EXPECT_EQ(kind_of(raster(large, {triangles(reads)})), ErrorKind::bad_input) << "nothing bound at 3";
  EXPECT_EQ(kind_of(raster(large, {triangles(mesh)})), ErrorKind::bad_input) << "no vertex buffer";
  Pass dispatch = raster(large, {triangles(draws)});
  dispatch.kind = PassKind::compute;
  EXPECT_EQ(kind_of(dispatch), ErrorKind::bad_input) << "a drawing pipeline in a compute pass";
  EXPECT_EQ(kind_of({.name = "nothing to draw into"}), ErrorKind::bad_input);

  run({raster(large, {triangles(draws)})});  // and the backend goes on
  EXPECT_EQ(picture(large, 4).at(3, 3), 1);
}

// What only Vulkan can say.
class VulkanDevice : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, VulkanDevice, ::testing::Values("vulkan"),
                         [](const auto& case_of) { return std::string(case_of.param); });

// Silence of the validation layers means something only where they can be heard.
TEST_P(VulkanDevice, ValidationLayersAreHeard) {
  PipelineDesc desc{.name = "reads an attribute that no buffer feeds"};
  desc.stages = {
      {Stage::vertex, shader(Stage::vertex, "layout(location = 3) in vec2 uv; void main() { gl_Position = uv.xyxy; }").spirv},
      {Stage::fragment, shader(Stage::fragment, "layout(location = 0) out vec4 c; void main() { c = vec4(1); }").spirv}};
  desc.colors = {Format::rgba8_unorm};
  backend().create_pipeline(desc);
  const std::vector<std::string> messages = backend().take_messages();
  ASSERT_FALSE(messages.empty());
  EXPECT_NE(messages[0].find("location"), std::string::npos) << messages[0];
  EXPECT_TRUE(backend().take_messages().empty()) << "they are taken once";
}

// An environment variable that goes back to what it was.
class ScopedVariable {
 public:
  ScopedVariable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value, 1);
  }
  ~ScopedVariable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST_P(VulkanDevice, WithoutADriverTheListIsEmptyAndOpeningSaysWhatToInstall) {
  close();
  const ScopedVariable none("VK_ICD_FILENAMES", "/no/such/driver.json"), none_either("VK_DRIVER_FILES", "/no/such/driver.json");
  EXPECT_TRUE(survey_devices("vulkan").usable.empty());
  const Error error = error_of([] { open_backend("vulkan"); });
  EXPECT_EQ(error.kind(), ErrorKind::no_device);
  EXPECT_NE(error.message().find("mesa-vulkan-drivers"), std::string::npos) << error.what();
}

TEST_P(VulkanDevice, WithoutTheLayerValidationNamesThePackage) {
  close();
  const ScopedVariable none("VK_LAYER_PATH", "/no/such/folder");
  const Error error = error_of([] { open_backend("vulkan", {.device = "", .validation = true}); });
  EXPECT_EQ(error.kind(), ErrorKind::no_device);
  EXPECT_NE(error.message().find("vulkan-validationlayers"), std::string::npos) << error.what();
  EXPECT_NO_THROW(open_backend("vulkan"));
}

TEST_P(VulkanDevice, TextureLargerThanAllMemoryIsAnErrorThatNamesIt) {
  if (!backend().info().software) GTEST_SKIP() << "a device with this much memory may have room";
  const uint32_t most = backend().info().max_texture_size;
  for (const uint32_t height : {most, most / 4 * 3}) {  // 4 and 3 GB on lavapipe, past its largest image and its largest memory
    const Error error = error_of(
        [&] { backend().create_texture({.name = "huge", .width = most, .height = height, .format = Format::rgba32_float}); });
    EXPECT_EQ(error.kind(), ErrorKind::failed);
    EXPECT_EQ(error.subject(), "huge");
    EXPECT_NE(error.message().find("smaller"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lamina
