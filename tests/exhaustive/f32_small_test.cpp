// SPDX-License-Identifier: MIT
//
// The additive core of f32, as shipped, in a binary format of 3 to 5 bits of mantissa, for every state,
// every z_ss and every displacement: all mantissas, and all exponents between those beyond which nothing
// changes any more. What holds in each of these formats is no proof for 24 bits, but there is nothing in
// the algorithm that depends on their number.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "unity.h"

static int precision; // bits of mantissa

// A number of that format: every operation is rounded to nearest, ties to even
class Small
{
  public:
    Small() : value(0.0)
    {
    }
    Small(double exact) : value(rounded(exact))
    {
    }
    double value;

  private:
    static double rounded(double x)
    {
        const int surplus = 53 - precision;
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof bits);
        bits += ((std::uint64_t(1) << (surplus - 1)) - 1) + (bits >> surplus & 1);
        bits &= ~((std::uint64_t(1) << surplus) - 1);
        std::memcpy(&x, &bits, sizeof bits);
        return x;
    }
};

static inline Small operator+(Small a, Small b)
{
    return Small(a.value + b.value);
}

static inline Small operator-(Small a, Small b)
{
    return Small(a.value - b.value);
}

static inline Small operator*(Small a, Small b)
{
    return Small(a.value * b.value);
}

#ifdef __clang__
#pragma clang diagnostic ignored "-Wkeyword-macro" // this is what the test is about
#endif
#define float Small
#include "deflection.h"
#undef float

extern "C" void setUp(void)
{
}

extern "C" void tearDown(void)
{
}

// 0, and all positive numbers from 2^low to below 2^(high + 1)
static std::vector<double> numbers(int low, int high)
{
    std::vector<double> all(1, 0.0);
    const int first = 1 << (precision - 1);
    for (int exponent = low; exponent <= high; exponent++) {
        for (int i = 0; i < first; i++) {
            all.push_back(std::ldexp(first + i, exponent - precision + 1));
        }
    }
    return all;
}

static void check(bool condition, const char *claim)
{
    if (!condition) {
        TEST_FAIL_MESSAGE(claim);
    }
}

static double exact(deflection_t z)
{
    return z.high.value + z.low.value;
}

// z + y, wherever y leads
static deflection_t right_sum(deflection_t z, double y)
{
    const deflection_t sum = sum_of(z, Small(y));
    check(Small(exact(sum)).value == sum.high.value, "|low| <= ulp(high)/2");
    // of z.low and the part of y that high loses, one rounding is all that is lost
    const double first = Small(z.high.value + y).value;
    const double lost = z.high.value + y - first;
    check(exact(sum) == first + Small(z.low.value + lost).value, "two-sum is exact");
    const deflection_t negative = {Small(-z.high.value), Small(-z.low.value)};
    const deflection_t mirror = sum_of(negative, Small(-y));
    check(mirror.high.value == -sum.high.value && mirror.low.value == -sum.low.value, "odd");
    return sum;
}

static void rises_to_z_ss_at_most(deflection_t z, double z_ss, double y)
{
    const deflection_t sum = right_sum(z, y);
    check(exact(sum) <= z_ss, "high + low <= z_ss");
    check(sum.high.value <= z_ss, "high <= z_ss");
    check(sum.high.value >= z.high.value, "high never falls");
    check(exact(sum) >= exact(z), "the sum never falls");
}

static void falls_to_z_ss_at_most(deflection_t z, double z_ss, double y)
{
    const deflection_t sum = right_sum(z, y);
    check(exact(sum) >= z_ss, "high + low >= z_ss");
    check(sum.high.value >= z_ss, "high >= z_ss");
    check(sum.high.value <= z.high.value, "high never rises");
    check(exact(sum) <= exact(z), "the sum never rises");
}

static void every_displacement(deflection_t z, double z_ss, const std::vector<double> &ys)
{
    const double gap = gap_of(z, Small(1.0), Small(z_ss)).value;
    check((gap > 0.0) == (exact(z) < z_ss), "the sign of the gap");
    check((gap < 0.0) == (exact(z) > z_ss), "the sign of a gap from above");
    const deflection_t negative = {Small(-z.high.value), Small(-z.low.value)};
    check(gap_of(negative, Small(-1.0), Small(z_ss)).value == gap, "the gap of the mirror image");
    for (double y : ys) {
        if (y >= std::fabs(gap)) {
            break;
        }
        if (gap > 0.0) {
            rises_to_z_ss_at_most(z, z_ss, y);
        } else {
            falls_to_z_ss_at_most(z, z_ss, -y);
        }
    }
}

// z_ss in [1, 2); states of both signs, up to where they dwarf it and down to where they vanish in it
static void every_state()
{
    const std::vector<double> steady = numbers(0, 0);
    const std::vector<double> highs = numbers(-precision - 2, precision + 2);
    const std::vector<double> lows = numbers(-2 * precision - 3, 2);
    const std::vector<double> ys = numbers(-2 * precision - 2, precision + 3);
    for (double z_ss : steady) {
        for (double high : highs) {
            for (double low : lows) {
                for (int signs = 0; signs < 4 && z_ss > 0.0; signs++) {
                    const deflection_t z = {Small(signs & 1 ? -high : high),
                                            Small(signs & 2 ? -low : low)};
                    if (Small(exact(z)).value == z.high.value) {
                        every_displacement(z, z_ss, ys);
                    }
                }
            }
        }
    }
}

static void test_additive_core_in_3_bits_for_every_state_and_displacement(void)
{
    precision = 3;
    every_state();
}

static void test_additive_core_in_4_bits_for_every_state_and_displacement(void)
{
    precision = 4;
    every_state();
}

static void test_additive_core_in_5_bits_for_every_state_and_displacement(void)
{
    precision = 5;
    every_state();
}

int main()
{
    UNITY_BEGIN();
    RUN_TEST(test_additive_core_in_3_bits_for_every_state_and_displacement);
    RUN_TEST(test_additive_core_in_4_bits_for_every_state_and_displacement);
    RUN_TEST(test_additive_core_in_5_bits_for_every_state_and_displacement);
    return UNITY_END() != 0;
}
