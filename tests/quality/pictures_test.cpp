// SPDX-License-Identifier: Apache-2.0
#include "tests/quality/pictures.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <filesystem>

#include "harness/core/text.h"
#include "tests/folder.h"

namespace lamina {
namespace {

TEST(DifferencePicture, IsTheAbsoluteDifferenceTimesItsGain) {
  const DisplayImage a{2, 1, {10, 20, 30, 0, 255, 7}}, b{2, 1, {13, 20, 0, 255, 0, 7}};
  EXPECT_EQ(difference_picture(a, b, 1).rgb, (std::vector<uint8_t>{3, 0, 30, 255, 255, 0}));
  EXPECT_EQ(difference_picture(a, b, 10).rgb, (std::vector<uint8_t>{30, 0, 255, 255, 255, 0}));
  EXPECT_EQ(difference_picture(a, b, 0.4).rgb, (std::vector<uint8_t>{1, 0, 12, 102, 102, 0}));  // 3 * 0.4 is nearest to 1
}

TEST(DifferencePicture, LeavesItsInputsAloneAndIsBlackWhereEqual) {
  const DisplayImage a = noise(9, 5, 1), before = a;
  EXPECT_EQ(difference_picture(a, a, 64).rgb, std::vector<uint8_t>(3 * 9 * 5));
  EXPECT_EQ(a.rgb, before.rgb);
}

TEST(DifferencePicture, RefusesTwoSizesAndASenselessGain) {
  const DisplayImage a = flat(4, 3, grey(1));
  EXPECT_NE(refusal([&] { difference_picture(a, flat(3, 4, grey(1)), 1); }), "");
  for (const double gain : {-1.0, std::nan(""), HUGE_VAL}) EXPECT_NE(refusal([&] { difference_picture(a, a, gain); }), "");
}

TEST(FlipPicture, RunsFromMagmasBlackToItsPaleYellow) {
  // Magma's ends, as its authors publish them: (0.001462, 0.000466, 0.013866) and (0.987053, 0.991438, 0.749504).
  const std::vector<uint8_t> ends = flip_picture({0, 1}, 2, 1).rgb;
  const double expected[] = {0.001462, 0.000466, 0.013866, 0.987053, 0.991438, 0.749504};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(ends[i], 255 * expected[i], 1) << i;
}

TEST(FlipPicture, GetsLighterWithTheError) {
  std::vector<float> ramp;
  for (int code = 0; code < 256; ++code) ramp.push_back(static_cast<float>(code) / 255);
  const std::vector<uint8_t> rgb = flip_picture(ramp, 256, 1).rgb;
  const auto luma = [&](size_t i) { return 0.2126 * rgb[3 * i] + 0.7152 * rgb[3 * i + 1] + 0.0722 * rgb[3 * i + 2]; };
  for (size_t i = 8; i < 256; ++i) EXPECT_GT(luma(i), luma(i - 8)) << i;
}

TEST(FlipPicture, KeepsRowsInOrder) {
  const std::vector<uint8_t> tall = flip_picture({0, 0.25f, 0.5f, 0.75f, 1, 0}, 2, 3).rgb;
  EXPECT_EQ(tall, flip_picture({0, 0.25f, 0.5f, 0.75f, 1, 0}, 6, 1).rgb);
}

TEST(FlipPicture, RefusesAnotherSizeAndErrorsOutOfRange) {
  EXPECT_NE(refusal([] { flip_picture({0, 0, 0}, 2, 2); }), "");
  EXPECT_NE(refusal([] { flip_picture({}, 0, 0); }), "");
  for (const float error : {-0.1f, 1.1f, std::nanf("")}) EXPECT_NE(refusal([&] { flip_picture({error}, 1, 1); }), "") << error;
}

class WritePng : public InFolder<> {
 protected:
  size_t files() const { return own_.files(); }
};

TEST_F(WritePng, ReadsBackTheSamePixelsAndLeavesNoTemporary) {
  const std::string path = folder_ / "a.png";
  const DisplayImage image = noise(13, 7, 1);
  write_png(path, flat(5, 5, grey(3)));
  write_png(path, image);
  EXPECT_EQ(files(), 1);
  const auto file = OIIO::ImageInput::open(path);
  ASSERT_TRUE(file) << OIIO::geterror();
  const OIIO::ImageSpec& spec = file->spec();
  EXPECT_STREQ(file->format_name(), "png");
  EXPECT_EQ(spec.get_string_attribute("oiio:ColorSpace"), "sRGB");
  ASSERT_EQ((std::array{spec.width, spec.height, spec.nchannels}), (std::array{13, 7, 3}));
  std::vector<uint8_t> rgb(image.rgb.size());
  ASSERT_TRUE(file->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, rgb.data()));
  EXPECT_EQ(rgb, image.rgb);
}

TEST_F(WritePng, GivesTheSameBytesForTheSamePicture) {
  write_png(folder_ / "a.png", noise(13, 7, 1));
  write_png(folder_ / "b.png", noise(13, 7, 1));
  EXPECT_EQ(read_file(folder_ / "a.png", "test"), read_file(folder_ / "b.png", "test"));
}

TEST_F(WritePng, SaysWhereItCannotWriteAndLeavesNothing) {
  const std::string message = refusal([&] { write_png(folder_ / "none" / "a.png", flat(2, 2, grey(1))); });
  EXPECT_NE(message.find("Could not open file"), std::string::npos) << message;
  std::filesystem::create_directories(folder_ / "b.png");  // a folder is in the way
  EXPECT_NE(refusal([&] { write_png(folder_ / "b.png", flat(2, 2, grey(1))); }), "");
  EXPECT_EQ(files(), 1);
  EXPECT_NE(refusal([&] { write_png(folder_ / "c.png", {}); }).find("empty"), std::string::npos);
  EXPECT_NE(refusal([&] { write_png(folder_ / "c.png", {2, 2, {1, 2, 3}}); }).find("3 values where 12"), std::string::npos);
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace lamina
