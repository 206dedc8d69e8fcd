/* SPDX-License-Identifier: MIT */
/* No drift: tremor below z_ba ends where it began, however long it lasts. */
#include "effort.h"
#include "epf/f32.h"
#include "parameter_sets.h"
#include "sequences.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

enum { PERIOD = 37 };

static const long cycles_of_tremor = EFFORT_SQUARED(1000000L);

/* One cycle of tremor as a user gets it: differences of positions that were measured, here of a
   sine and its harmonic so that no two steps are alike; the last one closes the cycle. */
static void make_cycle(float dx[PERIOD], float amplitude, sequence_t *q)
{
    double sum = 0.0;
    for (int i = 0; i < PERIOD - 1; i++) {
        const double x = 6.283185307179586 * (i + 1) / PERIOD;
        const double ragged = sequence_uniform(q, -0.05, 0.05);
        const double target = (double)amplitude * (0.6 * sin(x) + 0.3 * sin(2.0 * x) + ragged);
        dx[i] = (float)(target - sum);
        sum += (double)dx[i];
    }
    dx[PERIOD - 1] = (float)-sum;
}

static double sum_of(const float dx[PERIOD])
{
    double sum = 0.0;
    for (int i = 0; i < PERIOD; i++) {
        sum += (double)dx[i]; /* exact: 24 bits each, of like size */
    }
    return sum;
}

static void shake(epf_f32_t *ep, const float dx[PERIOD], long cycles)
{
    for (long i = 0; i < cycles; i++) {
        for (int j = 0; j < PERIOD; j++) {
            (void)epf_f32_advance(ep, dx[j]);
        }
    }
}

/* The cycle closes to within one rounding of its last step; the state must follow even that */
static void test_drift_tremor_ends_where_it_began(void)
{
    sequence_t q;
    sequence_start(&q, SEQUENCE_TREMOR, 7);
    for (int contact = 0; contact < PARAMETER_SETS * UPDATE_RULES; contact++) {
        const parameter_set_t *set = &parameter_sets[contact / UPDATE_RULES];
        const epf_params_t params = parameters_by((epf_update_t)(contact % UPDATE_RULES), set);
        epf_f32_coeffs_t coeffs;
        epf_f32_t ep;
        (void)epf_f32_coeffs_init(&coeffs, &params);
        epf_f32_init(&ep, &coeffs);
        epf_f32_reset(&ep, 0.4f * coeffs.z_ba);
        const double start = (double)epf_f32_z(&ep);

        float dx[PERIOD];
        make_cycle(dx, 0.5f * coeffs.z_ba, &q);
        shake(&ep, dx, cycles_of_tremor);

        const double expected = start + (double)cycles_of_tremor * sum_of(dx);
        TEST_ASSERT_TRUE_MESSAGE(fabs((double)epf_f32_z(&ep) - expected) <=
                                     (double)(FLT_EPSILON * coeffs.z_ba),
                                 set->name);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_drift_tremor_ends_where_it_began);
    return UNITY_END() != 0;
}
