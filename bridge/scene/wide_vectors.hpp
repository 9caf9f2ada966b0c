// SPDX-License-Identifier: GPL-3.0-or-later
// Before a function: it has the instructions of newer processors where there are any, without fused operations. All
// make the same bits. What it calls is to be inlined into it.
#pragma once

#if defined(__x86_64__) && !defined(__clang__)
#define BLOCKWEIR_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define BLOCKWEIR_WIDE_VECTORS
#endif
