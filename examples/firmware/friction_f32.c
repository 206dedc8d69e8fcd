/* SPDX-License-Identifier: MIT */
#include "contact.h"
#include "friction.h"

#include <epf/f32.h>

static const epf_f32_coeffs_t slide = EPF_F32_COEFFS(SLIDE); /* in flash */
static epf_f32_t friction;

void friction_start(void)
{
    epf_f32_init(&friction, &slide);
}

void friction_advance(int16_t dx)
{
    (void)epf_f32_advance(&friction, (float)dx * COUNT);
}

void friction_publish(uint16_t dt)
{
    (void)epf_f32_force(&friction, (float)dt * TICK);
}

void friction_speed(int16_t v)
{
    epf_f32_set_velocity(&friction, (float)v * SPEED);
}

int32_t friction_force(void)
{
    return (int32_t)(epf_f32_output(&friction) * (1.0f / FORCE));
}

static uint32_t bits(float value)
{
    const union {
        float value;
        uint32_t bits;
    } word = {value};
    return word.bits;
}

uint32_t friction_digest(uint32_t digest)
{
    return fold(fold(digest, bits(epf_f32_z(&friction))), bits(epf_f32_output(&friction)));
}
