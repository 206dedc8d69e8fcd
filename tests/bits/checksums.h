/* SPDX-License-Identifier: MIT */
/*
 * What the outputs of each variant come to on every target. A change of the kernels that is meant to
 * change bits changes these lines: each test prints its own as it should stand here.
 */
#ifndef EPF_TESTS_CHECKSUMS_H
#define EPF_TESTS_CHECKSUMS_H

#define CHECKSUM_F32            0x559600c0u
#define CHECKSUM_F32_MEAN_VALUE 0x5638cf03u

#define CHECKSUM_Q31 0xc01dfefdu
#define CHECKSUM_Q15 0xea9ad924u

#define CHECKSUM_Q31_MEAN_VALUE 0x68535948u
#define CHECKSUM_Q15_MEAN_VALUE 0x2ba12fa7u

#endif
