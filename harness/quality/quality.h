// SPDX-License-Identifier: Apache-2.0
// How far a picture is from a reference. One header for all figures; one file for each metric.
//
// Display pictures are 8-bit sRGB: linear light clamped to [0,1], encoded by IEC 61966-2-1, rounded to nearest. PSNR, SSIM and
// FLIP are taken on those; RMSE and maximum on linear light.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/core/image.h"

namespace lamina {

// 8-bit sRGB, three bytes a pixel, row 0 on top.
struct DisplayImage {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;
};
// Infinities clamp. Throws Error(failed) for a NaN in r, g or b, so that no figure is ever made of one.
DisplayImage to_display(const Image& linear);

// All of these throw Error(failed, "quality", ...) when sizes differ, when either picture is empty, or when a mask selects
// nothing; the linear ones also when a counted pixel is not finite in r, g, b or a. A null mask counts every pixel.

// Peak signal-to-noise ratio over r, g and b, peak 255, in dB, from OpenCV's sum of squares (cv::norm, which knows masks).
// +infinity for equal pictures.
double psnr_db(const DisplayImage& test, const DisplayImage& reference, const Mask* mask = nullptr);
// Structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004; 11x11 Gaussian of sigma 1.5), mean over r, g, b and counted
// pixels, from the quality map of OpenCV's QualitySSIM. 1 for equal pictures.
double ssim(const DisplayImage& test, const DisplayImage& reference, const Mask* mask = nullptr);
// FLIP's error of every pixel, in [0,1] (Andersson et al. 2020). Throws also for pixels per degree outside 1 to 1000.
inline constexpr double default_pixels_per_degree = 67.020643276582255;  // 0.7 m away, 0.7 m wide, 3840 pixels
std::vector<float> flip_map(const DisplayImage& test, const DisplayImage& reference,
                            double pixels_per_degree = default_pixels_per_degree);
double flip_mean(const std::vector<float>& map, const Mask* mask = nullptr);
// Root of the mean squared difference and greatest absolute difference over r, g and b, linear light.
double rmse_linear(const Image& test, const Image& reference, const Mask* mask = nullptr);
double max_linear(const Image& test, const Image& reference, const Mask* mask = nullptr);
// Greatest absolute difference of alpha.
double max_alpha(const Image& test, const Image& reference, const Mask* mask = nullptr);
// Maximum minus minimum of a channel, for the channel of r, g and b where it is greatest, linear light. 0: one colour
// everywhere.
double range_linear(const Image& picture, const Mask* mask = nullptr);
// Pixels with a NaN or infinity in any of r, g, b, a.
size_t nonfinite_pixels(const Image& image);

// Where a map is worst: the tile of worst_tile_px x worst_tile_px pixels, on a grid from the top left and cut at the right and
// lower edges, with the greatest mean; of equal ones the first by rows. Throws Error(failed) where the map is empty or not
// width x height long.
inline constexpr int worst_tile_px = 32;
struct WorstTile {
  int x = 0, y = 0;  // of its upper left pixel
  int size = worst_tile_px;
  double flip = 0;  // mean over the tile's pixels
};
WorstTile worst_tile(const std::vector<float>& map, int width, int height);

// The figures of one comparison over one set of pixels.
struct ErrorFigures {
  double psnr_db = 0;  // may be +infinity
  double ssim = 0;
  double flip = 0;
  double rmse_linear = 0;
  double max_linear = 0;
};
struct ErrorReport {
  ErrorFigures covered;     // over the mask
  ErrorFigures frame;       // over every pixel
  std::vector<float> flip;  // FLIP's map, for the picture
};
// Throws as above, and when a pixel of either picture is not finite: no figure is made of such a picture.
ErrorReport measure_error(const Image& test, const Image& reference, const Mask& covered);

// Pictures for people, 8-bit sRGB.
// |test - reference| of the display values, times `gain` (from 0 up, else it throws), clamped: black where equal.
DisplayImage difference_picture(const DisplayImage& test, const DisplayImage& reference, double gain);
// FLIP's map through the magma colour map. Throws for an error outside [0,1].
DisplayImage flip_picture(const std::vector<float>& map, int width, int height);

// Writes a PNG through OpenImageIO, atomically. Throws Error(failed).
void write_png(const std::string& path, const DisplayImage& image);

}  // namespace lamina
