/* SPDX-License-Identifier: MIT */
#include "contact.h"
#include "friction.h"

#include <epf/q31.h>

static const epf_q31_coeffs_t slide = EPF_Q31_COEFFS(SLIDE, SIGNALS); /* in flash */
static epf_q31_t friction;

void friction_start(void)
{
    epf_q31_init(&friction, &slide);
}

void friction_advance(int16_t dx)
{
    (void)epf_q31_advance(&friction, dx);
}

void friction_publish(uint16_t dt)
{
    (void)epf_q31_force(&friction, dt);
}

void friction_speed(int16_t v)
{
    epf_q31_set_velocity(&friction, v);
}

int32_t friction_force(void)
{
    return epf_q31_output(&friction);
}

uint32_t friction_digest(uint32_t digest)
{
    return fold(fold(digest, (uint32_t)epf_q31_z(&friction)), (uint32_t)epf_q31_output(&friction));
}
