/* SPDX-License-Identifier: MIT */
#include "trigger.h"

#include <math.h>

bool trigger_look(trigger_t *trigger, double x, double time, update_t *update)
{
    const double dx = x - trigger->x;
    const double dt = time - trigger->time;
    if (!(fabs(dx) >= trigger->spacing && dt > 0.0)) {
        return false;
    }
    *update = (update_t){dx, dt, dx / dt};
    trigger->x = x;
    trigger->time = time;
    return true;
}
