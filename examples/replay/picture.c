/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char script[] = EPF_REPLAY_DIR "/plot.gp";

#ifdef _WIN32
static const char silently[] = ">NUL 2>&1";
#else
static const char silently[] = ">/dev/null 2>&1";
#endif

/* Made only of characters that mean nothing to any shell */
static bool is_harmless(const char *name)
{
    return name[strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
                             "_./+-")] == '\0';
}

bool picture_draw(const char *data, const char *picture)
{
    char command[4096];
    const int length = snprintf(command, sizeof command, "gnuplot -c %s %s %s %s", script, data,
                                picture, silently);
    const bool fits = length > 0 && (size_t)length < sizeof command;
    if (!fits || !is_harmless(script) || !is_harmless(data) || !is_harmless(picture)) {
        return false;
    }
    (void)fflush(NULL);          /* what is in our buffers comes before what the command does */
    return system(command) == 0; /* NOLINT(cert-env33-c): every word of it is harmless */
}

/* Between apostrophes a POSIX shell takes everything as it is, except an apostrophe */
static void print_word(const char *word)
{
    if (is_harmless(word)) {
        (void)printf(" %s", word);
        return;
    }
    (void)fputs(" '", stdout);
    for (; *word != '\0'; word++) {
        if (*word == '\'') {
            (void)fputs("'\\''", stdout);
        } else {
            (void)putchar(*word);
        }
    }
    (void)putchar('\'');
}

void picture_print_command(const char *data, const char *picture)
{
    (void)fputs("gnuplot -c", stdout);
    print_word(script);
    print_word(data);
    print_word(picture);
    (void)putchar('\n');
}
