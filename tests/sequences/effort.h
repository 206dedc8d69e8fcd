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

/* A sequence must not be so short that it reaches nothing: beyond one in 100, contacts are left out
   in its stead, all but one in so many */
#define EFFORT_CONTACTS_ONE_IN (EPF_TEST_ONE_IN > 100 ? 5 : 1)

#define EFFORT_OF_WALK(samples) (EFFORT(samples) * EFFORT_CONTACTS_ONE_IN)

#endif
