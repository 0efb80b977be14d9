// SPDX-License-Identifier: Apache-2.0
// A heap that moves times less. A software rasterizer keeps textures and targets on the heap. In pages of 4 KiB their place in
// physical memory is whatever other programs have left, which makes passes slower, and by another amount in each process.
#pragma once

namespace lamina {

// Makes the heap grow by 1 GiB of addresses at once, asks for huge pages there, and lets blocks of up to 32 MiB lie on it in
// place of mappings of their own. Memory is taken as it is touched, in pieces of 2 MiB. Call it once, at the start of a
// process; forked processes inherit it. Without effect where the kernel has no huge pages to give, or another allocator is
// linked.
void use_steady_heap();

}  // namespace lamina
