#pragma once

/// Marks a plain loop that is compiled once for each width of vector registers, the widest that the machine
/// has being chosen at start. No operation is contracted or reordered, so that all versions give the same
/// bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define AOSCORE_VECTORISE [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define AOSCORE_VECTORISE
#endif
