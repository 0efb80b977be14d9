// SPDX-License-Identifier: Apache-2.0
// lamina diff on pictures made here, whose figures are known.
#include "tests/cli/program.h"

namespace lamina {
namespace {

class Diff : public ProgramTest {
 protected:
  // A grey of this code, 32 x 24; the upper half another one.
  std::string grey(const std::string& name, uint8_t upper, uint8_t lower, int width = 32) {
    DisplayImage image{width, 24, std::vector<uint8_t>(size_t(width) * 24 * 3, lower)};
    std::fill_n(image.rgb.begin(), image.rgb.size() / 2, upper);
    write_png((folder_ / name).string(), image);
    return (folder_ / name).string();
  }
};

TEST_F(Diff, SaysEveryFigureAndLeavesAPage) {
  const std::string a = grey("a.png", 100, 100), b = grey("b.png", 110, 100), mask = grey("mask.png", 255, 0);
  const Outcome outcome = lamina_program("diff " + a + " " + b + " --mask " + mask + " --out " + out().string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_SAYS(outcome.output, "32 x 24 pixels");
  EXPECT_SAYS(outcome.output, "masked         384 pixels  PSNR 28.1 dB");  // 20 log10(255 / 10)
  EXPECT_SAYS(outcome.output, "whole          768 pixels  PSNR 31.1 dB");  // half of the pixels: 3.01 dB more
  EXPECT_SAYS(outcome.output, "SSIM without the 5 pixels at the border");
  ASSERT_EQ(record().cells.size(), 2u);
  const CellRow cell = record().cells[1];
  EXPECT_NEAR(cell.error_frame->psnr_db, 31.14, 0.01);
  EXPECT_EQ(cell.covered_pixels, 384u);
  for (const std::string& file : {cell.image, cell.difference, cell.flip, std::string("index.html")})
    EXPECT_TRUE(std::filesystem::exists(out() / file)) << file;
}

TEST_F(Diff, APictureAgainstItselfHasNoError) {
  const std::string a = grey("a.png", 100, 50);
  const Outcome outcome = lamina_program("diff " + a + " " + a);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_SAYS(outcome.output, "PSNR inf dB  SSIM 1.000000  FLIP 0.000000  RMSE 0  max 0");
}

TEST_F(Diff, SizesThatDifferAndFilesThatAreNoneAreRefused) {
  const std::string a = grey("a.png", 100, 50), wide = grey("wide.png", 100, 50, 33), none = grey("none.png", 0, 0);
  for (const auto& [arguments, words] : {std::pair{a + " " + wide, "33 x 24 pixels, the reference 32 x 24"},
                                         {a + " " + a + " --mask " + wide, "33 x 24"},
                                         {a + " " + a + " --mask " + none, "no pixel counts"},
                                         {a + " gone.png", "gone.png"}}) {
    const Outcome outcome = lamina_program("diff " + arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_SAYS(outcome.output, words);
  }
}

}  // namespace
}  // namespace lamina
