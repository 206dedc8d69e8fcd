/* SPDX-License-Identifier: MIT */
#include "unity.h"

#include <float.h>
#include <stdarg.h>

/* The only way out: called with one character, as an int. To send it elsewhere, define this and,
 * for the compiler, UNITY_OUTPUT_CHAR_HEADER_DECLARATION: for instance board_put, board_put(int).
 */
#ifndef UNITY_OUTPUT_CHAR
#include <stdio.h>
#define UNITY_OUTPUT_CHAR(c) (void)putchar(c)
#elif defined(UNITY_OUTPUT_CHAR_HEADER_DECLARATION)
extern void UNITY_OUTPUT_CHAR_HEADER_DECLARATION;
#endif

struct UNITY_STORAGE_T Unity;

/* ---- Printing: our own, since a microcontroller's printf may lack floats or 64 bits ---- */

static void print_text(const char *text)
{
    for (text = text == NULL ? "NULL" : text; *text != '\0'; text++) {
        UNITY_OUTPUT_CHAR(*text);
    }
}

static void print_digits(uint64_t value, unsigned base, int min_digits)
{
    char digits[20]; /* the longest: 2^64 - 1 in decimal */
    int n = 0;
    do {
        digits[n++] = "0123456789ABCDEF"[value % base];
        value /= base;
    } while (value != 0 || n < min_digits);
    while (n > 0) {
        UNITY_OUTPUT_CHAR(digits[--n]);
    }
}

static void print_integer(int64_t value, int style)
{
    const int negative = style == UNITY_SIGNED && value < 0;
    if (style >= 2) {
        print_text("0x");
        print_digits((uint64_t)value, 16, style);
    } else {
        print_text(negative ? "-" : "");
        print_digits(negative ? 0 - (uint64_t)value : (uint64_t)value, 10, 1);
    }
}

/* d.dddddddde+xx of a positive finite x: nine digits tell any two floats apart. They come from the
 * integer x * 10^k in [10^8, 10^9), where k is reached in few steps by powers of ten that even a
 * float represents exactly; that keeps 7 digits right where double has 4 bytes. */
static void print_scientific(double x)
{
    int exponent = 8;
    double up = 1.0;
    double down = 1.0;
    for (; x >= 1e16; exponent += 8) {
        x /= 1e8;
    }
    for (; x < 1.0; exponent -= 8) {
        x *= 1e8;
    }
    for (; x * up < 1e8; exponent--) {
        up *= 10.0;
    }
    for (; x / down >= 1e9; exponent++) {
        down *= 10.0;
    }
    uint32_t digits = (uint32_t)(x * up / down + 0.5);
    if (digits >= 1000000000) {
        digits /= 10;
        exponent++;
    }
    print_digits(digits / 100000000, 10, 1);
    UNITY_OUTPUT_CHAR('.');
    print_digits(digits % 100000000, 10, 8);
    print_text(exponent < 0 ? "e-" : "e+");
    print_digits((uint64_t)(exponent < 0 ? -exponent : exponent), 10, 2);
}

static void print_real(double x)
{
    if (x < 0.0) {
        UNITY_OUTPUT_CHAR('-');
        x = -x;
    }
    if (x > 0.0 && x <= DBL_MAX) {
        print_scientific(x);
    } else {
        print_text(x > 0.0 ? "inf" : x == 0.0 ? "0" : "nan");
    }
}

/* %s text; %u unsigned; %i int64_t, then its style; %r real. */
static void print_list(const char *format, va_list args)
{
    for (; *format != '\0'; format++) {
        if (*format != '%') {
            UNITY_OUTPUT_CHAR(*format);
            continue;
        }
        switch (*++format) {
        case 's':
            print_text(va_arg(args, const char *));
            break;
        case 'u':
            print_digits(va_arg(args, unsigned), 10, 1);
            break;
        case 'r':
            print_real(va_arg(args, double));
            break;
        default: {
            const int64_t value = va_arg(args, int64_t);
            print_integer(value, va_arg(args, int));
        }
        }
    }
}

static void print(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    print_list(format, args);
    va_end(args);
}

/* ---- Running ---- */

void UnityBegin(const char *file)
{
    Unity = (struct UNITY_STORAGE_T){.TestFile = file};
}

/* A run of no tests has checked nothing, most likely by mistake: it fails, and returns 1. Upstream
 * says OK and returns 0. */
int UnityEnd(void)
{
    const int empty = Unity.NumberOfTests == 0;
    print("\n-----------------------\n%u Tests %u Failures %u Ignored\n%s\n", Unity.NumberOfTests,
          Unity.TestFailures, Unity.TestIgnores, empty || Unity.TestFailures ? "FAIL" : "OK");
    return empty ? 1 : (int)Unity.TestFailures;
}

static void print_verdict(const char *verdict, int line)
{
    print("%s:%u:%s:%s", Unity.TestFile, (unsigned)line, Unity.CurrentTestName, verdict);
}

void UnityDefaultTestRun(void (*test)(void), const char *name, int line)
{
    Unity.CurrentTestName = name;
    Unity.CurrentTestLineNumber = line;
    Unity.CurrentTestFailed = 0;
    Unity.CurrentTestIgnored = 0;
    Unity.NumberOfTests++;
    if (TEST_PROTECT()) {
        setUp();
        test();
    }
    if (TEST_PROTECT()) {
        tearDown();
    }
    Unity.TestFailures += Unity.CurrentTestFailed;
    Unity.TestIgnores += Unity.CurrentTestIgnored;
    if (!Unity.CurrentTestFailed && !Unity.CurrentTestIgnored) {
        print_verdict("PASS\n", Unity.CurrentTestLineNumber);
    }
}

/* A test has one verdict: what tearDown meets after it is not reported again. */
static void leave_if_decided(void)
{
    if (Unity.CurrentTestFailed || Unity.CurrentTestIgnored) {
        TEST_ABORT();
    }
}

static void fail(const char *message, int line, const char *format, ...)
{
    va_list args;
    leave_if_decided();
    Unity.CurrentTestFailed = 1;
    print_verdict("FAIL: ", line);
    va_start(args, format);
    print_list(format, args);
    va_end(args);
    print("%s%s\n", message == NULL ? "" : ". ", message == NULL ? "" : message);
    TEST_ABORT();
}

void UnityFail(const char *reason, const char *message, int line)
{
    fail(message, line, "%s", reason);
}

void UnityIgnore(const char *reason, int line)
{
    leave_if_decided();
    Unity.CurrentTestIgnored = 1;
    print_verdict("IGNORE: ", line);
    print("%s\n", reason);
    TEST_ABORT();
}

/* ---- Assertions ---- */

void UnityAssertNumber(int64_t expected, int64_t actual, int allowed, int style,
                       const char *message, int line)
{
    static const char *const wanted[] = {
        "", "less than ", "", "at most ", "greater than ", "anything but ", "at least "};
    const int order = actual > expected ? UNITY_GREATER : UNITY_LESS;
    if (((actual == expected ? UNITY_EQUAL : order) & allowed) == 0) {
        fail(message, line, "Expected %s%i Was %i", wanted[allowed], expected, style, actual,
             style);
    }
}

void UnityAssertNear(uint64_t delta, int64_t expected, int64_t actual, int style,
                     const char *message, int line)
{
    const uint64_t e = (uint64_t)expected;
    const uint64_t a = (uint64_t)actual;
    const int below = style == UNITY_SIGNED ? actual < expected : a < e;
    if ((below ? e - a : a - e) > delta) {
        fail(message, line, "Expected within %i of %i Was %i", (int64_t)delta, UNITY_UNSIGNED,
             expected, style, actual, style);
    }
}

static int same_text(const char *a, const char *b)
{
    if (a == NULL || b == NULL) {
        return a == b;
    }
    for (; *a == *b && *a != '\0'; a++) {
        b++;
    }
    return *a == *b;
}

void UnityAssertString(const char *expected, const char *actual, const char *message, int line)
{
    if (!same_text(expected, actual)) {
        fail(message, line, "Expected '%s' Was '%s'", expected, actual);
    }
}

/* How many elements to compare one by one; fails where that cannot be done. */
static size_t comparable(const void *expected, const void *actual, size_t count,
                         const char *message, int line)
{
    if (count == 0) {
        fail(message, line, "Expected something to compare");
    }
    if (expected != actual && (expected == NULL || actual == NULL)) {
        fail(message, line, "Expected %s Was %s", expected ? "data" : "NULL",
             actual ? "data" : "NULL");
    }
    return expected == actual ? 0 : count;
}

static void compare_element(size_t index, int64_t expected, int64_t actual, int style,
                            const char *message, int line)
{
    if (expected != actual) {
        fail(message, line, "Element %i Expected %i Was %i", (int64_t)index, UNITY_UNSIGNED,
             expected, style, actual, style);
    }
}

void UnityAssertMemory(const void *expected, const void *actual, size_t count, const char *message,
                       int line)
{
    const unsigned char *e = expected;
    const unsigned char *a = actual;
    count = comparable(e, a, count, message, line);
    for (size_t i = 0; i < count; i++) {
        compare_element(i, e[i], a[i], 2, message, line);
    }
}

void UnityAssertInt32Array(const int32_t *expected, const int32_t *actual, size_t count,
                           const char *message, int line)
{
    count = comparable(expected, actual, count, message, line);
    for (size_t i = 0; i < count; i++) {
        compare_element(i, expected[i], actual[i], UNITY_SIGNED, message, line);
    }
}

static int kind_of(double x)
{
    const int finite = x >= -DBL_MAX && x <= DBL_MAX;
    const int infinite = x > 0.0 ? UNITY_INF : UNITY_NINF;
    return finite ? UNITY_NUM : x == x ? infinite : UNITY_NAN;
}

/* Equal infinities are close, different ones never; nothing is close to NaN, nor within NaN. */
static int is_close(double delta, double expected, double actual)
{
    const double difference = expected > actual ? expected - actual : actual - expected;
    return expected == actual ||
           (difference <= (delta < 0.0 ? -delta : delta) && kind_of(difference) == UNITY_NUM);
}

void UnityAssertClose(double delta, double expected, double actual, const char *message, int line)
{
    if (!is_close(delta, expected, actual)) {
        fail(message, line, "Expected within %r of %r Was %r", delta, expected, actual);
    }
}

void UnityAssertKind(double actual, int kind, int is, const char *message, int line)
{
    static const char *const names[] = {"nan", "inf", "-inf", "finite"};
    if ((kind_of(actual) == kind) != is) {
        fail(message, line, "Expected %s%s Was %r", is ? "" : "not ", names[kind], actual);
    }
}
