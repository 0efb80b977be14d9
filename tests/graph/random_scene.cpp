// SPDX-License-Identifier: Apache-2.0
#include "tests/graph/random_scene.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

#include "harness/scene/made/block_mesh.h"
#include "harness/scene/made/sphere_mesh.h"
#include "harness/scene/made/tiles.h"

namespace lamina {
namespace {

class Chance {
 public:
  explicit Chance(uint64_t seed) : bits_(seed) {}
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53); }
  size_t below(size_t count) { return static_cast<size_t>(bits_() % count); }
  bool one_in(double times) { return between(0, times) < 1; }

 private:
  std::mt19937_64 bits_;
};

struct Shape {
  const char* name;
  bool closed;
  Mesh (*make)();
};
const Shape shapes[] = {{"cube", true,
                         [] {
                           return block_mesh({{{-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}}}, 2);
                         }},
                        {"ball", true, [] { return sphere_mesh(4); }},
                        {"disc", true,
                         [] {
                           return bent_disc_mesh({0.7f, 0.7f, 0.08f}, 0.3f, 4);
                         }},
                        {"square", false, [] { return upright_square(); }}};

std::string number_text(double value) { return fmt::format("{:.6g}", value); }
std::string colour_text(Chance& chance) {
  return fmt::format("[{:.3f}, {:.3f}, {:.3f}]", chance.between(0, 1), chance.between(0, 1), chance.between(0, 1));
}
std::string point_text(Chance& chance, double half) {
  return fmt::format("[{:.3f}, {:.3f}, {:.3f}]", chance.between(-half, half), chance.between(-half, half),
                     chance.between(-half, half));
}

// 0 often, where it may be, for that is what effects are left out for; else about the default.
std::string value_of(Chance& chance, const NumberManifest& number) {
  if (chance.one_in(3) && (number.or_zero || (number.min <= 0 && number.max >= 0))) return "0";
  double value = number.value.value_or(1);
  if (value >= 512 && number.whole) value /= 8;  // counts of rays and the like
  if (value != 0)
    value *= std::exp2(chance.between(-1.5, 1.5));
  else
    value = number.whole ? 16 : chance.between(0.05, 1);
  value = std::clamp(value, number.min, number.max);
  if (number.whole) value = std::round(value);
  return number_text(value);
}

// Some of what the declarations take: keys with values.
void add_lines(Chance& chance, const Declarations& declared, std::vector<std::string>& lines) {
  for (const NumberManifest& number : declared.numbers)
    if (chance.one_in(3)) lines.push_back(number.key + " = " + value_of(chance, number));
  for (const WordManifest& word : declared.words)
    if (chance.one_in(2)) lines.push_back(fmt::format("{} = \"{}\"", word.key, word.of[chance.below(word.of.size())]));
  for (const TextureManifest& texture : declared.textures) {
    if (texture.min_width > 1) continue;
    if (texture.meaning == TextureMeaning::colour && chance.one_in(2))
      lines.push_back(texture.rgb + " = " + colour_text(chance));
    if (!texture.alpha.empty() && chance.one_in(2))
      lines.push_back(texture.alpha + " = " +
                      (chance.one_in(3)   ? "0"
                       : chance.one_in(3) ? "1"
                                          : number_text(chance.between(0, 1))));
  }
}

RandomScene::Piece random_object(Chance& chance, const Library& library, size_t index) {
  const Shape& shape = shapes[chance.below(std::size(shapes))];
  RandomScene::Piece piece;
  piece.kind = RandomScene::Kind::object;
  piece.name = fmt::format("{}_{}", shape.name, index);
  piece.mesh = shape.name;
  piece.head = "[objects." + piece.name + "]";
  piece.lines = {"position = " + point_text(chance, 1.2), "rotation_degrees = " + point_text(chance, 180),
                 "scale = " + number_text(chance.between(0.4, 2))};
  if (chance.one_in(6)) piece.lines[0] = fmt::format("position = [0, 0, {:.3f}]", chance.between(20, 60));  // out of many views
  std::vector<const EffectManifest*> possible;
  for (const EffectManifest& effect : library.effects)
    if (!effect.key.empty() && (shape.closed || !effect.closed)) possible.push_back(&effect);
  for (int more = 0; more < 2; ++more) {
    if (chance.one_in(more == 0 ? 4 : 1.2)) break;  // a plain surface; seldom two
    const EffectManifest& effect = *possible[chance.below(possible.size())];
    std::vector<std::string> lines;
    add_lines(chance, effect.object, lines);
    // In TOML a key that begins others cannot have a value of its own.
    const bool begins_others =
        std::ranges::any_of(lines, [&](const std::string& line) { return line.starts_with(effect.key + "."); });
    if (!begins_others) lines.insert(lines.begin(), effect.key + " = true");
    for (std::string& line : lines) {
      const std::string key = line.substr(0, line.find(" = "));
      const auto clashes = [&](const std::string& other) {
        const std::string known = other.substr(0, other.find(" = "));
        return known == key || known.starts_with(key + ".") || key.starts_with(known + ".");
      };
      if (std::ranges::none_of(piece.lines, clashes)) piece.lines.push_back(std::move(line));
    }
  }
  return piece;
}

RandomScene::Piece random_light(Chance& chance, size_t index) {
  RandomScene::Piece piece{RandomScene::Kind::light, fmt::format("[lights.light_{}]", index), {}, "", ""};
  const double turn = chance.between(0, 6.28), up = chance.between(-0.3, 1);
  if (chance.one_in(2))
    piece.lines = {"kind = \"directional\"",
                   fmt::format("direction = [{:.3f}, {:.3f}, {:.3f}]", std::cos(turn), -up, std::sin(turn))};
  else  // outside of all objects, so that one view shows what it lights
    piece.lines = {"kind = \"point\"",
                   fmt::format("position = [{:.3f}, {:.3f}, {:.3f}]", 90 * std::cos(turn), 90 * up + 40, 90 * std::sin(turn)),
                   "intensity = 8000"};
  piece.lines.push_back("color = " + colour_text(chance));
  if (chance.one_in(2)) piece.lines.push_back("casts = true");
  return piece;
}

RandomScene::Piece random_view(Chance& chance, size_t index) {
  RandomScene::Piece piece{RandomScene::Kind::view, fmt::format("[views.view_{}]", index), {}, "", ""};
  const double turn = chance.between(0, 6.28), far = chance.between(2.5, 6);
  piece.lines = {
      fmt::format("eye = [{:.3f}, {:.3f}, {:.3f}]", far * std::cos(turn), chance.between(-1, 3), far * std::sin(turn)),
      "target = " + point_text(chance, 0.4), "fov_y_degrees = " + number_text(chance.between(25, 70))};
  return piece;
}

const Shape& shape_of(const std::string& name) {
  return *std::ranges::find_if(shapes, [&](const Shape& shape) { return name == shape.name; });
}

// A glTF 2.0 model of the scene's objects, a node each.
void write_model(const RandomScene& scene, const std::filesystem::path& folder) {
  std::string bytes;
  std::vector<std::string> nodes, meshes, views, accessors;
  const auto add = [&](const void* data, size_t size, const std::string& accessor) {
    views.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}}})", bytes.size(), size));
    bytes.append(static_cast<const char*>(data), size);
    accessors.push_back(fmt::format(R"({{"bufferView":{},{}}})", views.size() - 1, accessor));
    return accessors.size() - 1;
  };
  for (const RandomScene::Piece& piece : scene.pieces) {
    if (piece.kind != RandomScene::Kind::object) continue;
    const Mesh mesh = shape_of(piece.mesh).make();
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> uvs;
    glm::vec3 low(1e9f), high(-1e9f);
    for (const Vertex& vertex : mesh.vertices) {
      positions.push_back(vertex.position), normals.push_back(vertex.normal), uvs.push_back(vertex.uv);
      low = glm::min(low, vertex.position), high = glm::max(high, vertex.position);
    }
    const size_t count = mesh.vertices.size();
    const auto of = [&](const char* type) {
      return fmt::format(R"("componentType":5126,"count":{},"type":"{}")", count, type);
    };
    const size_t position =
        add(positions.data(), count * sizeof(glm::vec3),
            of("VEC3") + fmt::format(R"(,"min":[{},{},{}],"max":[{},{},{}])", low.x, low.y, low.z, high.x, high.y, high.z));
    const size_t normal = add(normals.data(), count * sizeof(glm::vec3), of("VEC3"));
    const size_t uv = add(uvs.data(), count * sizeof(glm::vec2), of("VEC2"));
    const size_t indices = add(mesh.indices.data(), mesh.indices.size() * 4,
                               fmt::format(R"("componentType":5125,"count":{},"type":"SCALAR")", mesh.indices.size()));
    meshes.push_back(
        fmt::format(R"({{"primitives":[{{"attributes":{{"POSITION":{},"NORMAL":{},"TEXCOORD_0":{}}},"indices":{}}}]}})",
                    position, normal, uv, indices));
    nodes.push_back(fmt::format(R"({{"name":"{}","mesh":{}}})", piece.name, nodes.size()));
  }
  std::vector<size_t> roots(nodes.size());
  for (size_t i = 0; i < roots.size(); ++i) roots[i] = i;
  std::ofstream(folder / "model.gltf") << fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],"meshes":[{}],)"
      R"("buffers":[{{"uri":"model.bin","byteLength":{}}}],"bufferViews":[{}],"accessors":[{}]}})",
      fmt::join(roots, ","), fmt::join(nodes, ","), fmt::join(meshes, ","), bytes.size(), fmt::join(views, ","),
      fmt::join(accessors, ","));
  std::ofstream(folder / "model.bin", std::ios::binary) << bytes;
}

bool has_objects(const RandomScene& scene) {
  return std::ranges::any_of(scene.pieces, [](const auto& piece) { return piece.kind == RandomScene::Kind::object; });
}

}  // namespace

std::string RandomScene::text(const std::string& model) const {
  std::string toml = fmt::format("# seed {}\n[scene]\nmodel = \"{}\"\n{}\n[objects.\"*\"]\nlayers = false\n", seed, model,
                                 fmt::join(head, "\n"));
  for (const Piece& piece : pieces) toml += fmt::format("{}\n{}\n", piece.head, fmt::join(piece.lines, "\n"));
  return toml;
}

RandomScene random_scene(uint64_t seed, const Library& library) {
  Chance chance(seed);
  RandomScene scene;
  scene.seed = seed;
  scene.head = {"background = " + colour_text(chance), "ambient = " + colour_text(chance)};
  const size_t objects = 1 + chance.below(4);
  for (size_t i = 0; i < objects; ++i) scene.pieces.push_back(random_object(chance, library, i));
  const size_t lights = 1 + chance.below(3);
  for (size_t i = 0; i < lights; ++i) scene.pieces.push_back(random_light(chance, i));
  const size_t views = 1 + chance.below(2);
  for (size_t i = 0; i < views; ++i) scene.pieces.push_back(random_view(chance, i));
  for (const EffectManifest& effect : library.effects) {
    if (effect.scene.empty() || !chance.one_in(2)) continue;
    RandomScene::Piece piece{RandomScene::Kind::effect, "[effects." + effect.name + "]", {}, "", ""};
    add_lines(chance, effect.scene, piece.lines);
    scene.pieces.push_back(std::move(piece));
  }
  return scene;
}

Scene load_random(const RandomScene& scene, const std::filesystem::path& folder, const Library& library) {
  write_model(scene, folder);
  std::ofstream(folder / "scene.toml") << scene.text("model.gltf");
  return load_scene((folder / "scene.toml").string(), library);
}

RandomScene shrunk(RandomScene scene, const std::function<bool(const RandomScene&)>& fails) {
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (size_t i = scene.pieces.size(); i-- > 0;) {
      RandomScene without = scene;
      without.pieces.erase(without.pieces.begin() + static_cast<ptrdiff_t>(i));
      if (has_objects(without) && fails(without)) scene = std::move(without), smaller = true;
    }
    for (size_t i = 0; i < scene.pieces.size(); ++i)
      for (size_t line = scene.pieces[i].lines.size(); line-- > 0;) {
        RandomScene without = scene;
        std::vector<std::string>& lines = without.pieces[i].lines;
        lines.erase(lines.begin() + static_cast<ptrdiff_t>(line));
        if (fails(without)) scene = std::move(without), smaller = true;
      }
  }
  return scene;
}

}  // namespace lamina
