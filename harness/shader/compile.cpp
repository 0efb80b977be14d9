// SPDX-License-Identifier: Apache-2.0
// GLSL to SPIR-V through glslang.
//
// Both APIs get the same treatment: the module is what glslang writes, unoptimized and with its names. The driver's compiler
// optimizes; a pass of ours before it would only put another compiler between the author's source and the time it is given.

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <charconv>

#include "harness/core/text.h"
#include "harness/shader/include.h"
#include "harness/shader/interface_rules.h"
#include "harness/shader/shader.h"

namespace lamina {
namespace {

constexpr int glsl_version = 450;
// Version of the dialect, not of the API: 100 is the only one of GL_KHR_vulkan_glsl and of GL_ARB_gl_spirv.
constexpr int dialect_version = 100;

[[noreturn]] void refuse(std::string subject, std::string message) {
  throw Error(ErrorKind::bad_input, "shader", std::move(subject), std::move(message));
}

EShLanguage language_of(Stage stage) {
  switch (stage) {
    case Stage::vertex:
      return EShLangVertex;
    case Stage::fragment:
      return EShLangFragment;
    case Stage::compute:
      return EShLangCompute;
  }
  std::abort();
}

// What stands before the first line of the source. glslang lets #version come after it.
std::string preamble_of(const ShaderRequest& request) {
  const bool vulkan = request.api == Api::vulkan;
  std::string text = "#extension GL_GOOGLE_include_directive : require\n";
  text += vulkan ? "#define LAMINA_VULKAN 1\n" : "#define LAMINA_OPENGL 1\n";
  text += fmt::format("#define LAMINA_VERTEX_INDEX {}\n", vulkan ? "gl_VertexIndex" : "gl_VertexID");
  for (const auto& [name, value] : request.defines) {
    // A line break would let a definition smuggle in a line of its own, and shift the reported lines.
    if (name.empty() || (name + value).find_first_of("\r\n") != std::string::npos)
      refuse(request.file.string(), fmt::format("definition '{}' must have a name and lie on one line", name));
    text += fmt::format("#define {} {}\n", name, value);
  }
  return text;
}

// Throws the first error of glslang's log, whose lines read "ERROR: FILE:LINE: words" or "ERROR: words".
[[noreturn]] void throw_first_error(std::string_view log, const std::string& file) {
  constexpr std::string_view mark = "ERROR: ";
  const size_t begin = log.find(mark);
  if (begin == std::string_view::npos) refuse(file, fmt::format("does not compile: {}", log));
  std::string_view line = log.substr(begin + mark.size());
  line = line.substr(0, line.find('\n'));
  line = line.substr(0, line.find_last_not_of(" \r") + 1);

  std::string subject = file;
  std::string message(line);
  // The line number is the first one between colons, for a file's name may hold a colon of its own.
  for (size_t colon = line.find(':'); colon != std::string_view::npos; colon = line.find(':', colon + 1)) {
    int number = 0;
    const auto [end, problem] = std::from_chars(line.data() + colon + 1, line.data() + line.size(), number);
    const size_t after = static_cast<size_t>(end - line.data());
    if (problem != std::errc() || line.substr(after, 2) != ": ") continue;
    const bool in_preamble = colon == 0 || line.substr(0, colon) == "-1";
    subject = in_preamble ? file : std::string(line.substr(0, after));
    message = (in_preamble ? "in a definition: " : "") + std::string(line.substr(after + 2));
    break;
  }
  if (message.find("non-opaque uniform") != std::string::npos) message += "; put the uniform into a uniform block";
  refuse(subject, message);
}

// The parse's input, set up alike for compiling and for preprocessing.
struct Source {
  Source(const ShaderRequest& request, const std::string& file, const std::string& text, const std::string& preamble)
      : shader(language_of(request.stage)), text_begin(text.data()), length(static_cast<int>(text.size())), name(file.c_str()) {
    const EShLanguage language = language_of(request.stage);
    const bool vulkan = request.api == Api::vulkan;
    const glslang::EShClient client = vulkan ? glslang::EShClientVulkan : glslang::EShClientOpenGL;
    shader.setStringsWithLengthsAndNames(&text_begin, &length, &name, 1);
    shader.setPreamble(preamble.c_str());
    shader.setEnvInput(glslang::EShSourceGlsl, language, client, dialect_version);
    shader.setEnvClient(client, vulkan ? glslang::EShTargetVulkan_1_0 : glslang::EShTargetOpenGL_450);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  glslang::TShader shader;
  const char* text_begin;  // glslang keeps pointers to these three
  int length;
  const char* name;
};

EShMessages messages_for(Api api) {
  const unsigned rules = EShMsgSpvRules | EShMsgSuppressWarnings | (api == Api::vulkan ? EShMsgVulkanRules : 0u);
  return static_cast<EShMessages>(rules);
}

// glslang gives a sampler or image that asks for no binding number 0 in OpenGL's SPIR-V, without a word.
void check_bindings_are_written(const glslang::TIntermediate& tree, const std::string& file) {
  for (TIntermNode* node : tree.findLinkerObjects()->getSequence()) {
    const glslang::TIntermSymbol* symbol = node->getAsSymbolNode();
    if (symbol->getBasicType() == glslang::EbtSampler && !symbol->getQualifier().hasBinding())
      refuse(file, fmt::format("'{}' has no binding; give it one with layout(binding = N)", symbol->getName().c_str()));
  }
}

// Without #line directives and empty lines: neither where the files lie nor their comments change the hash.
std::string without_places(const std::string& preprocessed) {
  std::string text;
  for (size_t begin = 0; begin < preprocessed.size();) {
    const size_t end = std::min(preprocessed.find('\n', begin), preprocessed.size());
    const std::string_view line = std::string_view(preprocessed).substr(begin, end - begin);
    if (line.find_first_not_of(" \t\r") != std::string_view::npos && !line.starts_with("#line")) {
      text += line;
      text += '\n';
    }
    begin = end + 1;
  }
  return text;
}

}  // namespace

CompiledShader compile_shader(const ShaderRequest& request) {
  static const bool initialized = glslang::InitializeProcess();
  if (!initialized) throw Error(ErrorKind::failed, "shader", "glslang", "cannot be initialized");

  const std::string file = request.file.lexically_normal().string();
  const std::string text = read_file(request.file, "shader");
  const std::string preamble = preamble_of(request);
  const TBuiltInResource* limits = GetDefaultResources();
  const EShMessages messages = messages_for(request.api);

  Source source(request, file, text, preamble);
  FileIncluder includer(request.include_dirs);
  if (!source.shader.parse(limits, glsl_version, ECoreProfile, false, false, messages, includer))
    throw_first_error(source.shader.getInfoLog(), file);
  glslang::TProgram program;
  program.addShader(&source.shader);
  if (!program.link(messages)) throw_first_error(program.getInfoLog(), file);

  CompiledShader compiled;
  compiled.stage = request.stage;
  const glslang::TIntermediate& tree = *program.getIntermediate(language_of(request.stage));
  check_bindings_are_written(tree, file);
  glslang::GlslangToSpv(tree, compiled.spirv);
  glslang::SpvOptions options;
  options.generateDebugInfo = true;
  glslang::GlslangToSpv(tree, compiled.spirv_with_lines, &options);
  check_interface(compiled.spirv, file);
  validate_spirv(compiled.spirv, request.api, ErrorKind::bad_input, file);
  compiled.reflection = reflect(compiled.spirv);

  Source again(request, file, text, preamble);  // glslang parses a TShader once
  FileIncluder includer_again(request.include_dirs);
  std::string preprocessed;
  if (!again.shader.preprocess(limits, glsl_version, ECoreProfile, false, false, messages, &preprocessed, includer_again))
    throw_first_error(again.shader.getInfoLog(), file);
  compiled.hash = hash_hex(fmt::format("{} {}\n{}", request.api == Api::vulkan ? "vulkan" : "opengl",
                                       static_cast<int>(request.stage), without_places(preprocessed)));
  return compiled;
}

}  // namespace lamina
