/* SPDX-License-Identifier: MIT */
/*
 * Signs and leading zeros, at every length of number. Built a second time with the instruction that
 * counts leading zeros in place of comparisons, where the compiler has one for it.
 */
#include "numbers.h"

#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_normalised_moves_the_highest_bit_up_for_every_length(void)
{
    for (int bit = 0; bit < 32; bit++) {
        const uint32_t highest = (uint32_t)1 << bit;
        const uint32_t lower[] = {0, 1, highest / 2u, highest - 1u};
        for (int i = 0; i < 4; i++) {
            const uint32_t x = highest | lower[i] % highest;
            TEST_ASSERT_EQUAL_INT(31 - bit, normalised(x).zeros);
            TEST_ASSERT_EQUAL_UINT32(x << (31 - bit), normalised(x).mantissa);
        }
    }
}

static void test_shifted_down_drops_as_many_bits_for_every_shift(void)
{
    for (int shift = 0; shift < 32; shift++) {
        TEST_ASSERT_EQUAL_UINT32(UINT32_MAX >> shift, shifted_down(UINT32_MAX, shift));
        TEST_ASSERT_EQUAL_UINT32(0x96a5c369u >> shift, shifted_down(0x96a5c369u, shift));
    }
}

static void test_magnitude_holds_the_most_negative_number(void)
{
    TEST_ASSERT_EQUAL_UINT32(0, magnitude(0));
    TEST_ASSERT_EQUAL_UINT32(7, magnitude(7));
    TEST_ASSERT_EQUAL_UINT32(7, magnitude(-7));
    TEST_ASSERT_EQUAL_UINT32(2147483647u, magnitude(INT32_MAX));
    TEST_ASSERT_EQUAL_UINT32(2147483648u, magnitude(INT32_MIN));
}

static void test_along_takes_the_sign_of_the_direction_and_0_is_forward(void)
{
    TEST_ASSERT_EQUAL_INT32(5, along(INT32_MAX, 5));
    TEST_ASSERT_EQUAL_INT32(5, along(0, 5));
    TEST_ASSERT_EQUAL_INT32(-5, along(-1, 5));
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, along(INT32_MIN, -INT32_MAX));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_normalised_moves_the_highest_bit_up_for_every_length);
    RUN_TEST(test_shifted_down_drops_as_many_bits_for_every_shift);
    RUN_TEST(test_magnitude_holds_the_most_negative_number);
    RUN_TEST(test_along_takes_the_sign_of_the_direction_and_0_is_forward);
    return UNITY_END() != 0;
}
