/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include "output.h"
#include "problem.h"
#include "text.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* The name of the data with .png in place of its ending; returns the length that it has, or would have */
static int name_beside(char name[SYSTEM_NAME_MAX + 1], const char *data)
{
    const char *const dot = strrchr(data, '.');
    const bool has_ending = dot != NULL && strpbrk(dot, "/\\") == NULL;
    const int stem = (int)(has_ending ? (size_t)(dot - data) : strlen(data));
    return snprintf(name, SYSTEM_NAME_MAX + 1, "%.*s.png", stem, data);
}

bool picture_choose(picture_t *picture, const char *script, const char *data, const char *name)
{
    *picture = (picture_t){script, data, ""};
    if (system_is_stream(data)) {
        return name == NULL || problem("command line: --picture: expected a result that can be "
                                       "read again, " FOUND,
                                       data);
    }
    const int length = name != NULL ? snprintf(picture->name, sizeof picture->name, "%s", name)
                                    : name_beside(picture->name, data);
    if (length < 0 || length > SYSTEM_NAME_MAX) {
        return problem("command line: expected a shorter name, " FOUND, data);
    }
    return !system_is_stream(picture->name) ||
           problem("command line: expected an ordinary file for the picture, found \"%.200s\"",
                   picture->name);
}

const char *picture_name(const picture_t *picture)
{
    return *picture->name != '\0' ? picture->name : NULL;
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

static gnuplot_status_t draw(const picture_t *picture, const char *to)
{
    const gnuplot_name_t from = gnuplot_name(picture->data);
    const gnuplot_name_t into = gnuplot_name(to);
    return system_gnuplot(picture->script, from.text, into.text);
}

/* gnuplot does not notice a full disk. A whole PNG file ends with an empty chunk of this name. */
static bool is_whole(const char *name)
{
    static const char end[] = "\0\0\0\0IEND\xAE\x42\x60\x82";
    enum { LENGTH = sizeof end - 1 };
    char found[LENGTH];
    FILE *const file = fopen(name, "rb");
    if (file == NULL) {
        return false;
    }
    const bool whole = fseek(file, -(long)LENGTH, SEEK_END) == 0 &&
                       fread(found, 1, LENGTH, file) == LENGTH && memcmp(found, end, LENGTH) == 0;
    (void)fclose(file);
    return whole;
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

/* The command to draw it by hand */
static void offer(const picture_t *picture)
{
    const gnuplot_name_t from = gnuplot_name(picture->data);
    const gnuplot_name_t to = gnuplot_name(picture->name);
    (void)fputs("no picture; try:  gnuplot -c", stdout);
    print_word(picture->script);
    print_word(from.text);
    print_word(to.text);
    (void)putchar('\n');
}

/* The output stays open while gnuplot writes to its temporary file, and only puts that in its place */
bool picture_make(const picture_t *picture)
{
    output_t output;
    if (picture_name(picture) == NULL) {
        return true;
    }
    if (!output_open(&output, picture->name)) {
        return false;
    }
    const gnuplot_status_t status = draw(picture, output.temporary);
    if (status != GNUPLOT_SUCCEEDED || !is_whole(output.temporary)) {
        output_discard(&output);
        offer(picture);
        return status == GNUPLOT_NOT_RUN ||
               problem("%.1000s: gnuplot failed to draw the picture", picture->name);
    }
    if (!output_commit(&output)) {
        return false;
    }
    (void)printf("written           %s\n", picture->name);
    return true;
}
