// SPDX-License-Identifier: Apache-2.0
// The mirror's picture is wider than the frame by this each way: waves send rays beyond what a still mirror shows.
const float mirror_guard = 1.3;
