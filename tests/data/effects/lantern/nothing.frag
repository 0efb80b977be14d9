// SPDX-License-Identifier: Apache-2.0
// Depth alone is drawn.
void main() {}
