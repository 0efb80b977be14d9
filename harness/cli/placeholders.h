// SPDX-License-Identifier: Apache-2.0
// What stands for an option's value in the help: --backend BACKEND. The word is the option's type; what may stand in its place
// is found by it (values.h), for completion and the manual.
#pragma once

namespace lamina::placeholder {

inline constexpr const char *scene = "SCENE", *backend = "BACKEND", *device = "DEVICE", *variant = "VARIANT",
                            *function = "FUNCTION", *family = "FAMILY", *view = "VIEW", *set = "PATH=VALUES",
                            *limit = "METRIC=NUMBER", *schedule = "POINTS", *size = "WIDTHxHEIGHT", *shard = "K/N",
                            *shell = "SHELL", *command = "COMMAND", *directory = "DIR", *file = "FILE", *record = "RECORD",
                            *gate_file = "GATE.toml", *schema = "KIND";

}  // namespace lamina::placeholder
