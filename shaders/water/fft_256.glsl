// SPDX-License-Identifier: Apache-2.0
// The inverse Fourier transform, without a factor, of 256 complex numbers, two sequences at a time in each of two arrays: by a group of
// 128 threads, in shared memory. Stockham's form, whose stages leave all in order (Cooley and Tukey 1965; Govindaraju and others,
// "High Performance Discrete Fourier Transforms on Graphics Processors", SC 2008, section 4).
layout(local_size_x = 128) in;

const uint fft_side = 256u;
shared vec4 fft_first[2u * fft_side], fft_second[2u * fft_side];  // what a stage reads, and what it writes, in turns

vec2 complex_product(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

// Of what lies in the first halves; the results lie there too. All threads of the group call it after they have written.
void fft_256() {
  for (uint stage = 0u; stage < 8u; ++stage) {
    barrier();
    uint span = 1u << stage, from = (stage & 1u) * fft_side, to = fft_side - from;
    for (uint i = gl_LocalInvocationID.x; i < fft_side; i += 128u) {
      uint even = (i / (2u * span)) * span + (i & (span - 1u)), odd = even + fft_side / 2u;
      float turn = 6.28318531 * float(i & (2u * span - 1u)) / float(2u * span);
      vec2 twiddle = vec2(cos(turn), sin(turn));
      vec4 a = fft_first[from + odd], b = fft_second[from + odd];
      fft_first[to + i] = fft_first[from + even] + vec4(complex_product(a.xy, twiddle), complex_product(a.zw, twiddle));
      fft_second[to + i] = fft_second[from + even] + vec4(complex_product(b.xy, twiddle), complex_product(b.zw, twiddle));
    }
  }
  barrier();
}
