/* SPDX-License-Identifier: MIT */
/* What the sources tell a compiler about where code is to stand. None of it changes what is computed. */
#ifndef EPF_COMPILER_H
#define EPF_COMPILER_H

/* Of two ways the usual one should be the straight one */
#ifdef __GNUC__
#define LIKELY(x) __builtin_expect(!!(x), 1)
#else
#define LIKELY(x) (x)
#endif

/* A function that is called as it stands, so that the short path around it saves fewer registers; and
   one that becomes a part of each of its callers */
#if defined(__clang__)
#define OUT_OF_LINE __attribute__((noinline))
#define IN_LINE     inline __attribute__((always_inline))
#elif defined(__GNUC__)
#define OUT_OF_LINE __attribute__((noinline, noclone))
#define IN_LINE     inline __attribute__((always_inline))
#else
#define OUT_OF_LINE
#define IN_LINE inline
#endif

/* What is a function of its own where registers are few, so that each step needs only those which a call
   may use, and otherwise a part of its callers */
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__) || defined(__AVR__)
#define LEAF OUT_OF_LINE
#elif defined(__OPTIMIZE_SIZE__)
#define LEAF inline
#else
#define LEAF IN_LINE
#endif

#endif
