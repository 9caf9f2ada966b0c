// SPDX-License-Identifier: GPL-3.0-or-later
// The wide registers of newer processors: used where there are any, and given free where they are not in use.
#pragma once

// Before a function: it has their instructions, without fused operations. All processors make the same bits. What it
// calls is to be inlined into it.
#if defined(__x86_64__) && !defined(__clang__)
#define BLOCKWEIR_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define BLOCKWEIR_WIDE_VECTORS
#endif

namespace blockweir {

#if defined(__x86_64__)
[[gnu::target("avx")]] inline void zero_upper_halves() {
  asm volatile("vzeroupper");
}

/// Instructions on narrow vectors wait for the upper halves of registers while these are in use. On some processors
/// they are after each switch between processes, until this is called.
inline void free_upper_halves() {
  if (__builtin_cpu_supports("avx") != 0) zero_upper_halves();
}
#else
inline void free_upper_halves() {}
#endif

}  // namespace blockweir
