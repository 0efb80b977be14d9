// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/scene_on_device.h"

#include "harness/cli/common.h"
#include "harness/scene/digest.h"

namespace lamina {

SweptSceneOnDevice::SweptSceneOnDevice(Backend& backend, SweptScene& scenes, const Library& library, const CellOptions& options)
    : backend_(backend),
      scenes_(scenes),
      library_(library),
      options_(options),
      scene_(scenes.scene()),
      plan_(plan_for(options.scene, library, scene_, options.aspect())) {}

void SweptSceneOnDevice::go_to(size_t point, const std::function<void()>& release) {
  const std::string before = std::exchange(device_digest_, "");  // until all is well
  Scene next = scenes_.at(point);
  const std::string device = device_digest(next, library_), meshes = meshes_digest(next);
  scene_ = std::move(next);
  if (device != before || !resources_) {
    release();
    resources_.reset();
    bakes_ = std::make_unique<Bakes>(scene_, *library_.code, DiskCache(options_.cache));
    resources_ =
        std::make_unique<SceneResources>(backend_, scene_, library_, options_.width_px, options_.height_px, bakes_.get());
  } else {
    resources_->update(meshes != meshes_digest_);
  }
  plan_ = plan_for(options_.scene, library_, scene_, options_.aspect());
  meshes_digest_ = meshes;
  device_digest_ = device;
}

}  // namespace lamina
