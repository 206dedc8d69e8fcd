/* SPDX-License-Identifier: MIT */
#include "claims.h"

#include "problem.h"
#include "progress.h"

#include <stdarg.h>
#include <stdio.h>

typedef struct {
    double measured, limit;
    const char *unit;
    const char *relation;
    bool holds;
} verdict_t;

static void print(claims_t *claims, const verdict_t *verdict, const char *format, va_list arguments)
{
    progress_end();
    (void)printf("| %s | ", claims->figure);
    (void)vprintf(format, arguments);
    const char *space = *verdict->unit != '\0' ? " " : "";
    (void)printf(" | %.3g%s%s | %s %g | %s |\n", verdict->measured, space, verdict->unit,
                 verdict->relation, verdict->limit, verdict->holds ? "holds" : "FAILS");
    claims->stated++;
    claims->failed += !verdict->holds;
}

void claim_at_most(claims_t *claims, double measured, double limit, const char *unit,
                   const char *format, ...)
{
    const verdict_t verdict = {measured, limit, unit, "<=", measured <= limit};
    va_list arguments;
    va_start(arguments, format);
    print(claims, &verdict, format, arguments);
    va_end(arguments);
}

void claim_at_least(claims_t *claims, double measured, double limit, const char *unit,
                    const char *format, ...)
{
    const verdict_t verdict = {measured, limit, unit, ">=", measured >= limit};
    va_list arguments;
    va_start(arguments, format);
    print(claims, &verdict, format, arguments);
    va_end(arguments);
}

bool claims_hold(const claims_t *claims)
{
    (void)printf("%u claims, %u fail\n", claims->stated, claims->failed);
    if (claims->stated == 0 || claims->failed > 0) {
        return problem("%u of %u claims do not hold", claims->failed, claims->stated);
    }
    return true;
}
