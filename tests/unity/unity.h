/* SPDX-License-Identifier: MIT */
/*
 * A small unit test framework with the public API of Unity (ThrowTheSwitch), written for targets
 * down to 8 KB of RAM: no heap, no buffers, all output through one character function.
 *
 *     void setUp(void) { }
 *     void tearDown(void) { }
 *     static void test_sum(void) { TEST_ASSERT_EQUAL_INT(4, 2 + 2); }
 *
 *     int main(void)
 *     {
 *         UNITY_BEGIN();
 *         RUN_TEST(test_sum);
 *         return UNITY_END() != 0;
 *     }
 *
 * A test is a `void f(void)`. The first assertion that fails prints its reason and leaves the test
 * at once; tearDown still runs. Every assertion has a form with _MESSAGE appended to its name and
 * a text appended to its arguments. In the lists below: e expected, a actual, d largest difference
 * allowed, m message. README.md tells how this differs from upstream.
 */
#ifndef UNITY_H
#define UNITY_H

#include <setjmp.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Defined here and not upstream: NaN is never within a tolerance, and a run of no tests fails. */
#define UNITY_STRICT

/* Provided by the test file; they surround each test. */
void setUp(void);
void tearDown(void);

#define UNITY_BEGIN()  UnityBegin(__FILE__)
#define UNITY_END()    UnityEnd() /* prints the summary, returns the number of failures */
#define RUN_TEST(func) UnityDefaultTestRun((func), #func, __LINE__)

#define TEST_PROTECT() (setjmp(Unity.AbortFrame) == 0)
#define TEST_ABORT()   longjmp(Unity.AbortFrame, 1)

/* ---- Verdicts ---- */

#define TEST_PASS()            TEST_ABORT() /* leaves the test, which has passed */
#define TEST_FAIL()            TEST_FAIL_MESSAGE("no reason given")
#define TEST_FAIL_MESSAGE(m)   UnityFail((m), NULL, __LINE__)
#define TEST_IGNORE()          TEST_IGNORE_MESSAGE("no reason given")
#define TEST_IGNORE_MESSAGE(m) UnityIgnore((m), __LINE__)

/* ---- Truth ---- */

#define TEST_ASSERT(c)                     UNITY_CHECK(c, "Expected true Was false", NULL)
#define TEST_ASSERT_MESSAGE(c, m)          UNITY_CHECK(c, "Expected true Was false", m)
#define TEST_ASSERT_TRUE(c)                UNITY_CHECK(c, "Expected true Was false", NULL)
#define TEST_ASSERT_TRUE_MESSAGE(c, m)     UNITY_CHECK(c, "Expected true Was false", m)
#define TEST_ASSERT_FALSE(c)               UNITY_CHECK(!(c), "Expected false Was true", NULL)
#define TEST_ASSERT_FALSE_MESSAGE(c, m)    UNITY_CHECK(!(c), "Expected false Was true", m)
#define TEST_ASSERT_NULL(p)                UNITY_CHECK((p) == NULL, "Expected NULL", NULL)
#define TEST_ASSERT_NULL_MESSAGE(p, m)     UNITY_CHECK((p) == NULL, "Expected NULL", m)
#define TEST_ASSERT_NOT_NULL(p)            UNITY_CHECK((p) != NULL, "Expected not NULL", NULL)
#define TEST_ASSERT_NOT_NULL_MESSAGE(p, m) UNITY_CHECK((p) != NULL, "Expected not NULL", m)

/* ---- Integers ----
 * A width in the name converts both sides to that type first; without one (INT, UINT) values
 * keep all their bits. HEX alone means HEX32. */

#define TEST_ASSERT_EQUAL(e, a)                   UNITY_INT_IS(UNITY_EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_MESSAGE(e, a, m)        UNITY_INT_IS(UNITY_EQUAL, e, a, m)
#define TEST_ASSERT_NOT_EQUAL(e, a)               UNITY_INT_IS(UNITY_OTHER, e, a, NULL)
#define TEST_ASSERT_NOT_EQUAL_MESSAGE(e, a, m)    UNITY_INT_IS(UNITY_OTHER, e, a, m)
#define TEST_ASSERT_EQUAL_INT(e, a)               UNITY_INT_IS(UNITY_EQUAL, e, a, NULL)
#define TEST_ASSERT_EQUAL_INT_MESSAGE(e, a, m)    UNITY_INT_IS(UNITY_EQUAL, e, a, m)
#define TEST_ASSERT_EQUAL_INT8(e, a)              UNITY_SAME_INT(int8_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_INT8_MESSAGE(e, a, m)   UNITY_SAME_INT(int8_t, e, a, m)
#define TEST_ASSERT_EQUAL_INT16(e, a)             UNITY_SAME_INT(int16_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_INT16_MESSAGE(e, a, m)  UNITY_SAME_INT(int16_t, e, a, m)
#define TEST_ASSERT_EQUAL_INT32(e, a)             UNITY_SAME_INT(int32_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_INT32_MESSAGE(e, a, m)  UNITY_SAME_INT(int32_t, e, a, m)
#define TEST_ASSERT_EQUAL_INT64(e, a)             UNITY_SAME_INT(int64_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_INT64_MESSAGE(e, a, m)  UNITY_SAME_INT(int64_t, e, a, m)
#define TEST_ASSERT_EQUAL_UINT(e, a)              UNITY_SAME_UINT(uint64_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_UINT_MESSAGE(e, a, m)   UNITY_SAME_UINT(uint64_t, e, a, m)
#define TEST_ASSERT_EQUAL_UINT8(e, a)             UNITY_SAME_UINT(uint8_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_UINT8_MESSAGE(e, a, m)  UNITY_SAME_UINT(uint8_t, e, a, m)
#define TEST_ASSERT_EQUAL_UINT16(e, a)            UNITY_SAME_UINT(uint16_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_UINT16_MESSAGE(e, a, m) UNITY_SAME_UINT(uint16_t, e, a, m)
#define TEST_ASSERT_EQUAL_UINT32(e, a)            UNITY_SAME_UINT(uint32_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_UINT32_MESSAGE(e, a, m) UNITY_SAME_UINT(uint32_t, e, a, m)
#define TEST_ASSERT_EQUAL_UINT64(e, a)            UNITY_SAME_UINT(uint64_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_UINT64_MESSAGE(e, a, m) UNITY_SAME_UINT(uint64_t, e, a, m)
#define TEST_ASSERT_EQUAL_HEX(e, a)               UNITY_SAME_HEX(uint32_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_HEX_MESSAGE(e, a, m)    UNITY_SAME_HEX(uint32_t, e, a, m)
#define TEST_ASSERT_EQUAL_HEX8(e, a)              UNITY_SAME_HEX(uint8_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_HEX8_MESSAGE(e, a, m)   UNITY_SAME_HEX(uint8_t, e, a, m)
#define TEST_ASSERT_EQUAL_HEX16(e, a)             UNITY_SAME_HEX(uint16_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_HEX16_MESSAGE(e, a, m)  UNITY_SAME_HEX(uint16_t, e, a, m)
#define TEST_ASSERT_EQUAL_HEX32(e, a)             UNITY_SAME_HEX(uint32_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_HEX32_MESSAGE(e, a, m)  UNITY_SAME_HEX(uint32_t, e, a, m)
#define TEST_ASSERT_EQUAL_HEX64(e, a)             UNITY_SAME_HEX(uint64_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_HEX64_MESSAGE(e, a, m)  UNITY_SAME_HEX(uint64_t, e, a, m)
#define TEST_ASSERT_EQUAL_PTR(e, a)               UNITY_SAME_HEX(uintptr_t, e, a, NULL)
#define TEST_ASSERT_EQUAL_PTR_MESSAGE(e, a, m)    UNITY_SAME_HEX(uintptr_t, e, a, m)

/* The actual value, second, must be greater (less, ...) than the threshold t, first. */
#define TEST_ASSERT_GREATER_THAN_INT(t, a)                UNITY_INT_IS(UNITY_GREATER, t, a, NULL)
#define TEST_ASSERT_GREATER_THAN_INT_MESSAGE(t, a, m)     UNITY_INT_IS(UNITY_GREATER, t, a, m)
#define TEST_ASSERT_LESS_THAN_INT(t, a)                   UNITY_INT_IS(UNITY_LESS, t, a, NULL)
#define TEST_ASSERT_LESS_THAN_INT_MESSAGE(t, a, m)        UNITY_INT_IS(UNITY_LESS, t, a, m)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT(t, a)            UNITY_INT_IS(UNITY_AT_LEAST, t, a, NULL)
#define TEST_ASSERT_GREATER_OR_EQUAL_INT_MESSAGE(t, a, m) UNITY_INT_IS(UNITY_AT_LEAST, t, a, m)
#define TEST_ASSERT_LESS_OR_EQUAL_INT(t, a)               UNITY_INT_IS(UNITY_AT_MOST, t, a, NULL)
#define TEST_ASSERT_LESS_OR_EQUAL_INT_MESSAGE(t, a, m)    UNITY_INT_IS(UNITY_AT_MOST, t, a, m)

#define TEST_ASSERT_INT_WITHIN(d, e, a)               UNITY_NEAR_INT(int64_t, d, e, a, NULL)
#define TEST_ASSERT_INT_WITHIN_MESSAGE(d, e, a, m)    UNITY_NEAR_INT(int64_t, d, e, a, m)
#define TEST_ASSERT_INT8_WITHIN(d, e, a)              UNITY_NEAR_INT(int8_t, d, e, a, NULL)
#define TEST_ASSERT_INT8_WITHIN_MESSAGE(d, e, a, m)   UNITY_NEAR_INT(int8_t, d, e, a, m)
#define TEST_ASSERT_INT16_WITHIN(d, e, a)             UNITY_NEAR_INT(int16_t, d, e, a, NULL)
#define TEST_ASSERT_INT16_WITHIN_MESSAGE(d, e, a, m)  UNITY_NEAR_INT(int16_t, d, e, a, m)
#define TEST_ASSERT_INT32_WITHIN(d, e, a)             UNITY_NEAR_INT(int32_t, d, e, a, NULL)
#define TEST_ASSERT_INT32_WITHIN_MESSAGE(d, e, a, m)  UNITY_NEAR_INT(int32_t, d, e, a, m)
#define TEST_ASSERT_INT64_WITHIN(d, e, a)             UNITY_NEAR_INT(int64_t, d, e, a, NULL)
#define TEST_ASSERT_INT64_WITHIN_MESSAGE(d, e, a, m)  UNITY_NEAR_INT(int64_t, d, e, a, m)
#define TEST_ASSERT_UINT_WITHIN(d, e, a)              UNITY_NEAR_UINT(uint64_t, d, e, a, NULL)
#define TEST_ASSERT_UINT_WITHIN_MESSAGE(d, e, a, m)   UNITY_NEAR_UINT(uint64_t, d, e, a, m)
#define TEST_ASSERT_UINT8_WITHIN(d, e, a)             UNITY_NEAR_UINT(uint8_t, d, e, a, NULL)
#define TEST_ASSERT_UINT8_WITHIN_MESSAGE(d, e, a, m)  UNITY_NEAR_UINT(uint8_t, d, e, a, m)
#define TEST_ASSERT_UINT16_WITHIN(d, e, a)            UNITY_NEAR_UINT(uint16_t, d, e, a, NULL)
#define TEST_ASSERT_UINT16_WITHIN_MESSAGE(d, e, a, m) UNITY_NEAR_UINT(uint16_t, d, e, a, m)
#define TEST_ASSERT_UINT32_WITHIN(d, e, a)            UNITY_NEAR_UINT(uint32_t, d, e, a, NULL)
#define TEST_ASSERT_UINT32_WITHIN_MESSAGE(d, e, a, m) UNITY_NEAR_UINT(uint32_t, d, e, a, m)
#define TEST_ASSERT_UINT64_WITHIN(d, e, a)            UNITY_NEAR_UINT(uint64_t, d, e, a, NULL)
#define TEST_ASSERT_UINT64_WITHIN_MESSAGE(d, e, a, m) UNITY_NEAR_UINT(uint64_t, d, e, a, m)

/* ---- Strings, memory, arrays ----
 * Two NULLs are equal. To compare no bytes or no elements fails: that would check nothing. */

#define TEST_ASSERT_EQUAL_STRING(e, a)                    UNITY_SAME_TEXT(e, a, NULL)
#define TEST_ASSERT_EQUAL_STRING_MESSAGE(e, a, m)         UNITY_SAME_TEXT(e, a, m)
#define TEST_ASSERT_EQUAL_MEMORY(e, a, n)                 UNITY_SAME_BYTES(e, a, n, NULL)
#define TEST_ASSERT_EQUAL_MEMORY_MESSAGE(e, a, n, m)      UNITY_SAME_BYTES(e, a, n, m)
#define TEST_ASSERT_EQUAL_INT32_ARRAY(e, a, n)            UNITY_SAME_ARRAY(e, a, n, NULL)
#define TEST_ASSERT_EQUAL_INT32_ARRAY_MESSAGE(e, a, n, m) UNITY_SAME_ARRAY(e, a, n, m)

/* ---- Floating point ----
 * FLOAT converts all values to float first; the difference is taken in double. The tolerance of
 * EQUAL_FLOAT and EQUAL_DOUBLE is relative to the expected value: none at all at 0. */

#define TEST_ASSERT_FLOAT_WITHIN(d, e, a)             UNITY_CLOSE(float, d, e, a, NULL)
#define TEST_ASSERT_FLOAT_WITHIN_MESSAGE(d, e, a, m)  UNITY_CLOSE(float, d, e, a, m)
#define TEST_ASSERT_DOUBLE_WITHIN(d, e, a)            UNITY_CLOSE(double, d, e, a, NULL)
#define TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(d, e, a, m) UNITY_CLOSE(double, d, e, a, m)
#define TEST_ASSERT_EQUAL_FLOAT(e, a)                 UNITY_ALIKE(float, 1e-5f, e, a, NULL)
#define TEST_ASSERT_EQUAL_FLOAT_MESSAGE(e, a, m)      UNITY_ALIKE(float, 1e-5f, e, a, m)
#define TEST_ASSERT_EQUAL_DOUBLE(e, a)                UNITY_ALIKE(double, 1e-12, e, a, NULL)
#define TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(e, a, m)     UNITY_ALIKE(double, 1e-12, e, a, m)

/* INF is positive infinity only; DETERMINATE is neither infinite nor NaN. */
#define TEST_ASSERT_FLOAT_IS_INF(a)                         UNITY_IS(float, UNITY_INF, a, NULL)
#define TEST_ASSERT_FLOAT_IS_INF_MESSAGE(a, m)              UNITY_IS(float, UNITY_INF, a, m)
#define TEST_ASSERT_FLOAT_IS_NOT_INF(a)                     UNITY_ISNT(float, UNITY_INF, a, NULL)
#define TEST_ASSERT_FLOAT_IS_NOT_INF_MESSAGE(a, m)          UNITY_ISNT(float, UNITY_INF, a, m)
#define TEST_ASSERT_FLOAT_IS_NEG_INF(a)                     UNITY_IS(float, UNITY_NINF, a, NULL)
#define TEST_ASSERT_FLOAT_IS_NEG_INF_MESSAGE(a, m)          UNITY_IS(float, UNITY_NINF, a, m)
#define TEST_ASSERT_FLOAT_IS_NOT_NEG_INF(a)                 UNITY_ISNT(float, UNITY_NINF, a, NULL)
#define TEST_ASSERT_FLOAT_IS_NOT_NEG_INF_MESSAGE(a, m)      UNITY_ISNT(float, UNITY_NINF, a, m)
#define TEST_ASSERT_FLOAT_IS_NAN(a)                         UNITY_IS(float, UNITY_NAN, a, NULL)
#define TEST_ASSERT_FLOAT_IS_NAN_MESSAGE(a, m)              UNITY_IS(float, UNITY_NAN, a, m)
#define TEST_ASSERT_FLOAT_IS_NOT_NAN(a)                     UNITY_ISNT(float, UNITY_NAN, a, NULL)
#define TEST_ASSERT_FLOAT_IS_NOT_NAN_MESSAGE(a, m)          UNITY_ISNT(float, UNITY_NAN, a, m)
#define TEST_ASSERT_FLOAT_IS_DETERMINATE(a)                 UNITY_IS(float, UNITY_NUM, a, NULL)
#define TEST_ASSERT_FLOAT_IS_DETERMINATE_MESSAGE(a, m)      UNITY_IS(float, UNITY_NUM, a, m)
#define TEST_ASSERT_FLOAT_IS_NOT_DETERMINATE(a)             UNITY_ISNT(float, UNITY_NUM, a, NULL)
#define TEST_ASSERT_FLOAT_IS_NOT_DETERMINATE_MESSAGE(a, m)  UNITY_ISNT(float, UNITY_NUM, a, m)
#define TEST_ASSERT_DOUBLE_IS_INF(a)                        UNITY_IS(double, UNITY_INF, a, NULL)
#define TEST_ASSERT_DOUBLE_IS_INF_MESSAGE(a, m)             UNITY_IS(double, UNITY_INF, a, m)
#define TEST_ASSERT_DOUBLE_IS_NOT_INF(a)                    UNITY_ISNT(double, UNITY_INF, a, NULL)
#define TEST_ASSERT_DOUBLE_IS_NOT_INF_MESSAGE(a, m)         UNITY_ISNT(double, UNITY_INF, a, m)
#define TEST_ASSERT_DOUBLE_IS_NEG_INF(a)                    UNITY_IS(double, UNITY_NINF, a, NULL)
#define TEST_ASSERT_DOUBLE_IS_NEG_INF_MESSAGE(a, m)         UNITY_IS(double, UNITY_NINF, a, m)
#define TEST_ASSERT_DOUBLE_IS_NOT_NEG_INF(a)                UNITY_ISNT(double, UNITY_NINF, a, NULL)
#define TEST_ASSERT_DOUBLE_IS_NOT_NEG_INF_MESSAGE(a, m)     UNITY_ISNT(double, UNITY_NINF, a, m)
#define TEST_ASSERT_DOUBLE_IS_NAN(a)                        UNITY_IS(double, UNITY_NAN, a, NULL)
#define TEST_ASSERT_DOUBLE_IS_NAN_MESSAGE(a, m)             UNITY_IS(double, UNITY_NAN, a, m)
#define TEST_ASSERT_DOUBLE_IS_NOT_NAN(a)                    UNITY_ISNT(double, UNITY_NAN, a, NULL)
#define TEST_ASSERT_DOUBLE_IS_NOT_NAN_MESSAGE(a, m)         UNITY_ISNT(double, UNITY_NAN, a, m)
#define TEST_ASSERT_DOUBLE_IS_DETERMINATE(a)                UNITY_IS(double, UNITY_NUM, a, NULL)
#define TEST_ASSERT_DOUBLE_IS_DETERMINATE_MESSAGE(a, m)     UNITY_IS(double, UNITY_NUM, a, m)
#define TEST_ASSERT_DOUBLE_IS_NOT_DETERMINATE(a)            UNITY_ISNT(double, UNITY_NUM, a, NULL)
#define TEST_ASSERT_DOUBLE_IS_NOT_DETERMINATE_MESSAGE(a, m) UNITY_ISNT(double, UNITY_NUM, a, m)

/* ---- Machinery behind the macros: not for use in tests ---- */

/* A set of relations: an assertion holds if the one found is a member. */
enum { UNITY_LESS = 1, UNITY_EQUAL = 2, UNITY_GREATER = 4 };
enum { UNITY_AT_MOST = 1 | 2, UNITY_OTHER = 1 | 4, UNITY_AT_LEAST = 2 | 4 };

/* How to print an integer; any other style is a number of hexadecimal digits. */
enum { UNITY_SIGNED = 0, UNITY_UNSIGNED = 1 };

/* The kinds of floating-point values. */
enum { UNITY_NAN, UNITY_INF, UNITY_NINF, UNITY_NUM };

#define UNITY_CHECK(c, reason, m) ((c) ? (void)0 : UnityFail((reason), (m), __LINE__))

#define UNITY_NUMBER(type, style, allowed, e, a, m) \
    UnityAssertNumber((int64_t)(type)(e), (int64_t)(type)(a), (allowed), (style), (m), __LINE__)
#define UNITY_INT_IS(allowed, e, a, m) UNITY_NUMBER(int64_t, UNITY_SIGNED, allowed, e, a, m)
#define UNITY_SAME_INT(type, e, a, m)  UNITY_NUMBER(type, UNITY_SIGNED, UNITY_EQUAL, e, a, m)
#define UNITY_SAME_UINT(type, e, a, m) UNITY_NUMBER(type, UNITY_UNSIGNED, UNITY_EQUAL, e, a, m)
#define UNITY_SAME_HEX(type, e, a, m) \
    UNITY_NUMBER(type, 2 * (int)sizeof(type), UNITY_EQUAL, e, a, m)

#define UNITY_NEAR(type, style, d, e, a, m) \
    UnityAssertNear((uint64_t)(d), (int64_t)(type)(e), (int64_t)(type)(a), (style), (m), __LINE__)
#define UNITY_NEAR_INT(type, d, e, a, m)  UNITY_NEAR(type, UNITY_SIGNED, d, e, a, m)
#define UNITY_NEAR_UINT(type, d, e, a, m) UNITY_NEAR(type, UNITY_UNSIGNED, d, e, a, m)

#define UNITY_SAME_BYTES(e, a, n, m) UnityAssertMemory((e), (a), (size_t)(n), (m), __LINE__)
#define UNITY_SAME_ARRAY(e, a, n, m) UnityAssertInt32Array((e), (a), (size_t)(n), (m), __LINE__)
#define UNITY_SAME_TEXT(e, a, m)     UnityAssertString((e), (a), (m), __LINE__)

#define UNITY_CLOSE(type, d, e, a, m) \
    UnityAssertClose((double)(type)(d), (double)(type)(e), (double)(type)(a), (m), __LINE__)
#define UNITY_ALIKE(type, precision, e, a, m) UNITY_CLOSE(type, (precision) * (type)(e), e, a, m)
#define UNITY_KIND(type, kind, is, a, m) \
    UnityAssertKind((double)(type)(a), (kind), (is), (m), __LINE__)
#define UNITY_IS(type, kind, a, m)   UNITY_KIND(type, kind, 1, a, m)
#define UNITY_ISNT(type, kind, a, m) UNITY_KIND(type, kind, 0, a, m)

extern struct UNITY_STORAGE_T {
    const char *TestFile;
    const char *CurrentTestName;
    int CurrentTestLineNumber;
    unsigned NumberOfTests;
    unsigned TestFailures;
    unsigned TestIgnores;
    unsigned CurrentTestFailed;
    unsigned CurrentTestIgnored;
    jmp_buf AbortFrame;
} Unity;

void UnityBegin(const char *file);
int UnityEnd(void);
void UnityDefaultTestRun(void (*test)(void), const char *name, int line);
void UnityFail(const char *reason, const char *message, int line);
void UnityIgnore(const char *reason, int line);
void UnityAssertNumber(int64_t expected, int64_t actual, int allowed, int style,
                       const char *message, int line);
void UnityAssertNear(uint64_t delta, int64_t expected, int64_t actual, int style,
                     const char *message, int line);
void UnityAssertString(const char *expected, const char *actual, const char *message, int line);
void UnityAssertMemory(const void *expected, const void *actual, size_t count, const char *message,
                       int line);
void UnityAssertInt32Array(const int32_t *expected, const int32_t *actual, size_t count,
                           const char *message, int line);
void UnityAssertClose(double delta, double expected, double actual, const char *message, int line);
void UnityAssertKind(double actual, int kind, int is, const char *message, int line);

#ifdef __cplusplus
}
#endif

#endif
