// SPDX-License-Identifier: Apache-2.0
// Text on its way into XML ("Extensible Markup Language (XML) 1.0", 5th edition, W3C 2008).
#pragma once

#include <string>
#include <string_view>

namespace lamina {

// UTF-8 for element content and for attribute values in double quotes. Characters outside production 2 (controls but tab and
// line ends, surrogates, U+FFFE, U+FFFF) are left out, and so are bytes that are not UTF-8. Tab and line ends become character
// references, for a reader takes those in an attribute for spaces.
std::string escaped_xml(std::string_view text);

}  // namespace lamina
