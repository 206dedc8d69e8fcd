/* SPDX-License-Identifier: MIT */
/* What the user is told when something is wrong: one line on stderr, and the exit status. */
#ifndef PROBLEM_H
#define PROBLEM_H

/* Exit status: a file is at fault, or the command line is (its parameters included) */
enum { EXIT_DATA = 1, EXIT_USAGE = 2 };

/* How text that was found is quoted: at most so much of it. To be used as "expected ..., " FOUND */
#define FOUND "found \"%.40s\""

/* The program's name, with which every message begins. To be called first of all by main. */
void problem_from(const char *name);

/* Prints the name and the message, as for printf, as exactly one line */
void problem(const char *format, ...);

#endif
