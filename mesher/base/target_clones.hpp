#pragma once

/// Compiles a function once more for each wider vector unit; the program selects the version for
/// its machine at start-up. All versions perform the same operations in the same order, without
/// contraction (-ffp-contract=off), so they return the same bits.
///
/// Example usage:
///
///     PCVT_TARGET_CLONES void scale(double c, double* x, int n) {
///         for (int i = 0; i < n; ++i) x[i] *= c;
///     }
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PCVT_TARGET_CLONES \
    __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define PCVT_TARGET_CLONES
#endif
