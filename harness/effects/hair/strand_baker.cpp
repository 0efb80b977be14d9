// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/hair/strand_baker.h"

#include "harness/bake/baker.h"
#include "harness/core/bytes.h"
#include "harness/core/error.h"
#include "harness/effects/hair/kept_coverage.h"
#include "harness/effects/hair/strands.h"
#include "harness/scene/scene.h"

namespace lamina {
namespace {

class StrandBaker : public Baker {
 public:
  explicit StrandBaker(const Scene& scene) : scene_(scene) {}

  Baked bake(size_t object, const EffectValues& values, const BakeOptions&) override {
    const std::string owner = fmt::format("object '{}'", scene_.objects[object].name);
    const TextureImage& albedo = *values.textures.at("hair_albedo");
    if (albedo.width == 1 && albedo.height == 1)
      throw Error(
          ErrorKind::bad_input, "bake", owner,
          "has no alpha texture: hair.albedo is one colour, so that its cards would be plain strips; give a picture whose "
          "alpha shows the strands");
    const Strands strands = strands_of(scene_.objects[object].mesh, owner);
    std::vector<glm::vec4> told = {glm::vec4(strands.middle, static_cast<float>(strands.cards))};
    for (size_t vertex = 0; vertex < strands.directions.size(); ++vertex)
      told.emplace_back(strands.directions[vertex], static_cast<float>(strands.card_of[vertex]));
    Baked baked;
    const std::span<const std::byte> bytes = std::as_bytes(std::span(told));
    baked.buffers["Strands"] = {bytes.begin(), bytes.end()};
    baked.textures["hair_albedo_kept"] = std::make_shared<const TextureImage>(with_kept_coverage(albedo, 0.5));
    return baked;
  }

 private:
  const Scene& scene_;
};

std::string strand_problem(const BakeOptions& options) {
  return options.empty() ? "" : fmt::format("hair takes no [bake], and so no '{}'", options.begin()->first);
}
std::vector<BakedName> strand_names(const BakeOptions&) {
  return {{"Strands", true}, {"hair_albedo_kept", false, {Filter::trilinear, Wrap::repeat}}};
}
std::map<std::string, std::string> strand_defines(const BakeOptions&) { return {}; }
std::unique_ptr<Baker> start_strands(const Scene& scene, BakeTools&) { return std::make_unique<StrandBaker>(scene); }

}  // namespace

const BakerCode strand_baker = {strand_problem, strand_names, strand_defines, start_strands};

}  // namespace lamina
