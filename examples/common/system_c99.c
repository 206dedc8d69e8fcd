/* SPDX-License-Identifier: MIT */
#include "system.h"

#include "text.h"

#include <stdlib.h>
#include <string.h>

bool system_same_file(const char *one, const char *other)
{
    return strcmp(one, other) == 0;
}

bool system_is_stream(const char *name)
{
    (void)name;
    return false;
}

FILE *system_open_stream(const char *name)
{
    return fopen(name, "wb");
}

bool system_follow(char *target, const char *name)
{
    const int length = snprintf(target, SYSTEM_NAME_MAX + 1, "%s", name);
    return length >= 0 && length <= SYSTEM_NAME_MAX;
}

static bool is_there(const char *name)
{
    FILE *const file = fopen(name, "rb");
    if (file != NULL) {
        (void)fclose(file);
    }
    return file != NULL;
}

FILE *system_create(char *temporary, const char *name)
{
    const int length = snprintf(temporary, SYSTEM_NAME_MAX + 1, "%s.tmp", name);
    const bool fits = length >= 0 && length <= SYSTEM_NAME_MAX;
    return fits && !is_there(temporary) ? fopen(temporary, "wb") : NULL;
}

void system_keep(void)
{
}

bool system_stderr_is_terminal(void)
{
    return false;
}

#ifdef _WIN32
static const char silently[] = ">NUL 2>&1";
#else
static const char silently[] = ">/dev/null 2>&1";
#endif

static bool run(const char *command)
{
    (void)fflush(NULL);          /* what is in our buffers comes before what the command does */
    return system(command) == 0; /* NOLINT(cert-env33-c): every word of it is plain */
}

static bool has_gnuplot(void)
{
    char command[64];
    (void)snprintf(command, sizeof command, "gnuplot --version %s", silently);
    return run(command);
}

/* Through a shell, so only with names that it cannot misunderstand */
gnuplot_status_t system_gnuplot(const char *script, const char *data, const char *picture)
{
    char command[4096];
    const int length = snprintf(command, sizeof command, "gnuplot -c %s %s %s %s", script, data,
                                picture, silently);
    const bool fits = length > 0 && (size_t)length < sizeof command;
    if (!fits || !text_is_plain(script) || !text_is_plain(data) || !text_is_plain(picture) ||
        !has_gnuplot()) {
        return GNUPLOT_NOT_RUN;
    }
    return run(command) ? GNUPLOT_SUCCEEDED : GNUPLOT_FAILED;
}
