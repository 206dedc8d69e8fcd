/* SPDX-License-Identifier: MIT */
#include "progress.h"

#include "system.h"

#include <stdarg.h>
#include <stdio.h>
#include <time.h>

static int width; /* of the line that is shown; 0: none is */
static clock_t shown_at;

static bool is_due(void)
{
    const clock_t now = clock();
    const bool due = width == 0 || now - shown_at >= CLOCKS_PER_SEC / 10;
    if (due) {
        shown_at = now;
    }
    return due;
}

void progress_show(const char *format, ...)
{
    static int is_terminal = -1; /* not asked yet */
    if (is_terminal < 0) {
        is_terminal = system_stderr_is_terminal();
    }
    if (!is_terminal || !is_due()) {
        return;
    }
    va_list arguments;
    progress_end();
    va_start(arguments, format);
    width = vfprintf(stderr, format, arguments);
    va_end(arguments);
    (void)fflush(stderr);
}

void progress_end(void)
{
    if (width > 0) {
        (void)fprintf(stderr, "\r%*s\r", width, "");
    }
    width = 0;
}
