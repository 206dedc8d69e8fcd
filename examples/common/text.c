/* SPDX-License-Identifier: MIT */
#include "text.h"

#include "problem.h"

#include <float.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const char white_space[] = " \t\r\v\f";
static const char byte_order_mark[] = "\xEF\xBB\xBF"; /* UTF-8; some spreadsheets begin with it */

bool text_open(text_t *text, const char *name)
{
    text->name = name;
    text->number = 0;
    text->file = fopen(name, "rb"); /* binary: line ends are our business on every system */
    return text->file != NULL || problem("%s: cannot open the file", name);
}

void text_close(text_t *text)
{
    (void)fclose(text->file);
}

bool text_problem(const text_t *text, const char *format, ...)
{
    char message[PROBLEM_LENGTH_MAX + 1];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    return problem("%s:%lu: %s", text->name, text->number, message);
}

static text_status_t failed(const text_t *text, const char *expected, const char *found)
{
    (void)text_problem(text, "expected %s, found %s", expected, found);
    return TEXT_FAILED;
}

/* Everything up to the next LF or the end of the file */
static text_status_t read_line(text_t *text, size_t *length)
{
    int c;
    *length = 0;
    while ((c = getc(text->file)) != EOF && c != '\n') {
        if (c == '\0') {
            return failed(text, "plain text (ASCII or UTF-8)", "a NUL byte");
        }
        if (*length == TEXT_LINE_MAX) {
            return failed(text, "a line of at most 4095 bytes", "a longer one");
        }
        text->line[(*length)++] = (char)c;
    }
    if (ferror(text->file)) {
        return failed(text, "a readable file", "a read error");
    }
    return c == EOF && *length == 0 ? TEXT_END : TEXT_LINE;
}

text_status_t text_next(text_t *text)
{
    size_t length;
    text->number++;
    const text_status_t status = read_line(text, &length);
    if (length > 0 && text->line[length - 1] == '\r') {
        length--;
    }
    text->line[length] = '\0';

    const size_t mark = sizeof byte_order_mark - 1;
    if (text->number == 1 && strncmp(text->line, byte_order_mark, mark) == 0) {
        memmove(text->line, text->line + mark, length - mark + 1);
    }
    return status;
}

char *text_trim(char *text)
{
    text += strspn(text, white_space);
    size_t length = strlen(text);
    while (length > 0 && strchr(white_space, text[length - 1]) != NULL) {
        length--;
    }
    text[length] = '\0';
    return text;
}

bool text_is_blank(const char *text)
{
    return text[strspn(text, white_space)] == '\0';
}

bool text_is_plain(const char *text)
{
    return text[strspn(text, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
                             "_./+-")] == '\0';
}

bool text_number(const char *text, double *number)
{
    char *end;
    *number = strtod(text, &end);
    const bool decimal = *text != '\0' && text[strspn(text, "0123456789+-.eE")] == '\0';
    const bool finite = *number >= -DBL_MAX && *number <= DBL_MAX;
    return decimal && finite && end != text && *end == '\0';
}
