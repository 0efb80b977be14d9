// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/faults.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/core/text.h"
#include "harness/shader/changed_constants.h"
#include "harness/shader/spirv_module.h"

namespace lamina {
namespace {

// The name of the fragment shader's first output; "" where it has none.
std::string output_of(const CompiledShader& shader) {
  const SpirvModule module(shader.spirv);
  for (const SpirvInstruction& i : module.instructions())
    if (i.op() == spv::OpVariable && i.words[3] == spv::StorageClassOutput &&
        module.decoration(i.result, spv::DecorationLocation).value_or(1) == 0)
      return module.name(i.result);
  return "";
}

std::string sampler_of(const CompiledShader& shader) {
  for (const ShaderResource& resource : shader.reflection.resources)
    if (resource.kind == BindingKind::texture && resource.dimensions == 2) return resource.name;
  return "";
}

// Lets `then` follow the fragment shader's own main(). OUT stands for its output, TEXTURE for one of its textures.
std::string put_after_main(const FaultSite& site, const char* name, const std::string& then) {
  const std::string out = output_of(site.compiled), sampler = sampler_of(site.compiled);
  if (out.empty()) return "its fragment shader has no output";
  if (sampler.empty() && then.find("TEXTURE") != std::string::npos) return "its fragment shader reads no texture";
  const std::filesystem::path file = site.folder / fmt::format("{}.frag", name);
  write_file_atomically(file,
                        fmt::format("#define main main_without_fault\n#include \"{}\"\n#undef main\n#define OUT {}\n#define "
                                    "TEXTURE {}\nvoid main() {{\n  main_without_fault();\n  {}\n}}\n",
                                    site.pass.fragment.string(), out, sampler, then));
  site.pass.fragment = file;
  return "";
}

// Changes the compiled fragment shader of the pass.
std::string put_into_code(const FaultSite& site, bool (*change)(CompiledShader&), const char* reason) {
  CompiledShader tried = site.compiled;
  if (!change(tried)) return reason;
  site.change = [file = site.pass.fragment, change](const std::filesystem::path& of, CompiledShader& shader) {
    if (of == file) change(shader);
  };
  return "";
}

// The gate tells manifests apart by their files, so a changed one has a file of its own.
void give_file(const FaultSite& site, const char* name) {
  site.variant.file = site.folder / fmt::format("{}.toml", name);
  write_file_atomically(site.variant.file, fmt::format("fault = \"{}\"\n", name));
}

std::string put_eight_bit_target(const FaultSite& site) {
  const auto found = std::ranges::find_if(site.variant.targets, [](const TargetManifest& target) {
    return target.format_parameter.empty() && target.format == Format::rgba16_float;
  });
  if (found == site.variant.targets.end()) return "it has no target of half floats";
  found->format = Format::rgba8_unorm;
  give_file(site, "eight_bits");
  return "";
}

// Reads all its textures at their base level.
std::string leave_out_mips(const FaultSite& site) {
  for (const ShaderResource& resource : site.compiled.reflection.resources)
    if (resource.kind == BindingKind::texture) {
      ReadManifest read = site.pass.read_of(resource.name);
      read.filter = Filter::linear;
      site.pass.reads[resource.name] = read;
    }
  give_file(site, "no_mips");
  return sampler_of(site.compiled).empty() ? "it reads no texture" : "";
}

std::string put_twice(const FaultSite& site) {
  PassManifest again = site.pass;
  again.name += "_again";
  const auto at = std::ranges::find(site.variant.passes, site.pass.name, &PassManifest::name);
  site.variant.passes.insert(at + 1, again);
  give_file(site, "twice");
  return "";
}

Fault after_main(const char* name, const char* title, const char* then, Fault::Of of = Fault::Of::picture) {
  return {name, title, of, [=](const FaultSite& site) { return put_after_main(site, name, then); }};
}

}  // namespace

const std::vector<Fault>& gate_faults() {
  static const std::vector<Fault> faults = {
      after_main("discard_all", "no pixel is drawn", "discard;"),
      after_main("blank", "every pixel is black", "OUT = vec4(0.0, 0.0, 0.0, OUT.a);"),
      after_main("nan", "a pixel of 1024 is no number",
                 "if (all(equal(ivec2(gl_FragCoord.xy) & 31, ivec2(13)))) OUT.g = uintBitsToFloat(0x7fc00000u);"),
      after_main("alpha_0", "alpha is 0", "OUT.a = 0.0;", Fault::Of::alpha),
      {"weights_swapped", "two constants have changed places", Fault::Of::picture,
       [](const FaultSite& site) {
         return put_into_code(site, swap_weights, "its code has no two constants between 0 and 1");
       }},
      {"disc_scaled", "offsets of taps are a quarter longer", Fault::Of::picture,
       [](const FaultSite& site) {
         return put_into_code(
             site, [](CompiledShader& shader) { return scale_offsets(shader, 1.25f); }, "its code has no constant offsets");
       }},
      {"no_mips", "textures are read at their base level", Fault::Of::picture, leave_out_mips},
      {"eight_bits", "a target of half floats has 8 bits", Fault::Of::picture, put_eight_bit_target},
      after_main("tap", "a fetch more", "OUT += 1e-30 * textureLod(TEXTURE, vec2(0.5), 0.0);", Fault::Of::work),
      after_main("idle", "arithmetic that changes nothing",
                 "float idle = 0.0;\n  for (int i = 0; i < 64; ++i) idle += sin(float(i) + OUT.x);\n  OUT.x += 1e-30 * idle;",
                 Fault::Of::work),
      {"twice", "the pass runs twice", Fault::Of::work, put_twice},
  };
  return faults;
}

}  // namespace lamina
