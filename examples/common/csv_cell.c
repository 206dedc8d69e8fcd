/* SPDX-License-Identifier: MIT */
#include "csv_cell.h"

#include "text.h"

#include <string.h>

/* Ends the quoted cell that begins at `quoted`, with "" for a quote in it. Returns what follows the
   closing quote; NULL if there is none. */
static char *unquote(char *quoted)
{
    char *to = quoted;
    for (const char *from = quoted + 1; *from != '\0'; from++) {
        if (*from == '"' && *++from != '"') {
            char *rest = quoted + (from - quoted);
            rest += strspn(rest, " \t\r");
            *to = '\0';
            return rest;
        }
        *to++ = *from;
    }
    return NULL;
}

const char *csv_next_cell(char **rest)
{
    char *cell = *rest + strspn(*rest, " \t");
    char *end = *cell == '"' ? unquote(cell) : cell + strcspn(cell, ",");
    if (end == NULL || (*end != ',' && *end != '\0')) {
        return NULL;
    }
    *rest = *end == ',' ? end + 1 : NULL;
    *end = '\0';
    return text_trim(cell);
}
