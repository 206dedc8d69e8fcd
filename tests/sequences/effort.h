/* SPDX-License-Identifier: MIT */
/*
 * How much of a long test is run: all of it on a host, on an emulated core one in EPF_TEST_ONE_IN of
 * its samples, which CMake defines. It changes what is covered, and no tolerance.
 */
#ifndef EPF_TESTS_EFFORT_H
#define EPF_TESTS_EFFORT_H

#define EFFORT(samples) ((samples) / EPF_TEST_ONE_IN)

/* Of what is repeated so often that even that is too long */
#define EFFORT_SQUARED(samples) EFFORT(EFFORT(samples))

#endif
