// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/transparent_object.h"

namespace lamina {

Object transparent_object(std::string name, Mesh mesh, const GlassLook& look) {
  Object object;
  object.name = std::move(name);
  object.mesh = std::move(mesh);
  object.said.calls.insert("transparency");
  object.said.values = {{"transparency.color", {look.color}},       {"transparency.opacity", {look.opacity}},
                        {"transparency.specular", {look.specular}}, {"transparency.gloss", {look.gloss}},
                        {"transparency.slant", {look.slant}},       {"albedo", {look.color}}};
  return object;
}

}  // namespace lamina
