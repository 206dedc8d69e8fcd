/* SPDX-License-Identifier: MIT */
/*
 * A driving force from tables: straight lines between points, and sines added over some spans of time.
 */
#ifndef PLANT_DRIVE_H
#define PLANT_DRIVE_H

typedef struct {
    double time, force; /* s, N */
} drive_point_t;

typedef struct {
    double start, end;           /* s; not at the end itself */
    double amplitude, frequency; /* N, Hz */
} drive_sine_t;

typedef struct {
    const drive_point_t
        *points; /* at least two, time rising; the first and last line go on for ever */
    int n_points;
    const drive_sine_t *sines;
    int n_sines;
} drive_t;

/* The force of a drive_t at a time, N: of the type that a slide takes */
double drive_force(const void *context, double time);

#endif
