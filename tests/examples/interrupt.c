/* SPDX-License-Identifier: MIT */
/*
 * Interrupts a program in the middle of its work:
 *
 *     interrupt SIGNAL default|ignored fed|alone FILE PROGRAM ARGUMENT...
 *
 * As soon as there is a FILE, which may be a pattern, the program gets the signal of that number, which it was
 * told to ignore or not. If it is to be fed, it reads record.csv, which is a FIFO: it gets two rows, then nothing,
 * and after the signal the end. Ends as a shell would: with the exit status of the program, or 128 + the signal
 * that ended it; with 99 if nothing was interrupted.
 */
#define _POSIX_C_SOURCE 200809L
#include <fcntl.h>
#include <glob.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static const char record[] = "record.csv";
static const char rows[] = "time_s,position_m\n0,0\n0.5,1\n";
enum { NOT_INTERRUPTED = 99 };

/* Whether the signal is ignored here, as in the background of a script, does not matter */
static pid_t start(char **command, int interrupt, bool ignored)
{
    const pid_t child = fork();
    if (child == 0) {
        (void)signal(interrupt, ignored ? SIG_IGN : SIG_DFL);
        (void)execv(command[0], command);
        _exit(NOT_INTERRUPTED);
    }
    return child;
}

static bool wait_for(const char *file)
{
    static const struct timespec pause = {.tv_nsec = 10000000}; /* for ten seconds */
    glob_t found;
    for (int i = 0; i < 1000; i++) {
        if (glob(file, 0, NULL, &found) == 0) {
            globfree(&found);
            return true;
        }
        (void)nanosleep(&pause, NULL);
    }
    return false;
}

/* The end of the FIFO that keeps the program waiting; -1 if that does not work */
static int feed_program(void)
{
    const int feed = open(record, O_WRONLY);
    return write(feed, rows, sizeof rows - 1) == (ssize_t)sizeof rows - 1 ? feed : -1;
}

int main(int argc, char **argv)
{
    int status;
    const bool is_fed = argc > 5 && strcmp(argv[3], "fed") == 0;
    if (argc < 6 || (is_fed && mkfifo(record, 0600) != 0)) {
        return NOT_INTERRUPTED;
    }
    const int interrupt = (int)strtol(argv[1], NULL, 10);
    const pid_t child = start(argv + 5, interrupt, strcmp(argv[2], "ignored") == 0);
    const int feed = is_fed ? feed_program() : -1;
    const bool ready = (!is_fed || feed >= 0) && wait_for(argv[4]);

    (void)kill(child, ready ? interrupt : SIGKILL);
    const bool ended_feed = !is_fed || (close(feed) == 0 && unlink(record) == 0);
    const bool ended = waitpid(child, &status, 0) == child;
    if (!ready || !ended_feed || !ended) {
        return NOT_INTERRUPTED;
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}
