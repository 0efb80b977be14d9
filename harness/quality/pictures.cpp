// SPDX-License-Identifier: Apache-2.0
// Pictures of an error, for people, and the file they go to.
#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "harness/core/error.h"
#include "harness/quality/pixels.h"

namespace lamina {

DisplayImage difference_picture(const DisplayImage& test, const DisplayImage& reference, double gain) {
  check_pair("difference picture", test, reference);
  if (!std::isfinite(gain) || gain < 0)
    throw Error(ErrorKind::failed, "quality", "difference picture", fmt::format("gain {} is not a number from 0 up", gain));
  DisplayImage picture{test.width, test.height, std::vector<uint8_t>(test.rgb.size())};
  cv::Mat out = as_mat(picture);
  cv::absdiff(as_mat(test), as_mat(reference), out);
  out.convertTo(out, CV_8U, gain);
  return picture;
}

DisplayImage flip_picture(const std::vector<float>& map, int width, int height) {
  DisplayImage picture{width, height, std::vector<uint8_t>(3 * map.size())};
  check_picture("FLIP picture", picture);
  cv::Mat1b level(height, width);
  std::ranges::transform(map, level.begin(), [](float error) {
    if (!(error >= 0 && error <= 1))
      throw Error(ErrorKind::failed, "quality", "FLIP picture", fmt::format("an error of {} is outside [0,1]", error));
    return static_cast<uint8_t>(std::lround(255 * error));
  });
  cv::Mat out = as_mat(picture), bgr;
  cv::applyColorMap(level, bgr, cv::COLORMAP_MAGMA);
  cv::cvtColor(bgr, out, cv::COLOR_BGR2RGB);
  return picture;
}

void write_png(const std::string& path, const DisplayImage& image) {
  check_picture(path, image);
  // The ending chooses OpenImageIO's plugin, so the temporary carries it too.
  const std::string temporary = fmt::format("{}.{}.tmp.png", path, ::getpid());
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("png:compressionLevel", 3);  // of 9: half the time of the library's 6, and files larger by a tenth
  std::string reason;
  if (auto file = OIIO::ImageOutput::create(temporary); !file)
    reason = OIIO::geterror();
  else if (!file->open(temporary, spec) || !file->write_image(OIIO::TypeDesc::UINT8, image.rgb.data()) || !file->close())
    reason = file->geterror();
  std::error_code renaming, ignored;
  if (reason.empty()) std::filesystem::rename(temporary, path, renaming);
  if (renaming) reason = renaming.message();
  if (reason.empty()) return;
  std::filesystem::remove(temporary, ignored);
  throw Error(ErrorKind::failed, "quality", path,
              fmt::format("cannot be written ({}); check the folder and its free space", reason));
}

}  // namespace lamina
