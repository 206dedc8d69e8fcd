/* SPDX-License-Identifier: MIT */
/* Text files line by line, and what is done to a piece of a line: trim it, read a number. */
#ifndef TEXT_H
#define TEXT_H

#include <stdbool.h>
#include <stdio.h>

enum { TEXT_LINE_MAX = 4095 };

typedef struct {
    FILE *file;
    const char *name;
    unsigned long number; /* of the line in hand; the first is 1 */
    char line[TEXT_LINE_MAX + 1];
} text_t;

typedef enum { TEXT_LINE, TEXT_END, TEXT_FAILED } text_status_t;

/* False, and the problem reported, if the file cannot be opened. The name must outlive the text. */
bool text_open(text_t *text, const char *name);

/* Puts the next line into text->line, without its end (LF or CRLF) and without a byte order mark.
   TEXT_FAILED, and the problem reported, if the line is too long or the file is not text. */
text_status_t text_next(text_t *text);

void text_close(text_t *text);

/* Reports a problem with the line in hand, as problem() does, with the name of the file and the number of
   the line before it. Returns false. */
bool text_problem(const text_t *text, const char *format, ...);

/* The same text without the white space around it; changes it in place */
char *text_trim(char *text);

bool text_is_blank(const char *text);

/* True if a shell takes the text for one word, and changes nothing in it */
bool text_is_plain(const char *text);

/* True if the whole text is one finite decimal number: no nan, no inf, no 0x10, no 1,5 */
bool text_number(const char *text, double *number);

#endif
