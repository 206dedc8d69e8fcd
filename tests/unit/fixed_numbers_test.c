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

static void test_leading_zeros_are_counted_for_every_length(void)
{
    for (int bit = 0; bit < 32; bit++) {
        const uint32_t highest = (uint32_t)1 << bit;
        const uint32_t lower[] = {0, 1, highest / 2u, highest - 1u};
        for (int i = 0; i < 4; i++) {
            const uint32_t x = highest | lower[i] % highest;
            TEST_ASSERT_EQUAL_INT(31 - bit, leading_zeros(x));
            if (bit >= 16) {
                TEST_ASSERT_EQUAL_INT(31 - bit, leading_zeros_16(x));
            }
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

static void test_sign_and_along_turn_a_number_into_the_direction_of_another(void)
{
    TEST_ASSERT_EQUAL_INT32(1, sign(INT32_MAX));
    TEST_ASSERT_EQUAL_INT32(0, sign(0));
    TEST_ASSERT_EQUAL_INT32(-1, sign(INT32_MIN));
    TEST_ASSERT_EQUAL_INT32(5, along(1, 5));
    TEST_ASSERT_EQUAL_INT32(0, along(0, 5));
    TEST_ASSERT_EQUAL_INT32(-5, along(-1, 5));
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, along(-1, -INT32_MAX));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_leading_zeros_are_counted_for_every_length);
    RUN_TEST(test_shifted_down_drops_as_many_bits_for_every_shift);
    RUN_TEST(test_magnitude_holds_the_most_negative_number);
    RUN_TEST(test_sign_and_along_turn_a_number_into_the_direction_of_another);
    return UNITY_END() != 0;
}
