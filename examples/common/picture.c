/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include "system.h"
#include "text.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

bool picture_name(char *name, size_t size, const char *data)
{
    const char *const dot = strrchr(data, '.');
    const bool has_ending = dot != NULL && strpbrk(dot, "/\\") == NULL;
    const int stem = (int)(has_ending ? (size_t)(dot - data) : strlen(data));
    const int length = snprintf(name, size, "%.*s.png", stem, data);
    return length >= 0 && (size_t)length < size;
}

/* gnuplot runs a name that begins with < or | as a command, and ~, - and $ have meanings, too */
typedef struct {
    char text[SYSTEM_NAME_MAX + 3];
} gnuplot_name_t;

static gnuplot_name_t gnuplot_name(const char *name)
{
    gnuplot_name_t made;
    const bool is_plain = isalnum((unsigned char)*name) || strchr("_./", *name) != NULL;
    (void)snprintf(made.text, sizeof made.text, "%s%s", is_plain ? "" : "./", name);
    return made;
}

static bool draw(const char *script, const char *data, const char *picture)
{
    const gnuplot_name_t from = gnuplot_name(data);
    const gnuplot_name_t to = gnuplot_name(picture);
    return system_gnuplot(script, from.text, to.text);
}

/* Between apostrophes a POSIX shell takes everything as it is, except an apostrophe */
static void print_word(const char *word)
{
    if (text_is_plain(word)) {
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

static void print_command(const char *script, const char *data, const char *picture)
{
    const gnuplot_name_t from = gnuplot_name(data);
    const gnuplot_name_t to = gnuplot_name(picture);
    (void)fputs("gnuplot -c", stdout);
    print_word(script);
    print_word(from.text);
    print_word(to.text);
    (void)putchar('\n');
}

void picture_make(const char *script, const char *data, const char *picture)
{
    if (draw(script, data, picture)) {
        (void)printf("written           %s\n", picture);
    } else {
        (void)fputs("no picture; try:  ", stdout);
        print_command(script, data, picture);
    }
}
