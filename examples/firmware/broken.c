/* SPDX-License-Identifier: MIT */
/*
 * A set_velocity that is broken, to see that torn.c finds it. The linker puts it in the place of that
 * of the library (--wrap). DEFECT says how:
 *
 *   INDEX_FIRST  announces the new operating point before it is written
 *   IN_PLACE     writes it over the one that is in use
 *   TWICE        comes twice where once is allowed: there are two places, and the second writes over
 *                the one that was in use at first
 *
 * The new operating point is that of the library, made in a copy of the contact.
 */
#include <epf/epf.h>

#include <stddef.h>

enum { INDEX_FIRST, IN_PLACE, TWICE };

/* Byte by byte, so that it takes its time on every core */
static void copy_bytes(void *to, const void *from, size_t size)
{
    volatile uint8_t *target = to;
    const uint8_t *source = from;
    for (size_t i = 0; i < size; i++) {
        target[i] = source[i];
    }
}

/* Of the members of a contact it depends on these two: points, published */
#define BROKEN(variant, velocity_t)                                                \
    void __real_epf_##variant##_set_velocity(epf_##variant##_t *ep, velocity_t v); \
    void __wrap_epf_##variant##_set_velocity(epf_##variant##_t *ep, velocity_t v); \
                                                                                   \
    void __wrap_epf_##variant##_set_velocity(epf_##variant##_t *ep, velocity_t v)  \
    {                                                                              \
        if (DEFECT == TWICE) {                                                     \
            __real_epf_##variant##_set_velocity(ep, 0);                            \
            __real_epf_##variant##_set_velocity(ep, v);                            \
            return;                                                                \
        }                                                                          \
        epf_##variant##_t copy = *ep;                                              \
        __real_epf_##variant##_set_velocity(&copy, v);                             \
        if (DEFECT == INDEX_FIRST) {                                               \
            *(volatile uint8_t *)&ep->published = copy.published;                  \
        }                                                                          \
        copy_bytes(&ep->points[ep->published], &copy.points[copy.published],       \
                   sizeof copy.points[0]);                                         \
    }

BROKEN(f32, float)
BROKEN(q31, int32_t)
BROKEN(q15, int16_t)
