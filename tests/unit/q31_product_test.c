/* SPDX-License-Identifier: MIT */
/*
 * The products of q31 on cores without a 32 by 32 to 64-bit multiplication, four of 16 bits, are those of
 * the cores with one. Built for the former, whatever this core is.
 */
#ifndef HAS_NO_LONG_PRODUCT
#define HAS_NO_LONG_PRODUCT
#endif
#include "../../src/q31.c" /* NOLINT(bugprone-suspicious-include) */

#include "effort.h"
#include "integers.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void check_products(uint32_t a, uint32_t b)
{
    const uint64_t whole = (uint64_t)a * b;
    TEST_ASSERT_EQUAL_HEX32((uint32_t)(whole >> 32), product(a, b));
    TEST_ASSERT_EQUAL_HEX32((uint32_t)(whole >> 32), part(a, b));
    TEST_ASSERT_EQUAL_HEX32((uint32_t)(whole >> 32), (uint32_t)(wide(a, b) >> 32));
    TEST_ASSERT_EQUAL_HEX32((uint32_t)whole, (uint32_t)wide(a, b));
}

/* Where a carry is on the brink: 0, 1, a half and all of each half of the bits */
static void test_product_of_16_bit_parts_is_exact_at_every_carry(void)
{
    static const uint32_t halves[] = {0, 1, 2, 0x7fff, 0x8000, 0x8001, 0xfffe, 0xffff};
    for (int i = 0; i < 8 * 8; i++) {
        for (int j = 0; j < 8 * 8; j++) {
            check_products(halves[i / 8] << 16 | halves[i % 8],
                           halves[j / 8] << 16 | halves[j % 8]);
        }
    }
}

static void test_product_of_16_bit_parts_is_exact_for_random_factors_of_every_length(void)
{
    uint32_t random = 1;
    for (long i = 0; i < EFFORT(4000000L); i++) {
        const uint32_t a = random_word(&random) >> random_below(&random, 32);
        check_products(a, random_word(&random) >> random_below(&random, 32));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_product_of_16_bit_parts_is_exact_at_every_carry);
    RUN_TEST(test_product_of_16_bit_parts_is_exact_for_random_factors_of_every_length);
    return UNITY_END() != 0;
}
