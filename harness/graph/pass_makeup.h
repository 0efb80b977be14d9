// SPDX-License-Identifier: Apache-2.0
// What a pass is made of, without running it: how many of the device's passes, triangles, and texels of its attachments.
#pragma once

#include <map>

#include "harness/graph/counts.h"
#include "harness/manifest/variant_manifest.h"

namespace lamina {

// Adds one of the device's passes that stands for the manifest's, or for a part of it. `targets`: every target that it writes.
void add_makeup(PassCounts& of, const Pass& pass, const PassManifest& manifest,
                const std::map<TextureId, TextureDesc>& targets);

}  // namespace lamina
