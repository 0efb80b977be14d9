// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/slowdown.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "harness/core/text.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

constexpr const char* main_line = "void main() {";

[[noreturn]] void refuse(const fs::path& file, std::string message) {
  throw Error(ErrorKind::bad_input, "gate", file.string(), std::move(message));
}

// What stands between `before` and `after` in a text, from `at` on, which moves behind it. Empty where there is none.
std::string between(const std::string& text, std::string_view before, char after, size_t& at) {
  const size_t found = text.find(before, at);
  if (found == std::string::npos) return at = found, "";
  const size_t start = found + before.size();
  at = text.find(after, start);
  return text.substr(start, at - start);
}

std::string first_between(const std::string& text, std::string_view before, char after) {
  size_t at = 0;
  return between(text, before, after, at);
}

// The files that a shader is made of, itself first: as deep as its includes go once.
std::string with_includes(const fs::path& file) {
  const std::string text = read_file(file, "gate");
  std::string whole = text;
  for (size_t at = 0; at != std::string::npos;) {
    const std::string name = between(text, "#include \"", '"', at);
    if (const fs::path other = file.parent_path() / name; !name.empty() && fs::exists(other)) whole += read_file(other, "gate");
  }
  return whole;
}

// `main` of the shader under another name where EXTRA_TAPS is defined, and a main that calls it and then samples.
std::string slower(std::string text, const std::string& sampler, const std::string& output) {
  const size_t at = text.find(main_line);
  text.replace(at, std::string_view(main_line).size(), "#ifdef EXTRA_TAPS\nvoid main_before() {\n#else\nvoid main() {\n#endif");
  return text + fmt::format(R"(
#ifdef EXTRA_TAPS
void main() {{
  main_before();
  ivec2 at = ivec2(gl_FragCoord.xy), last = min(textureSize({0}, 0) - 1, ivec2(7));  // few, so that they stay in caches
  vec4 sum = vec4(0.0);
  for (int i = 0; i < EXTRA_TAPS; ++i) sum += texelFetch({0}, (at * (2 * i + 1)) & last, 0);
  if (sum.x < -1.0) {1} += sum;  // never, which no compiler knows
}}
#endif
)",
                            sampler, output);
}

void copy_tree(const fs::path& home, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const char* part : {"variants", "shaders"}) fs::copy(home / part, folder / part, fs::copy_options::recursive);
}

// Where the copy in `folder` has this file of `home`: nothing outside the copy is ever written.
fs::path in_copy(const fs::path& file, const fs::path& home, const fs::path& folder) {
  const fs::path inside = fs::relative(file, home);
  if (inside.empty() || *inside.begin() == "..") refuse(file, fmt::format("does not lie in {}", home.string()));
  return folder / inside;
}

}  // namespace

void write_slower_tree(const fs::path& home, const fs::path& folder, const VariantManifest& variant, const std::string& pass,
                       uint32_t taps) {
  copy_tree(home, folder);
  const auto found = std::find_if(variant.passes.begin(), variant.passes.end(), [&](const PassManifest& candidate) {
    return candidate.name == pass && !candidate.fragment.empty();
  });
  if (found == variant.passes.end()) refuse(variant.file, fmt::format("has no pass '{}' with a fragment shader", pass));
  const fs::path fragment = in_copy(found->fragment, home, folder);
  const std::string whole = with_includes(fragment);
  const std::string output = first_between(whole, "layout(location = 0) out vec4 ", ';');
  const std::string sampler = first_between(whole, "uniform sampler2D ", ';');
  std::string text = read_file(fragment, "gate");
  if (output.empty() || sampler.empty() || text.find(main_line) == std::string::npos)
    refuse(fragment, "needs a vec4 output at location 0, a sampler2D and 'void main() {' to be given extra taps");
  write_file_atomically(fragment, slower(std::move(text), sampler, output));

  // Only this pass asks for them: others may share the shader.
  const fs::path manifest = in_copy(variant.file, home, folder);
  std::string toml = read_file(manifest, "gate");
  const size_t name = toml.find(fmt::format("name = \"{}\"", pass), toml.find("[[pass]]"));
  if (name == std::string::npos) refuse(manifest, fmt::format("does not spell pass '{}' as name = \"{}\"", pass, pass));
  const size_t next = std::min(toml.find("[[pass]]", name), toml.size());
  const std::string defines = fmt::format("EXTRA_TAPS = \"{}\"", taps);
  const size_t define = toml.find("define = {", name);
  if (define < next)
    toml.insert(define + std::string_view("define = {").size(), " " + defines + ",");
  else
    toml.insert(toml.find('\n', name) + 1, fmt::format("define = {{ {} }}\n", defines));
  write_file_atomically(manifest, toml);
}

void write_changed_tree(const fs::path& home, const fs::path& folder, const EffectManifest& effect, const std::string& pass) {
  copy_tree(home, folder);
  std::set<fs::path> fragments;
  for (const VariantManifest& variant : effect.variants)
    for (const PassManifest& each : variant.passes)
      if (each.name == pass && !each.fragment.empty()) fragments.insert(in_copy(each.fragment, home, folder));
  for (const fs::path& fragment : fragments) {
    std::string text = read_file(fragment, "gate");
    if (const size_t at = text.find(main_line); at != std::string::npos)
      text.insert(at + std::string_view(main_line).size(), "\n  float not_used = 1.0;");
    write_file_atomically(fragment, text);
  }
}

}  // namespace lamina
