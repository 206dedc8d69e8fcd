/* SPDX-License-Identifier: MIT */
#include "command_line.h"

#include "problem.h"

#include <stdio.h>
#include <string.h>

/* ---- help ----------------------------------------------------------------------------------- */

enum { HELP_COLUMN = 24 }; /* where the second column begins */

static void print_option(const option_t *option)
{
    int column = printf("  %s", option->name);
    if (option->takes != NULL) {
        column += printf(" %s", option->takes);
    }
    for (const char *text = option->help; text != NULL;) {
        const size_t length = strcspn(text, "\n");
        (void)printf("%*s%.*s\n", HELP_COLUMN - column, "", (int)length, text);
        text = text[length] == '\n' ? text + length + 1 : NULL;
        column = 0;
    }
}

static void print_help(const command_line_t *line)
{
    static const option_t help = {"--help", NULL, "print this"};
    (void)puts(line->usage);
    for (size_t g = 0; g < line->count; g++) {
        const option_group_t *group = &line->groups[g];
        (void)printf("\n%s\n", group->title);
        for (size_t i = 0; i < group->count; i++) {
            print_option(&group->options[i]);
        }
    }
    (void)putchar('\n');
    print_option(&help);
}

/* ---- options -------------------------------------------------------------------------------- */

typedef struct {
    const option_t *option; /* NULL: there is none */
    const char **value;
} place_t;

static bool is_named(const char *text)
{
    return *text == '-';
}

/* The option that an argument stands for. Arguments without a name go to the options without one, in
   their order. */
static place_t find(const command_line_t *line, const char *argument)
{
    place_t found = {NULL, NULL};
    for (size_t g = 0; g < line->count; g++) {
        const option_group_t *group = &line->groups[g];
        for (size_t i = 0; i < group->count; i++) {
            const char *name = group->options[i].name;
            const bool matches = is_named(argument) ? strcmp(argument, name) == 0 : !is_named(name);
            if (matches && (found.option == NULL || *found.value != NULL)) {
                found = (place_t){&group->options[i], &group->values[i]};
            }
        }
    }
    return found;
}

static bool set(const place_t *place, const char *value)
{
    const char *name = place->option->name;
    if (*place->value != NULL) {
        problem("command line: %s: expected once, found \"%.40s\" and \"%.40s\"", name,
                *place->value, value);
        return false;
    }
    if (*value == '\0' || strlen(value) > OPTION_LENGTH_MAX) {
        problem("command line: %s: expected 1 to %d characters, found %lu", name, OPTION_LENGTH_MAX,
                (unsigned long)strlen(value));
        return false;
    }
    *place->value = value;
    return true;
}

/* Takes the arguments of one option off the command line, which ends with NULL */
static bool take(const command_line_t *line, char ***arguments)
{
    const char *argument = *(*arguments)++;
    const place_t place = find(line, argument);
    if (place.option == NULL) {
        problem("command line: expected an option (see --help), " FOUND, argument);
        return false;
    }
    if (!is_named(argument) || place.option->takes == NULL) {
        return set(&place, argument);
    }
    const char *value = **arguments;
    if (value == NULL) {
        problem("command line: %s: expected a value after it, found none", argument);
        return false;
    }
    ++*arguments;
    return set(&place, value);
}

static void clear(const command_line_t *line)
{
    for (size_t g = 0; g < line->count; g++) {
        for (size_t i = 0; i < line->groups[g].count; i++) {
            line->groups[g].values[i] = NULL;
        }
    }
}

command_line_status_t command_line_read(const command_line_t *line, int argc, char **argv)
{
    clear(line);
    char **arguments = argv + (argc > 0);
    while (*arguments != NULL) {
        if (strcmp(*arguments, "--help") == 0) {
            print_help(line);
            return COMMAND_LINE_HELPED;
        }
        if (!take(line, &arguments)) {
            return COMMAND_LINE_FAILED;
        }
    }
    return COMMAND_LINE_READ;
}
