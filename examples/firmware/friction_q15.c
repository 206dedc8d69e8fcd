/* SPDX-License-Identifier: MIT */
#include "contact.h"
#include "friction.h"
#include "guard.h"

#include <epf/q15.h>

static const epf_q15_coeffs_t slide = EPF_Q15_COEFFS(SLIDE, SIGNALS); /* in flash */
static epf_q15_t friction;

void friction_start(void)
{
    epf_q15_init(&friction, &slide);
}

void friction_advance(int16_t dx)
{
    (void)epf_q15_advance(&friction, dx);
}

void friction_publish(uint16_t dt)
{
    (void)epf_q15_force(&friction, dt);
}

void friction_speed(int16_t v)
{
    epf_q15_set_velocity(&friction, v);
}

int32_t friction_force(void)
{
    const guard_t guard = guard_enter();
    const int16_t force = epf_q15_output(&friction);
    guard_leave(guard);
    return force;
}

uint32_t friction_digest(uint32_t digest)
{
    return fold(fold(digest, (uint32_t)epf_q15_z(&friction)), (uint32_t)epf_q15_output(&friction));
}
