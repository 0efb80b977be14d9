// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/split_overlaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>

#include "harness/scene/declare.h"
#include "harness/scene/mesh/unwrap_check.h"
#include "harness/scene/mesh/uv_raster.h"

namespace lamina {
namespace {

// Charts touch along borders whose vertices exporters have rounded: a chart overlaps where it shares more than this of its
// texels.
constexpr double shared_border = 0.02;

// The triangles of each chart, charts in the order of their first triangle.
std::vector<std::vector<size_t>> charts_of(const Mesh& mesh) {
  boost::disjoint_sets_with_storage<> sets(mesh.vertices.size());  // of vertices
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    for (size_t c = 1; c < 3; ++c) sets.union_set(mesh.indices[i], mesh.indices[i + c]);
  std::map<size_t, size_t> chart_of_set;
  std::vector<std::vector<size_t>> charts;
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto [entry, is_new] = chart_of_set.try_emplace(sets.find_set(mesh.indices[i]), charts.size());
    if (is_new) charts.emplace_back();
    charts[entry->second].push_back(i / 3);
  }
  return charts;
}

struct Part {
  std::vector<bool> taken = std::vector<bool>(uv_raster_size * uv_raster_size, false);
  std::vector<size_t> triangles;
};

Mesh mesh_of(const Mesh& whole, std::vector<size_t> triangles) {
  std::sort(triangles.begin(), triangles.end());
  Mesh mesh;
  std::map<uint32_t, uint32_t> moved;
  for (const size_t triangle : triangles)
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t vertex = whole.indices[3 * triangle + c];
      const auto [entry, is_new] = moved.try_emplace(vertex, static_cast<uint32_t>(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(whole.vertices[vertex]);
      mesh.indices.push_back(entry->second);
    }
  return mesh;
}

}  // namespace

std::vector<Mesh> split_overlaps(const Mesh& mesh) {
  std::vector<Part> parts;
  for (const std::vector<size_t>& chart : charts_of(mesh)) {
    std::vector<uint32_t> texels;
    for (const size_t triangle : chart) {
      const std::vector<uint32_t> covered = covered_texels(mesh, triangle);
      texels.insert(texels.end(), covered.begin(), covered.end());
    }
    const auto fits = [&](const Part& part) {
      const auto shared = std::count_if(texels.begin(), texels.end(), [&](uint32_t texel) { return part.taken[texel]; });
      return static_cast<double>(shared) <= shared_border * static_cast<double>(texels.size());
    };
    auto part = std::find_if(parts.begin(), parts.end(), fits);
    if (part == parts.end()) part = parts.size() < max_parts ? parts.emplace(parts.end()) : parts.end() - 1;
    for (const uint32_t texel : texels) part->taken[texel] = true;
    part->triangles.insert(part->triangles.end(), chart.begin(), chart.end());
  }
  if (parts.size() <= 1) return {mesh};
  std::vector<Mesh> meshes;
  for (Part& part : parts) meshes.push_back(mesh_of(mesh, std::move(part.triangles)));
  return meshes;
}

namespace {

bool needs_unique_unwrap(const Object& object, const Library& library) {
  const std::vector<const EffectManifest*> effects = effects_of(object, library);
  return std::any_of(effects.begin(), effects.end(), [](const EffectManifest* effect) { return effect->unique_unwrap; });
}

}  // namespace

void split_overlapping_objects(std::vector<Object>& objects, const Library& library, OverlapFractions& overlaps,
                               std::vector<std::string>& warnings) {
  std::vector<Object> settled;
  for (Object& object : objects) {
    std::vector<Mesh> parts;
    if (needs_unique_unwrap(object, library) && unwrap_problem(object.mesh).empty() && overlaps.of(object.mesh) > 0)
      parts = split_overlaps(object.mesh);
    if (parts.size() <= 1) {
      settled.push_back(std::move(object));
      continue;
    }
    warnings.push_back(fmt::format("Parts of {} share texels; it is drawn as {} objects, each with a light map of its own.",
                                   object.name, parts.size()));
    for (size_t i = 0; i < parts.size(); ++i) {
      Object& part = settled.emplace_back(object);
      part.mesh = std::move(parts[i]);
      if (i > 0) part.name += fmt::format(".{}", i + 1);
    }
  }
  objects = std::move(settled);
}

bool uses_unwrap(const Object& object, const Library& library) {
  if (needs_unique_unwrap(object, library)) return true;
  for (const EffectManifest* effect : effects_of(object, library))
    for (const NumberManifest& number : effect->object.numbers)
      if (number.over_unwrap && fact_or_number(object.effects.find(effect->name)->second, number.name) > 0) return true;
  return false;
}

}  // namespace lamina
