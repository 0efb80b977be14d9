// SPDX-License-Identifier: Apache-2.0
// Which device --device means.
#include "harness/backend/common/choose_device.h"

#include <gtest/gtest.h>

namespace lamina {
namespace {

std::vector<DeviceInfo> named(const std::vector<std::string>& names) {
  std::vector<DeviceInfo> devices;
  for (const std::string& name : names)
    devices.push_back({.backend = "vulkan", .device = name, .software = name == "llvmpipe"});
  return devices;
}

std::string refusal(const std::vector<DeviceInfo>& devices, const char* wanted, ErrorKind kind) {
  try {
    choose_device("vulkan", devices, wanted);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    return error.what();
  }
  ADD_FAILURE() << wanted << " is taken";
  return "";
}

TEST(ChooseDevice, ByPartOfOneNameInAnyCase) {
  const std::vector<DeviceInfo> devices = named({"Radeon RX 6600", "GeForce RTX 3080", "llvmpipe"});
  EXPECT_EQ(choose_device("vulkan", devices, "radeon"), 0u);
  EXPECT_EQ(choose_device("vulkan", devices, "3080"), 1u);
  EXPECT_EQ(choose_device("vulkan", devices, "2"), 2u) << "a number is a place";
  EXPECT_EQ(choose_device("vulkan", devices, ""), 2u) << "the first on the CPU";
}

TEST(ChooseDevice, TwoNamesWithThePartAreRefused) {
  const std::vector<DeviceInfo> devices = named({"GeForce RTX 3080", "GeForce RTX 3080 Ti", "llvmpipe"});
  const std::string said = refusal(devices, "geforce", ErrorKind::bad_input);
  EXPECT_NE(said.find("2 devices have this in their names (0: GeForce RTX 3080, 1: GeForce RTX 3080 Ti)"), std::string::npos)
      << said;
  EXPECT_EQ(choose_device("vulkan", devices, "GeForce RTX 3080"), 0u) << "the whole name of one";
  EXPECT_EQ(choose_device("vulkan", devices, "Ti"), 1u);
  refusal(named({"same", "same"}), "same", ErrorKind::bad_input);
}

TEST(ChooseDevice, NoneIsNoDevice) {
  const std::string said = refusal(named({"llvmpipe"}), "geforce", ErrorKind::no_device);
  EXPECT_NE(said.find("0: llvmpipe"), std::string::npos) << said;
  refusal(named({"llvmpipe"}), "1", ErrorKind::no_device);
}

}  // namespace
}  // namespace lamina
