/* SPDX-License-Identifier: MIT */
/* A file of parameters, line by line. */
#include "parameters.h"
#include "problem.h"
#include "text.h"

#include <stdio.h>
#include <string.h>

static bool read_line(parameters_t *from_file, text_t *text)
{
    char place[1200];
    (void)snprintf(place, sizeof place, "%.1000s:%lu: ", text->name, text->number);

    text->line[strcspn(text->line, "#")] = '\0';
    char *const line = text_trim(text->line);
    if (*line == '\0') {
        return true;
    }
    char *const equals = strchr(line, '=');
    if (equals == NULL) {
        return problem("%sexpected name = value, " FOUND, place, line);
    }
    *equals = '\0';
    return parameters_set(from_file, place, text_trim(line), text_trim(equals + 1));
}

bool parameters_read(parameters_t *set, const char *file_name)
{
    text_t text;
    if (!text_open(&text, file_name)) {
        return false;
    }
    bool good = true;
    text_status_t status = TEXT_LINE;
    while (good && (status = text_next(&text)) == TEXT_LINE) {
        good = read_line(set, &text);
    }
    text_close(&text);
    return good && status == TEXT_END;
}
