/* SPDX-License-Identifier: MIT */
#include "drive.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

static double line(const drive_t *drive, double time)
{
    int i = 1;
    while (i < drive->n_points - 1 && time >= drive->points[i].time) {
        i++;
    }
    const drive_point_t from = drive->points[i - 1];
    const drive_point_t to = drive->points[i];
    const double share = (time - from.time) / (to.time - from.time);
    return from.force + share * (to.force - from.force);
}

double drive_force(const void *context, double time)
{
    const drive_t *drive = context;
    double force = line(drive, time);
    for (int i = 0; i < drive->n_sines; i++) {
        const drive_sine_t *sine = &drive->sines[i];
        if (time >= sine->start && time < sine->end) {
            const double phase = 2.0 * pi * sine->frequency * (time - sine->start);
            force += sine->amplitude * sin(phase);
        }
    }
    return force;
}
