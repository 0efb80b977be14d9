// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <future>

#include "harness/shader/spirv_module.h"
#include "tests/shader/shader_files.h"

namespace lamina {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class Compile : public ShaderFiles {
 protected:
  Error fragment_error(Api api, std::string_view body) const {
    return error_of([&] { compile(Stage::fragment, api, body); });
  }
};

TEST_F(Compile, EveryStageForBothApis) {
  for (const Api api : both_apis) {
    EXPECT_GT(compile(Stage::vertex, api, "void main() { gl_Position = vec4(LAMINA_VERTEX_INDEX, 0, 0, 1); }\n").spirv.size(),
              5u);
    EXPECT_GT(compile(Stage::fragment, api, "layout(location = 0) out vec4 o; void main() { o = vec4(1); }\n").spirv.size(),
              5u);
    const auto shader = compile(Stage::compute, api, "layout(local_size_x = 4) in; void main() {}\n");
    EXPECT_EQ(shader.spirv[1], 0x00010000u) << "SPIR-V 1.0, which both APIs take";
    EXPECT_EQ(shader.stage, Stage::compute);
  }
}

TEST_F(Compile, EachApiHasItsMacro) {
  constexpr std::string_view source = R"(
#if defined(LAMINA_VULKAN) == defined(LAMINA_OPENGL)
#error exactly one must be defined
#endif
#ifdef LAMINA_VULKAN
layout(location = 3) out vec4 o;
#elif LAMINA_OPENGL
layout(location = 5) out vec4 o;
#endif
void main() { o = vec4(1); }
)";
  EXPECT_EQ(compile(Stage::fragment, Api::vulkan, source).reflection.output_locations, std::vector<uint32_t>{3});
  EXPECT_EQ(compile(Stage::fragment, Api::opengl, source).reflection.output_locations, std::vector<uint32_t>{5});
}

TEST_F(Compile, DefinitionsReachTheSource) {
  const auto shader = compile(Stage::fragment, Api::vulkan,
                              "layout(location = WHERE) out vec4 o; void main() { o = vec4(1); }\n", {{"WHERE", "1 + 1"}});
  EXPECT_EQ(shader.reflection.output_locations, std::vector<uint32_t>{2});
}

TEST_F(Compile, ADefinitionMustLieOnOneLine) {
  const Error error = error_of([&] { compile(Stage::fragment, Api::vulkan, "void main() {}\n", {{"X", "1\n#error y"}}); });
  EXPECT_EQ(error.kind(), ErrorKind::bad_input);
  EXPECT_THAT(error.message(), HasSubstr("'X'"));
}

TEST_F(Compile, IncludesNestBesideTheIncludingFileAndThenInTheFolders) {
  const auto file =
      write("a/main.frag", "#version 450\n#include \"sub/one.glsl\"\nvoid main() { o = vec4(one() + shared_one()); }\n");
  write("a/sub/one.glsl",
        "#include \"two.glsl\"\n#include \"shared.glsl\"\n#include <shared.glsl>\nfloat one() { return two(); }\n");
  write("a/sub/two.glsl", "layout(location = 4) out vec4 o;\nfloat two() { return 2.0; }\n");
  write("b/shared.glsl", "#ifndef SHARED\n#define SHARED\nfloat shared_one() { return 1.0; }\n#endif\n");
  for (const Api api : both_apis) {
    const auto shader =
        compile_shader({.file = file, .stage = Stage::fragment, .api = api, .defines = {}, .include_dirs = {folder() / "b"}});
    EXPECT_EQ(shader.reflection.output_locations, std::vector<uint32_t>{4});
  }
}

TEST_F(Compile, AnErrorNamesItsFileAndLine) {
  const Error error = fragment_error(Api::vulkan, "layout(location = 0) out vec4 o;\n\nvoid main() { o = vec4(nothing); }\n");
  EXPECT_EQ(error.kind(), ErrorKind::bad_input);
  EXPECT_EQ(error.stage(), "shader");
  EXPECT_EQ(error.subject(), (folder() / "test.frag").string() + ":4");
  EXPECT_THAT(error.message(), HasSubstr("'nothing' : undeclared identifier"));
}

TEST_F(Compile, AnErrorInAnIncludedFileNamesThatFile) {
  const auto file = write("main.frag", "#version 450\n#include \"sub/one.glsl\"\nvoid main() {}\n");
  write("sub/one.glsl", "float fine() { return 1.0; }\n#include \"two.glsl\"\n");
  write("sub/two.glsl", "\n\nfloat wrong() { return nothing; }\n");
  const Error error = error_of([&] { compile_shader({file, Stage::fragment, Api::opengl, {}, {}}); });
  EXPECT_EQ(error.subject(), (folder() / "sub/two.glsl").string() + ":3");
}

TEST_F(Compile, LinesAfterAnIncludeCountOn) {
  const auto file =
      write("main.frag", "#version 450\n#include \"one.glsl\"\n\nfloat wrong() { return nothing; }\nvoid main() {}\n");
  write("one.glsl", "float fine() { return 1.0; }\n\n\n\n\n");
  const Error error = error_of([&] { compile_shader({file, Stage::fragment, Api::vulkan, {}, {}}); });
  EXPECT_EQ(error.subject(), file.string() + ":4");
}

TEST_F(Compile, ALineInAFileWhoseNameHoldsAColonIsFound) {
  const auto file = write("a: 3:4.frag", "#version 450\n\nwrong\n");
  const Error error = error_of([&] { compile_shader({file, Stage::fragment, Api::vulkan, {}, {}}); });
  EXPECT_THAT(error.subject(), testing::StartsWith(file.string() + ":"));
}

TEST_F(Compile, AMissingIncludeNamesTheIncludingLine) {
  const Error error = fragment_error(Api::vulkan, "\n#include \"none.glsl\"\nvoid main() {}\n");
  EXPECT_EQ(error.subject(), (folder() / "test.frag").string() + ":3");
  EXPECT_THAT(error.message(), HasSubstr("no such file"));
  EXPECT_THAT(error.message(), HasSubstr("none.glsl"));
}

TEST_F(Compile, ACircleOfIncludesEnds) {
  write("loop.glsl", "#include \"loop.glsl\"\n");
  EXPECT_THAT(fragment_error(Api::vulkan, "#include \"loop.glsl\"\nvoid main() {}\n").message(), HasSubstr("circle"));
}

TEST_F(Compile, ABrokenDefinitionIsBlamedOnTheDefinition) {
  const Error error = error_of([&] { compile(Stage::fragment, Api::vulkan, "void main() {}\n", {{"X(", "1"}}); });
  EXPECT_THAT(error.message(), HasSubstr("in a definition"));
  EXPECT_THAT(error.subject(), EndsWith("test.frag"));
}

TEST_F(Compile, AMissingFileIsBadInput) {
  const Error error = error_of([&] { compile_shader({folder() / "none.frag", Stage::fragment, Api::vulkan, {}, {}}); });
  EXPECT_EQ(error.kind(), ErrorKind::bad_input);
  EXPECT_EQ(error.subject(), (folder() / "none.frag").string());
}

TEST_F(Compile, AMissingMainIsRefused) {
  EXPECT_THAT(fragment_error(Api::vulkan, "float f() { return 1.0; }\n").message(), HasSubstr("entry point"));
}

// Each of these resources is beyond what both APIs and the harness's bindings share; the error must name it and the file.
TEST_F(Compile, ResourcesOutsideTheRulesAreRefusedByName) {
  struct Case {
    std::string_view declaration, use, vulkan_says, opengl_says;
  };
  const Case cases[] = {
      {"uniform sampler2D bad;", "texture(bad, vec2(0))", "binding", "has no binding"},
      {"uniform bad { vec4 v; };", "v", "binding", "binding"},
      {"layout(set = 1, binding = 0) uniform sampler2D bad;", "texture(bad, vec2(0))", "descriptor set", "set"},
      {"layout(push_constant) uniform bad { vec4 v; };", "v", "push constant", "push_constant"},
      {"uniform vec4 bad;", "bad", "put the uniform into a uniform block", "put the uniform into a uniform block"},
      {"layout(location = 3) uniform vec4 bad;", "bad", "put the uniform into a uniform block", "put it into a uniform block"},
      {"layout(binding = 0) uniform sampler2D a; layout(binding = 0) uniform bad { vec4 v; };", "v + texture(a, vec2(0))",
       "shares binding 0 with", "shares binding 0 with"},
      {"layout(binding = 0) uniform sampler2D bad[2];", "texture(bad[1], vec2(0))", "array of resources", "array of resources"},
      {"layout(binding = 0) uniform bad { vec4 v; } b[2];", "b[1].v", "array of resources", "array of resources"},
      {"layout(binding = 0) uniform samplerCube bad;", "texture(bad, vec3(0))", "no plain 2D", "no plain 2D"},
      {"layout(binding = 0) uniform sampler2DArray bad;", "texture(bad, vec3(0))", "no plain 2D", "no plain 2D"},
      {"layout(binding = 0) uniform sampler2DMS bad;", "texelFetch(bad, ivec2(0), 0)", "no plain 2D", "no plain 2D"},
      {"layout(binding = 0) uniform samplerBuffer bad;", "texelFetch(bad, 0)", "no plain 2D", "no plain 2D"},
      {"layout(binding = 0) uniform isampler3D bad;", "texture(bad, vec3(0))", "3D texture of integers",
       "3D texture of integers"},
      {"layout(binding = 0, rgba8) uniform readonly image3D bad;", "imageLoad(bad, ivec3(0))", "is a 3D image",
       "is a 3D image"},
      {"layout(binding = 0) uniform sampler2DShadow bad;", "vec4(texture(bad, vec3(0)))", "compares depths", "compares depths"},
  };
  for (const Case& c : cases)
    for (const Api api : both_apis) {
      const std::string source =
          fmt::format("{}\nlayout(location = 0) out vec4 o;\nvoid main() {{ o = {}; }}\n", c.declaration, c.use);
      const Error error = fragment_error(api, source);
      EXPECT_EQ(error.kind(), ErrorKind::bad_input) << c.declaration;
      EXPECT_THAT(error.subject(), HasSubstr((folder() / "test.frag").string())) << c.declaration;
      EXPECT_THAT(error.message(), HasSubstr(std::string(api == Api::vulkan ? c.vulkan_says : c.opengl_says))) << c.declaration;
    }
}

TEST_F(Compile, SeparateSamplersAndTexturesAreRefused) {
  constexpr std::string_view main = "layout(location = 0) out vec4 o;\nvoid main() { o = vec4(1); }\n";
  const std::string sampler = "layout(binding = 0) uniform sampler how;\n",
                    texture = "layout(binding = 0) uniform texture2D picture;\n";
  EXPECT_THAT(fragment_error(Api::vulkan, sampler + std::string(main)).message(),
              HasSubstr("'how' is a sampler without a texture"));
  EXPECT_THAT(fragment_error(Api::vulkan, texture + std::string(main)).message(),
              HasSubstr("'picture' is a texture without a sampler"));
}

TEST_F(Compile, ASamplerInAPlainStructureIsRefused) {
  const Error error = fragment_error(Api::opengl,
                                     "struct Picture { sampler2D t; vec4 tint; }; layout(location = 0) out vec4 o;\n"
                                     "layout(location = 3) uniform Picture bad;\n"
                                     "void main() { o = texture(bad.t, vec2(0)) * bad.tint; }\n");
  EXPECT_THAT(error.message(), HasSubstr("'bad' is a plain uniform"));
}

TEST_F(Compile, AnAtomicCounterIsRefused) {
  const Error error = fragment_error(Api::opengl,
                                     "layout(binding = 0) uniform atomic_uint bad; layout(location = 0) out uint o;\n"
                                     "void main() { o = atomicCounterIncrement(bad); }\n");
  EXPECT_THAT(error.message(), HasSubstr("atomic"));
}

TEST_F(Compile, ADoubleSpecializationConstantIsRefused) {
  const Error error = fragment_error(Api::vulkan,
                                     "layout(constant_id = 0) const double bad = 1.0; layout(location = 0) out vec4 o;\n"
                                     "void main() { o = vec4(float(bad)); }\n");
  EXPECT_THAT(error.message(), HasSubstr("'bad' is no 32-bit"));
}

// What the rules break must fail; this is the same shader with all of them kept.
TEST_F(Compile, ResourcesWithinTheRulesPass) {
  for (const Api api : both_apis)
    EXPECT_NO_THROW(compile(Stage::fragment, api, R"(
layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) uniform Frame { vec4 tint; };
layout(binding = 2) buffer Words { uint words[]; };
layout(binding = 3, rgba8) uniform writeonly image2D target;
layout(constant_id = 0) const float strength = 1.0;
layout(location = 0) out vec4 o;
void main() {
  o = texture(picture, vec2(0)) * tint * strength;
  words[0] = 1u;
  imageStore(target, ivec2(0), o);
}
)"));
}

TEST_F(Compile, ThreadsCompileAtTheSameTime) {
  const auto file = write("test.frag", "#version 450\nlayout(location = 0) out vec4 o;\nvoid main() { o = vec4(1); }\n");
  const auto job = [&] { return compile_shader({file, Stage::fragment, Api::vulkan, {}, {}}); };
  std::vector<std::future<CompiledShader>> jobs;
  for (int i = 0; i < 8; ++i) jobs.push_back(std::async(std::launch::async, job));
  const CompiledShader expected = job();
  for (auto& result : jobs) EXPECT_EQ(result.get().spirv, expected.spirv);
}

class CompileHash : public ShaderFiles {
 protected:
  static std::string hash_of(const std::filesystem::path& file, Api api = Api::vulkan,
                             std::map<std::string, std::string> defines = {}) {
    return compile_shader({file, Stage::fragment, api, std::move(defines), {}}).hash;
  }

  const std::string source_ = R"(#version 450
#include "k.glsl"
layout(location = 0) out vec4 o;
void main() { o = vec4(K); }
)";
  const std::string included_ = "#ifndef K\n#define K 1\n#endif\n";
};

TEST_F(CompileHash, StaysWithTheContent) {
  write("here/k.glsl", included_);
  write("there/far/k.glsl", included_);
  const std::string hash = hash_of(write("here/x.frag", source_));
  EXPECT_EQ(hash.size(), 16u);
  EXPECT_EQ(hash_of(write("there/far/y.frag", source_)), hash);
  std::string commented = source_;
  commented.insert(commented.find("void main"), "\n// a comment\n/* and\nanother */\n");
  EXPECT_EQ(hash_of(write("here/commented.frag", commented)), hash);
  EXPECT_EQ(hash_of(folder() / "here/x.frag", Api::vulkan, {{"K", "1"}, {"UNUSED", "3"}}), hash);
}

TEST_F(CompileHash, ChangesWithWhatIsCompiled) {
  write("k.glsl", included_);
  const auto file = write("x.frag", source_);
  std::vector<std::string> hashes = {hash_of(file), hash_of(file, Api::opengl), hash_of(file, Api::vulkan, {{"K", "2"}})};
  write("k.glsl", "#define K 7\n");
  hashes.push_back(hash_of(file));
  hashes.push_back(hash_of(write("y.frag", source_ + "float more() { return 1.0; }\n")));
  std::ranges::sort(hashes);
  EXPECT_EQ(std::ranges::adjacent_find(hashes), hashes.end()) << "two of them are the same";
}

TEST_F(CompileHash, TellsStagesApart) {
  const auto file = write("empty.glsl", "#version 450\nvoid main() {}\n");
  const auto hash = [&](Stage stage) { return compile_shader({file, stage, Api::vulkan, {}, {}}).hash; };
  EXPECT_NE(hash(Stage::vertex), hash(Stage::fragment));
}

}  // namespace
}  // namespace lamina
