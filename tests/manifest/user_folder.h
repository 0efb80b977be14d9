// SPDX-License-Identifier: Apache-2.0
// A user's own folder of effects and variants, and what loading it says.
#pragma once

#include "harness/core/error.h"
#include "harness/manifest/library.h"
#include "tests/folder.h"

namespace lamina {

class UserFolder : public InFolder<> {
 protected:
  // "" when it loads.
  std::string loading_says() const {
    try {
      load_library(LAMINA_SOURCE_DIR, effect_code(), {folder_});
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      return error.what();
    }
  }
};

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

}  // namespace lamina
