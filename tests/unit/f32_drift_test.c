/* SPDX-License-Identifier: MIT */
/* Displacements far below the last digit of z add up: the first thing that a compiler takes away which is
   allowed to reassociate sums. f32_builds.cmake compiles this test, too, with such flags. */
#include "effort.h"
#include "epf/f32.h"
#include "unity.h"

static const epf_f32_coeffs_t table_2 = EPF_F32_COEFFS(
    1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED);

void setUp(void)
{
}

void tearDown(void)
{
}

/* 10^5 of 10^-14 m, where one ulp of z is 4.5 10^-13 m: from 4 um to 4.001 um, and back */
static void test_drift_displacements_below_the_last_digit_of_z_add_up(void)
{
    const long moves = EFFORT(100000L);
    const float moved = 1e-14f * (float)moves;
    epf_f32_t ep;
    epf_f32_init(&ep, &table_2);
    epf_f32_reset(&ep, 4e-6f);
    for (long i = 0; i < moves; i++) {
        (void)epf_f32_advance(&ep, 1e-14f);
    }
    TEST_ASSERT_FLOAT_WITHIN(1e-12f, 4e-6f + moved, epf_f32_z(&ep));
    for (long i = 0; i < moves; i++) {
        (void)epf_f32_advance(&ep, -1e-14f);
    }
    TEST_ASSERT_FLOAT_WITHIN(1e-12f, 4e-6f, epf_f32_z(&ep));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_drift_displacements_below_the_last_digit_of_z_add_up);
    return UNITY_END() != 0;
}
