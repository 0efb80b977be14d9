// SPDX-License-Identifier: Apache-2.0
// A timer's certificate is measured once a day, device and driver; one that failed, is old or cannot be read is measured again.
#include "harness/record/kept_certificate.h"

#include <gtest/gtest.h>

#include <fstream>

#include "harness/core/text.h"
#include "tests/folder.h"

namespace lamina {
namespace {

namespace fs = std::filesystem;

class KeptCertificate : public InFolder<> {
 protected:
  // What is asked for now; counts how often it is measured.
  TimerRow ask(const DeviceInfo& device, bool holds = true) {
    const CertificateCache kept(device, LAMINA_SOURCE_DIR "/shaders", cache_);
    if (const std::optional<TimerRow> row = kept.find()) return *row;
    ++measured_;
    TimerRow row;
    row.backend = device.backend, row.ok = holds, row.linearity = {1, 1, 1, 1}, row.reason = holds ? "" : "busy";
    kept.keep(row);
    return row;
  }
  fs::path file() const { return fs::directory_iterator(folder_)->path(); }

  fs::path cache_ = folder_;
  int measured_ = 0;
  const DeviceInfo device_{.backend = "vulkan", .device = "a", .driver = "1"};
};

TEST_F(KeptCertificate, IsMeasuredOnceADeviceAndDriver) {
  EXPECT_FALSE(ask(device_).age_s.has_value());
  const TimerRow again = ask(device_);
  EXPECT_TRUE(again.ok);
  ASSERT_TRUE(again.age_s.has_value());
  EXPECT_GE(*again.age_s, 0);
  EXPECT_EQ(again.linearity, (std::vector<double>{1, 1, 1, 1}));
  EXPECT_EQ(measured_, 1);
  DeviceInfo other = device_;
  other.driver = "2";
  EXPECT_FALSE(ask(other).age_s.has_value());
  EXPECT_EQ(measured_, 2);
}

TEST_F(KeptCertificate, OneThatFailedIsNotKept) {
  EXPECT_FALSE(ask(device_, false).ok);
  EXPECT_TRUE(fs::is_empty(folder_)) << "nothing was kept";
  EXPECT_TRUE(ask(device_).ok);
  EXPECT_EQ(measured_, 2);
}

TEST_F(KeptCertificate, OneOfYesterdayOrOfTomorrowIsMeasuredAgain) {
  ask(device_);
  const std::string text = read_file(file(), "test");
  const std::string bytes = text.substr(text.find('\n') + 1);
  const double now_s = std::stod(bytes.substr(bytes.find(':') + 1));
  for (const double shift_s : {-25 * 3600.0, 3600.0}) {
    std::string moved = bytes;
    moved.replace(bytes.find(':') + 1, bytes.find(',') - bytes.find(':') - 1, fmt::format("{:.0f}", now_s + shift_s));
    std::ofstream(file()) << "lamina cache 1 " << hash_hex(moved) << "\n" << moved;
    const int before = measured_;
    EXPECT_FALSE(ask(device_).age_s.has_value()) << shift_s;
    EXPECT_EQ(measured_, before + 1) << shift_s;
  }
}

TEST_F(KeptCertificate, OneThatCannotBeReadIsMeasuredAgain) {
  for (const std::string bytes : {"", "{}", "{\"measured_at_s\":1e300,\"timer\":{}}", "[]"}) {
    ask(device_);
    std::ofstream(file()) << "lamina cache 1 " << hash_hex(bytes) << "\n" << bytes;
    const int before = measured_;
    EXPECT_TRUE(ask(device_).ok);
    EXPECT_EQ(measured_, before + 1) << bytes;
  }
}

TEST_F(KeptCertificate, WithoutACacheItIsMeasuredEveryTime) {
  cache_.clear();
  ask(device_);
  EXPECT_FALSE(ask(device_).age_s.has_value());
  EXPECT_EQ(measured_, 2);
}

}  // namespace
}  // namespace lamina
