#pragma once

#if !defined(__GNUC__)
#error "moserhex needs the vector extensions of GCC or Clang"
#endif

/** 1 under the address or thread sanitizer, of GCC or Clang. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MOSERHEX_INSTRUMENTED 1
#elif defined(__has_feature)
#define MOSERHEX_INSTRUMENTED (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#else
#define MOSERHEX_INSTRUMENTED 0
#endif

/** Compiles a kernel for several instruction sets and picks one when the program starts. All give the same bits: the
 * lanes are independent, their number is fixed, and multiply-add contraction is off for these files. Not with the
 * sanitizers, whose runtime is not up when the choice is made. */
#if defined(__x86_64__) && defined(__gnu_linux__) && !MOSERHEX_INSTRUMENTED
#define MOSERHEX_KERNEL __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define MOSERHEX_KERNEL
#endif

/** Inlined whatever the compiler thinks of it, so that a kernel's helpers take its instruction set. */
#define MOSERHEX_INLINE inline __attribute__((always_inline))
