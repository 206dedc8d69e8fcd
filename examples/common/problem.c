/* SPDX-License-Identifier: MIT */
#include "problem.h"

#include "progress.h"

#include <stdarg.h>
#include <stdio.h>

static const char *program;

void problem_from(const char *name)
{
    program = name;
}

/* A message quotes files and arguments, which may hold anything: it must stay one readable line */
static void make_printable(char *text)
{
    for (; *text != '\0'; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c < ' ' || c == 127) {
            *text = '?';
        }
    }
}

bool problem(const char *format, ...)
{
    char message[PROBLEM_LENGTH_MAX + 1];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    make_printable(message);
    progress_end();
    (void)fprintf(stderr, "%s: %s\n", program, message);
    return false;
}
