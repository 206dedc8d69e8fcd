/* SPDX-License-Identifier: MIT */
/*
 * A test of the test framework: every assertion is seen to pass when it should and to fail when it
 * should, for this project's Unity and for upstream's alike. Each probe, a small test that may well
 * fail, runs in a session of its own inside an ordinary test, which then looks at the counts and at
 * what was printed.
 *
 * unity.c is included, not linked, so that its output can be captured: build this file alone, with
 * the folder of unity.c and unity.h on the include path (as a system folder for upstream, whose
 * code is not made for the warnings we use).
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static void capture(char c);

#define UNITY_OUTPUT_CHAR(c) capture((char)(c))
#ifndef UNITY_NO_WEAK /* upstream: no setUp and tearDown of its own */
#define UNITY_NO_WEAK
#endif
#ifndef UNITY_INCLUDE_DOUBLE
#define UNITY_INCLUDE_DOUBLE
#endif
#ifndef UNITY_SUPPORT_64
#define UNITY_SUPPORT_64
#endif
#include "unity.c" /* NOLINT(bugprone-suspicious-include) */

/* ---- Sessions inside a test ---- */

struct probe {
    const char *name;
    void (*test)(void);
};

struct session {
    unsigned tests, failures, ignores;
    int status;
};

static char transcript[1024];
static size_t printed;
static int observing;

static void capture(char c)
{
    if (!observing) {
        (void)putchar(c);
    } else if (printed < sizeof transcript - 1) {
        transcript[printed++] = c;
        transcript[printed] = '\0';
    }
}

static struct session run(const struct probe *probes, size_t count)
{
    const struct UNITY_STORAGE_T outer = Unity;
    struct session result;
    printed = 0;
    transcript[0] = '\0';
    observing = 1;
    UNITY_BEGIN();
    for (size_t i = 0; i < count; i++) {
        UnityDefaultTestRun(probes[i].test, probes[i].name, __LINE__);
    }
    result.tests = (unsigned)Unity.NumberOfTests;
    result.failures = (unsigned)Unity.TestFailures;
    result.ignores = (unsigned)Unity.TestIgnores;
    result.status = UNITY_END();
    observing = 0;
    Unity = outer;
    return result;
}

static struct session run_one(const char *name, void (*test)(void))
{
    const struct probe probe = {name, test};
    return run(&probe, 1);
}

/* Counted apart from Unity: a framework unable to fail could not report its own fault. */
static unsigned expectations;
static unsigned surprises;

static void expect(int condition, const char *what)
{
    static char complaint[512];
    expectations++;
    if (!condition) {
        surprises++;
        (void)snprintf(complaint, sizeof complaint, "%.100s, after: %.400s", what, transcript);
        TEST_FAIL_MESSAGE(complaint);
    }
}

static void expect_printed(const char *text, const char *what)
{
    expect(strstr(transcript, text) != NULL, what);
}

/* "file:line:name:verdict", and then in the same line the reason. What stands between the two is left
 * open: "FAIL: reason" up to Unity 2.6, "FAIL:reason" or "FAIL. reason" from 2.7 on. */
static void expect_report(const char *name, const char *verdict, const char *reason)
{
    char start[200];
    expect_printed(__FILE__ ":", name);
    (void)snprintf(start, sizeof start, ":%s:%s", name, verdict);
    const char *const report = strstr(transcript, start);
    const char *const rest = report == NULL ? "" : report + strlen(start);
    const char *const found = strstr(rest, reason);
    expect(report != NULL, start);
    expect(found != NULL && found <= rest + strcspn(rest, "\n"), reason);
}

static void expect_verdict(const char *name, const char *verdict)
{
    expect_report(name, verdict, "");
}

static void expect_pass(const struct probe *probe)
{
    const struct session s = run(probe, 1);
    expect(s.tests == 1 && s.failures == 0 && s.ignores == 0 && s.status == 0, probe->name);
    expect_verdict(probe->name, "PASS\n");
}

static void expect_failure(const struct probe *probe, const char *reason)
{
    const struct session s = run(probe, 1);
    expect(s.tests == 1 && s.failures == 1 && s.ignores == 0 && s.status == 1, probe->name);
    expect_report(probe->name, "FAIL", reason);
}

/* ---- Fixtures: hooks, so that a probe can make setUp or tearDown misbehave ---- */

static void nothing(void)
{
}

static void (*on_set_up)(void) = nothing;
static void (*on_tear_down)(void) = nothing;
static unsigned reached;
static unsigned set_ups;
static unsigned tear_downs;

static void forget(void)
{
    on_set_up = nothing;
    on_tear_down = nothing;
    reached = 0;
    set_ups = 0;
    tear_downs = 0;
}

/* Around an ordinary test they start afresh; around a probe they are what is tested. */
void setUp(void)
{
    if (!observing) {
        forget();
        return;
    }
    set_ups++;
    on_set_up();
}

void tearDown(void)
{
    if (observing) {
        tear_downs++;
        on_tear_down();
    }
}

/* ---- Every assertion, in both directions, with and without a message ---- */

static int object[2];
static const char *const no_text = NULL;
static const int32_t numbers[] = {1, -2, 3};
static const int32_t same_numbers[] = {1, -2, 3};
static const int32_t other_numbers[] = {1, -2, 4};

/* 2.7 reports neither pointers nor bytes in hexadecimal */
#ifdef UNITY_STRICT
#define OURS(text, upstream) text
#else
#define OURS(text, upstream) upstream
#endif

/* X(assertion, arguments that pass, arguments that fail, text in the report of the failure) */
#define TRUTHS(X)                                          \
    X(TEST_ASSERT, (1 == 1), (1 == 2), "")                 \
    X(TEST_ASSERT_TRUE, (1 == 1), (1 == 2), "")            \
    X(TEST_ASSERT_FALSE, (1 == 2), (1 == 1), "")           \
    X(TEST_ASSERT_NULL, (no_text), (same_numbers), "NULL") \
    X(TEST_ASSERT_NOT_NULL, (same_numbers), (no_text), "NULL")

#define INTEGERS(X)                                                                          \
    X(TEST_ASSERT_EQUAL, (-7, -7), (-7, 8), "Expected -7 Was 8")                             \
    X(TEST_ASSERT_NOT_EQUAL, (7, 8), (7, 7), "Expected ")                                    \
    X(TEST_ASSERT_EQUAL_INT, (-7, -7), (-7, 8), "Expected -7 Was 8")                         \
    X(TEST_ASSERT_EQUAL_INT8, (-1, 255), (-128, 127), "Expected -128 Was 127")               \
    X(TEST_ASSERT_EQUAL_INT16, (-1, 65535), (-32768, 1), "Expected -32768 Was 1")            \
    X(TEST_ASSERT_EQUAL_INT32, (-1, UINT32_MAX), (INT32_MIN, 0), "-2147483648 Was 0")        \
    X(TEST_ASSERT_EQUAL_INT64, (-1, UINT64_MAX), (-INT64_MAX, 0), "-9223372036854775807")    \
    X(TEST_ASSERT_EQUAL_UINT, (7u, 7u), (UINT32_MAX, 0u), "Expected 4294967295 Was 0")       \
    X(TEST_ASSERT_EQUAL_UINT8, (255, -1), (255, 0), "Expected 255 Was 0")                    \
    X(TEST_ASSERT_EQUAL_UINT16, (65535, -1), (65535, 0), "Expected 65535 Was 0")             \
    X(TEST_ASSERT_EQUAL_UINT32, (UINT32_MAX, -1), (UINT32_MAX, 0), "4294967295 Was 0")       \
    X(TEST_ASSERT_EQUAL_UINT64, (UINT64_MAX, -1), (UINT64_MAX, 0), "18446744073709551615")   \
    X(TEST_ASSERT_EQUAL_HEX, (0xF, 0xF), (0xF, 0x1E), "Expected 0x0000000F Was 0x0000001E")  \
    X(TEST_ASSERT_EQUAL_HEX8, (0xFF, -1), (0xF, 0xFF), "Expected 0x0F Was 0xFF")             \
    X(TEST_ASSERT_EQUAL_HEX16, (0xFFFF, -1), (0xF, -1), "Expected 0x000F Was 0xFFFF")        \
    X(TEST_ASSERT_EQUAL_HEX32, (UINT32_MAX, -1), (0xF, -1), "0x0000000F Was 0xFFFFFFFF")     \
    X(TEST_ASSERT_EQUAL_HEX64, (UINT64_MAX, -1), (0xF, -1), "0x000000000000000F Was 0xFFFF") \
    X(TEST_ASSERT_EQUAL_PTR, (object, object), (object, object + 1), OURS("0x", "Expected "))

#define ORDERS(X)                                             \
    X(TEST_ASSERT_GREATER_THAN_INT, (-5, -4), (-5, -5), "-5") \
    X(TEST_ASSERT_LESS_THAN_INT, (-5, -6), (-5, -5), "-5")    \
    X(TEST_ASSERT_GREATER_OR_EQUAL_INT, (5, 5), (5, 4), "4")  \
    X(TEST_ASSERT_LESS_OR_EQUAL_INT, (5, 5), (5, 6), "6")

#define INTERVALS(X)                                                                \
    X(TEST_ASSERT_INT_WITHIN, (2, -1, 1), (1, -1, 1), "-1 Was 1")                   \
    X(TEST_ASSERT_INT8_WITHIN, (255, -128, 127), (254, -128, 127), "-128")          \
    X(TEST_ASSERT_INT16_WITHIN, (2, -1, 1), (1, -1, 1), "-1 Was 1")                 \
    X(TEST_ASSERT_INT32_WITHIN, (2, -1, 1), (1, -1, 1), "-1 Was 1")                 \
    X(TEST_ASSERT_INT64_WITHIN, (2, -1, 1), (1, -1, 1), "-1 Was 1")                 \
    X(TEST_ASSERT_UINT_WITHIN, (2, 3, 1), (1, 3, 1), "3 Was 1")                     \
    X(TEST_ASSERT_UINT8_WITHIN, (255, 0, 255), (254, 0, 255), "0 Was 255")          \
    X(TEST_ASSERT_UINT16_WITHIN, (2, 3, 1), (1, 3, 1), "3 Was 1")                   \
    X(TEST_ASSERT_UINT32_WITHIN, (2, 3, 1), (1, 0, UINT32_MAX), "0 Was 4294967295") \
    X(TEST_ASSERT_UINT64_WITHIN, (2, 3, 1), (1, 0, UINT64_MAX), "0 Was 18446744073709551615")

#define MEMORIES(X)                                                                           \
    X(TEST_ASSERT_EQUAL_STRING, ("abc", "abc"), ("abc", "abd"), "Expected 'abc' Was 'abd'")   \
    X(TEST_ASSERT_EQUAL_MEMORY, ("abc", "abd", 2), ("abc", "abd", 3),                         \
      OURS("0x63 Was 0x64", " Was "))                                                         \
    X(TEST_ASSERT_EQUAL_INT32_ARRAY, (numbers, same_numbers, 3), (numbers, other_numbers, 3), \
      "Element 2 Expected 3 Was 4")

#define REALS(X)                                                                    \
    X(TEST_ASSERT_FLOAT_WITHIN, (0.5f, 1.0f, 1.5f), (0.5f, 1.0f, 1.75f), "1.75")    \
    X(TEST_ASSERT_DOUBLE_WITHIN, (0.5, 1.0, 1.5), (0.5, 1.0, 1.75), "1.75")         \
    X(TEST_ASSERT_EQUAL_FLOAT, (-1.0f, -1.000009f), (-1.0f, -1.000011f), "-1.0000") \
    X(TEST_ASSERT_EQUAL_DOUBLE, (-1.0, -1.0000000000009), (-1.0, -1.25), "-1.25")

#if DBL_MANT_DIG == 53
#define LARGEST "1.7976"
#else /* AVR */
#define LARGEST "3.4028"
#endif

/* Each kind of value against each assertion would be a large table: the failing argument is the
 * value nearest in kind. */
#define KINDS(X)                                                      \
    X(TEST_ASSERT_FLOAT_IS_INF, (INFINITY), (-INFINITY), "inf")       \
    X(TEST_ASSERT_FLOAT_IS_NEG_INF, (-INFINITY), (INFINITY), "inf")   \
    X(TEST_ASSERT_FLOAT_IS_NAN, (NAN), (INFINITY), "inf")             \
    X(TEST_ASSERT_FLOAT_IS_DETERMINATE, (FLT_MAX), (INFINITY), "inf") \
    X(TEST_ASSERT_FLOAT_IS_NOT_INF, (-INFINITY), (INFINITY), "inf")   \
    X(TEST_ASSERT_FLOAT_IS_NOT_NEG_INF, (NAN), (-INFINITY), "-inf")   \
    X(TEST_ASSERT_FLOAT_IS_NOT_NAN, (INFINITY), (NAN), "nan")         \
    X(TEST_ASSERT_FLOAT_IS_NOT_DETERMINATE, (NAN), (0.0f), "0")       \
    X(TEST_ASSERT_DOUBLE_IS_INF, (INFINITY), (DBL_MAX), LARGEST)      \
    X(TEST_ASSERT_DOUBLE_IS_NEG_INF, (-INFINITY), (INFINITY), "inf")  \
    X(TEST_ASSERT_DOUBLE_IS_NAN, (NAN), (0.0), "0")                   \
    X(TEST_ASSERT_DOUBLE_IS_DETERMINATE, (DBL_MAX), (NAN), "nan")     \
    X(TEST_ASSERT_DOUBLE_IS_NOT_INF, (DBL_MAX), (INFINITY), "inf")    \
    X(TEST_ASSERT_DOUBLE_IS_NOT_NEG_INF, (NAN), (-INFINITY), "-inf")  \
    X(TEST_ASSERT_DOUBLE_IS_NOT_NAN, (INFINITY), (NAN), "nan")        \
    X(TEST_ASSERT_DOUBLE_IS_NOT_DETERMINATE, (-INFINITY), (1.5), "1.5")

#define ASSERTIONS(X) TRUTHS(X) INTEGERS(X) ORDERS(X) INTERVALS(X) MEMORIES(X) REALS(X) KINDS(X)

#define NOTE                   "a note from the test"
#define WITH_NOTE(...)         (__VA_ARGS__, NOTE)
#define APPLY(assertion, args) assertion args

#define DEFINE_PROBES(assertion, good, bad, reason) \
    static void assertion##_passes(void)            \
    {                                               \
        APPLY(assertion, good);                     \
    }                                               \
    static void assertion##_fails(void)             \
    {                                               \
        APPLY(assertion, bad);                      \
    }                                               \
    static void assertion##_passes_with_note(void)  \
    {                                               \
        APPLY(assertion##_MESSAGE, WITH_NOTE good); \
    }                                               \
    static void assertion##_fails_with_note(void)   \
    {                                               \
        APPLY(assertion##_MESSAGE, WITH_NOTE bad);  \
    }

ASSERTIONS(DEFINE_PROBES)

#define PROBE(function)     \
    {                       \
#function, function \
    }
#define ROW(assertion, good, bad, reason) \
    {#assertion,                          \
     reason,                              \
     assertion##_passes,                  \
     assertion##_fails,                   \
     assertion##_passes_with_note,        \
     assertion##_fails_with_note},

static const struct row {
    const char *assertion, *reason;
    void (*passes)(void), (*fails)(void), (*passes_with_note)(void), (*fails_with_note)(void);
} rows[] = {ASSERTIONS(ROW)};

/* Named after its row when it is needed: four names for each row would fill 8 KB of RAM */
static const struct probe *probe_of(const struct row *row, const char *what, void (*test)(void))
{
    static char name[64];
    static struct probe probe = {.name = name};
    (void)snprintf(name, sizeof name, "%s %s", row->assertion, what);
    probe.test = test;
    return &probe;
}

static void test_every_assertion_passes_when_it_should(void)
{
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        expect_pass(probe_of(&rows[i], "passes", rows[i].passes));
        expect_pass(probe_of(&rows[i], "passes with note", rows[i].passes_with_note));
    }
}

static void test_every_assertion_fails_when_it_should(void)
{
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        expect_failure(probe_of(&rows[i], "fails", rows[i].fails), rows[i].reason);
        expect(strstr(transcript, NOTE) == NULL, rows[i].assertion);
        expect_failure(probe_of(&rows[i], "fails with note", rows[i].fails_with_note), NOTE);
    }
}

/* ---- Cases beside the table ---- */

enum verdict { PASSES, FAILS };

/* X(name, verdict, statement) */
#define CORNERS(X)                                                                         \
    X(int_within_below, PASSES, TEST_ASSERT_INT_WITHIN(2, 1, -1))                          \
    X(int_outside_below, FAILS, TEST_ASSERT_INT_WITHIN(1, 1, -1))                          \
    X(uint_within_below, PASSES, TEST_ASSERT_UINT_WITHIN(2, 1, 3))                         \
    X(uint64_is_not_signed, FAILS, TEST_ASSERT_UINT64_WITHIN(2, UINT64_MAX, 0))            \
    X(less_is_not_greater, FAILS, TEST_ASSERT_GREATER_THAN_INT(5, 4))                      \
    X(greater_is_not_less, FAILS, TEST_ASSERT_LESS_THAN_INT(5, 6))                         \
    X(more_is_at_least, PASSES, TEST_ASSERT_GREATER_OR_EQUAL_INT(5, 6))                    \
    X(less_is_at_most, PASSES, TEST_ASSERT_LESS_OR_EQUAL_INT(5, 4))                        \
    X(not_equal_below, PASSES, TEST_ASSERT_NOT_EQUAL(8, 7))                                \
    X(string_and_prefix, FAILS, TEST_ASSERT_EQUAL_STRING("abc", "ab"))                     \
    X(prefix_and_string, FAILS, TEST_ASSERT_EQUAL_STRING("ab", "abc"))                     \
    X(string_and_null, FAILS, TEST_ASSERT_EQUAL_STRING("", no_text))                       \
    X(null_and_string, FAILS, TEST_ASSERT_EQUAL_STRING(no_text, ""))                       \
    X(null_and_null, PASSES, TEST_ASSERT_EQUAL_STRING(no_text, no_text))                   \
    X(memory_of_no_bytes, FAILS, TEST_ASSERT_EQUAL_MEMORY("a", "a", 0))                    \
    X(memory_and_null, FAILS, TEST_ASSERT_EQUAL_MEMORY("a", no_text, 1))                   \
    X(array_of_none, FAILS, TEST_ASSERT_EQUAL_INT32_ARRAY(numbers, numbers, 0))            \
    X(array_and_itself, PASSES, TEST_ASSERT_EQUAL_INT32_ARRAY(numbers, numbers, 3))        \
    X(float_within_below, PASSES, TEST_ASSERT_FLOAT_WITHIN(0.5f, 1.0f, 0.5f))              \
    X(float_outside_below, FAILS, TEST_ASSERT_FLOAT_WITHIN(0.5f, 1.0f, 0.25f))             \
    X(float_and_nan, FAILS, TEST_ASSERT_FLOAT_WITHIN(1.0f, 1.0f, NAN))                     \
    X(nan_and_float, FAILS, TEST_ASSERT_FLOAT_WITHIN(1.0f, NAN, 1.0f))                     \
    X(infinity_and_itself, PASSES, TEST_ASSERT_FLOAT_WITHIN(1.0f, INFINITY, INFINITY))     \
    X(infinity_and_float, FAILS, TEST_ASSERT_FLOAT_WITHIN(INFINITY, INFINITY, 1.0f))       \
    X(opposite_infinities, FAILS, TEST_ASSERT_FLOAT_WITHIN(INFINITY, INFINITY, -INFINITY)) \
    X(equal_to_infinity, FAILS, TEST_ASSERT_EQUAL_FLOAT(INFINITY, 1.0f))                   \
    X(equal_zeros, PASSES, TEST_ASSERT_EQUAL_FLOAT(0.0f, -0.0f))                           \
    X(nan_is_no_infinity, FAILS, TEST_ASSERT_FLOAT_IS_INF(NAN))                            \
    X(nan_is_not_determinate, FAILS, TEST_ASSERT_FLOAT_IS_DETERMINATE(NAN))                \
    X(minus_infinity_is_not_determinate, FAILS, TEST_ASSERT_FLOAT_IS_DETERMINATE(-INFINITY))

#define DEFINE_CORNER(name, verdict, statement) \
    static void name(void)                      \
    {                                           \
        statement;                              \
    }
#define CORNER(name, verdict, statement) {PROBE(name), verdict},

CORNERS(DEFINE_CORNER)

static const struct corner {
    struct probe probe;
    enum verdict verdict;
} corners[] = {CORNERS(CORNER)};

static void test_corner_cases(void)
{
    for (size_t i = 0; i < sizeof corners / sizeof corners[0]; i++) {
        if (corners[i].verdict == PASSES) {
            expect_pass(&corners[i].probe);
        } else {
            expect_failure(&corners[i].probe, "");
        }
    }
}

/* ---- The course of a test ---- */

static int line_of_failure;

static void fails_here(void)
{
    line_of_failure = __LINE__ + 1;
    TEST_FAIL_MESSAGE("because");
    reached++;
}

static void fails_without_reason(void)
{
    TEST_FAIL();
    reached++;
}

static void ignores(void)
{
    TEST_IGNORE_MESSAGE("later");
    reached++;
}

static void ignores_without_reason(void)
{
    TEST_IGNORE();
    reached++;
}

static void passes_early(void)
{
    TEST_PASS();
    reached++;
}

static void passes(void)
{
    reached++;
}

static void test_a_failing_test_is_left_at_once(void)
{
    char report[200];
    const struct session s = run_one("fails_here", fails_here);
    (void)snprintf(report, sizeof report, "%s:%d:fails_here:FAIL", __FILE__, line_of_failure);
    expect_printed(report, report);
    expect_report("fails_here", "FAIL", "because\n");
    expect(s.failures == 1 && s.status == 1, "one failure");
    expect(reached == 0 && tear_downs == 1, "tearDown only");
}

static void test_a_failure_needs_no_reason(void)
{
    const struct session s = run_one("fails_without_reason", fails_without_reason);
    expect_verdict("fails_without_reason", "FAIL");
    expect(s.failures == 1 && s.ignores == 0 && reached == 0, "one failure");
}

static void test_an_ignored_test_is_left_at_once_and_does_not_fail(void)
{
    const struct session s = run_one("ignores", ignores);
    expect_report("ignores", "IGNORE", "later\n");
    expect(s.tests == 1 && s.failures == 0 && s.ignores == 1 && s.status == 0, "one ignored");
    expect(reached == 0 && tear_downs == 1, "tearDown only");
}

static void test_ignoring_needs_no_reason(void)
{
    const struct session s = run_one("ignores_without_reason", ignores_without_reason);
    expect_verdict("ignores_without_reason", "IGNORE");
    expect(s.failures == 0 && s.ignores == 1 && reached == 0, "one ignored");
}

static void test_a_test_may_pass_early(void)
{
    const struct session s = run_one("passes_early", passes_early);
    expect_verdict("passes_early", "PASS\n");
    expect(s.failures == 0 && reached == 0 && tear_downs == 1, "passed early");
}

static void test_a_failing_set_up_replaces_the_test(void)
{
    on_set_up = fails_here;
    const struct session s = run_one("passes", passes);
    expect(s.failures == 1 && reached == 0 && tear_downs == 1, "failed in setUp");
}

static void test_a_failing_tear_down_fails_the_test(void)
{
    on_tear_down = fails_here;
    const struct session s = run_one("passes", passes);
    expect(s.failures == 1 && reached == 1, "failed in tearDown");
}

static void test_failing_twice_counts_once(void)
{
    on_tear_down = fails_here;
    const struct session s = run_one("fails_without_reason", fails_without_reason);
    expect(s.tests == 1 && s.failures == 1, "one failure");
    expect(strstr(transcript, "because") == NULL, "one report");
}

/* ---- Sessions ---- */

static void test_the_summary_counts_failures_and_ignores(void)
{
    static const struct probe mixed[] = {PROBE(passes), PROBE(fails_here), PROBE(ignores),
                                         PROBE(fails_without_reason), PROBE(passes)};
    const struct session s = run(mixed, 5);
    expect(s.status == 2, "the number of failures");
    expect_printed("\n-----------------------\n5 Tests 2 Failures 1 Ignored", "summary");
    expect_printed("\nFAIL\n", "verdict");
    expect(set_ups == 5 && tear_downs == 5 && reached == 2, "every test between its fixtures");
}

static void test_a_session_without_failures_is_ok(void)
{
    static const struct probe fine[] = {PROBE(passes), PROBE(ignores)};
    const struct session s = run(fine, 2);
    expect(s.status == 0, "no failures");
    expect_printed("\n-----------------------\n2 Tests 0 Failures 1 Ignored", "summary");
    expect_printed("\nOK\n", "verdict");
}

static void test_a_session_starts_from_zero(void)
{
    (void)run_one("fails_here", fails_here);
    expect(run_one("passes", passes).failures == 0, "failures of the session before");
}

/* ---- What only this project's Unity promises ---- */

#ifdef UNITY_STRICT

static void nan_within_of_nan(void)
{
    TEST_ASSERT_FLOAT_WITHIN(1.0f, NAN, NAN);
}

static void within_nan(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(NAN, 1.0, 2.0);
}

static void test_nan_is_never_close(void)
{
    expect_failure(&(struct probe)PROBE(nan_within_of_nan), "Expected within 1.0");
    expect_failure(&(struct probe)PROBE(within_nan), "Expected within nan of");
}

static void test_a_session_of_no_tests_fails(void)
{
    const struct session s = run(NULL, 0);
    expect(s.status == 1, "no tests");
    expect_printed("0 Tests 0 Failures 0 Ignored\nFAIL\n", "summary");
}

/* Upstream overflows here. */
static void whole_range(void)
{
    TEST_ASSERT_INT64_WITHIN(INT64_MAX, INT64_MIN, INT64_MAX);
}

static void test_the_whole_range_of_integers(void)
{
    expect_failure(&(struct probe)PROBE(whole_range),
                   "Expected within 9223372036854775807 of -9223372036854775808 Was 92233720");
}

static double number;

static void shows_number(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(0.0, NAN, number);
}

static void test_reals_are_printed_with_nine_digits(void)
{
    static const struct {
        double value;
        const char *text;
    } cases[] = {
        {0.0, "Was 0\n"},
        {1.0, "Was 1.00000000e+00\n"},
#if DBL_MANT_DIG == 53
        {-0.1, "Was -1.00000000e-01\n"},
        {123456789.0, "Was 1.23456789e+08\n"},
        {9999999996.0, "Was 1.00000000e+10\n"},
        {9999999994.0, "Was 9.99999999e+09\n"},
        {(double)FLT_MAX, "Was 3.40282347e+38\n"},
        {(double)FLT_MIN, "Was 1.17549435e-38\n"},
        {DBL_MAX, "Was 1.79769313e+308\n"},
        {4.9406564584124654e-324, "Was 4.94065646e-324\n"},
#else /* AVR: 7 digits are right */
        {-0.1, "Was -1.000000"},
        {123456789.0, "Was 1.234567"},
        {(double)FLT_MAX, "Was 3.402823"},
        {(double)FLT_MIN, "Was 1.175494"},
#endif
        {(double)INFINITY, "Was inf\n"},
        {(double)-INFINITY, "Was -inf\n"},
        {(double)NAN, "Was nan\n"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        number = cases[i].value;
        expect_failure(&(struct probe)PROBE(shows_number), cases[i].text);
    }
}

#endif

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_assertion_passes_when_it_should);
    RUN_TEST(test_every_assertion_fails_when_it_should);
    RUN_TEST(test_corner_cases);
    RUN_TEST(test_a_failing_test_is_left_at_once);
    RUN_TEST(test_a_failure_needs_no_reason);
    RUN_TEST(test_an_ignored_test_is_left_at_once_and_does_not_fail);
    RUN_TEST(test_ignoring_needs_no_reason);
    RUN_TEST(test_a_test_may_pass_early);
    RUN_TEST(test_a_failing_set_up_replaces_the_test);
    RUN_TEST(test_a_failing_tear_down_fails_the_test);
    RUN_TEST(test_failing_twice_counts_once);
    RUN_TEST(test_the_summary_counts_failures_and_ignores);
    RUN_TEST(test_a_session_without_failures_is_ok);
    RUN_TEST(test_a_session_starts_from_zero);
#ifdef UNITY_STRICT
    RUN_TEST(test_nan_is_never_close);
    RUN_TEST(test_a_session_of_no_tests_fails);
    RUN_TEST(test_the_whole_range_of_integers);
    RUN_TEST(test_reals_are_printed_with_nine_digits);
#endif
    return UNITY_END() != 0 || surprises != 0 || expectations == 0;
}
