/* SPDX-License-Identifier: MIT */
/* What the user is told when something is wrong: one line on stderr, and the exit status. */
#ifndef PROBLEM_H
#define PROBLEM_H

#include <stdbool.h>

/* Exit status: a file is at fault, or the command line is (its parameters included) */
enum { EXIT_DATA = 1, EXIT_USAGE = 2 };

enum { PROBLEM_LENGTH_MAX = 4095 };

/* How text that was found is quoted: at most so much of it. To be used as "expected ..., " FOUND */
#define FOUND "found \"%.40s\""

/* The name of the program, with which every message begins: main gives it first of all */
void problem_from(const char *name);

/* Prints the name and the message, as for printf, as exactly one line. Returns false, which is what a
   check that has failed returns, too. */
bool problem(const char *format, ...);

#endif
