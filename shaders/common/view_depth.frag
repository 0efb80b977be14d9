// SPDX-License-Identifier: Apache-2.0
// View depth in metres along the view's axis, as interpolated: a depth buffer's value loses metres at a distance.
layout(location = 0) in float in_view_depth;
layout(location = 0) out float out_view_depth;

void main() { out_view_depth = in_view_depth; }
