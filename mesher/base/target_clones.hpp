#pragma once

/// Marks a function to be compiled a second time for wider vector units, and the fitting one to be
/// chosen when the program starts. Both do the same operations in the same order, without
/// contraction (-ffp-contract=off), so that both give the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PCVT_TARGET_CLONES \
    __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define PCVT_TARGET_CLONES
#endif
