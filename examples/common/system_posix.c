/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "system.h"

#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- which file ----------------------------------------------------------------------------- */

static bool is_same(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* What follows the last slash */
static char *base_name(char *name)
{
    char *const slash = strrchr(name, '/');
    return slash == NULL ? name : slash + 1;
}

/* The folder that the file is in, or is to be in */
static bool find_folder(char *name, struct stat *folder)
{
    char *const base = base_name(name);
    const char first = *base;
    *base = '\0';
    const bool found = stat(*name == '\0' ? "." : name, folder) == 0;
    *base = first;
    return found;
}

/* Of two files that are yet to be made */
static bool is_same_place(const char *one, const char *other)
{
    char a[SYSTEM_NAME_MAX + 1];
    char b[SYSTEM_NAME_MAX + 1];
    struct stat folder_a;
    struct stat folder_b;
    return system_follow(a, one) && system_follow(b, other) &&
           strcmp(base_name(a), base_name(b)) == 0 && find_folder(a, &folder_a) &&
           find_folder(b, &folder_b) && is_same(&folder_a, &folder_b);
}

bool system_same_file(const char *one, const char *other)
{
    struct stat a;
    struct stat b;
    const bool has_a = stat(one, &a) == 0;
    const bool has_b = stat(other, &b) == 0;
    if (has_a && has_b) {
        return is_same(&a, &b) && !S_ISCHR(a.st_mode);
    }
    return !has_a && !has_b && is_same_place(one, other);
}

bool system_follow(char *target, const char *name)
{
    enum { LINKS_MAX = 40 };
    char link[SYSTEM_NAME_MAX + 1];
    const size_t size = strlen(name) + 1;
    if (size > SYSTEM_NAME_MAX + 1) {
        return false;
    }
    memcpy(target, name, size);
    for (int i = 0; i < LINKS_MAX; i++) {
        const ssize_t length = readlink(target, link, sizeof link);
        if (length < 0) {
            return true; /* no link, or nothing there */
        }
        /* A link counts from the folder that it is in, unless it is absolute */
        char *const from = link[0] == '/' ? target : base_name(target);
        if ((size_t)(from - target) + (size_t)length > SYSTEM_NAME_MAX) {
            return false;
        }
        memcpy(from, link, (size_t)length);
        from[length] = '\0';
    }
    return false;
}

/* The descriptor of stdout or stderr if that is where the file goes, else -1 */
static int shared_descriptor(const struct stat *file)
{
    static const int descriptors[] = {STDOUT_FILENO, STDERR_FILENO};
    for (size_t i = 0; i < sizeof descriptors / sizeof descriptors[0]; i++) {
        struct stat open_file;
        if (fstat(descriptors[i], &open_file) == 0 && is_same(&open_file, file)) {
            return descriptors[i];
        }
    }
    return -1;
}

/* /dev/fd/3 may look like a link to a file that has no name any more */
static bool has_name(const struct stat *file, const char *name)
{
    char target[SYSTEM_NAME_MAX + 1];
    struct stat named;
    return system_follow(target, name) && stat(target, &named) == 0 && is_same(&named, file);
}

bool system_is_stream(const char *name)
{
    struct stat file;
    if (stat(name, &file) != 0) {
        return false; /* yet to be made */
    }
    return !S_ISREG(file.st_mode) || shared_descriptor(&file) >= 0 || !has_name(&file, name);
}

FILE *system_open_stream(const char *name)
{
    struct stat file;
    const int shared = stat(name, &file) == 0 ? shared_descriptor(&file) : -1;
    return shared >= 0 ? fdopen(dup(shared), "wb") : fopen(name, "wb");
}

/* ---- new files, and interrupts -------------------------------------------------------------- */

static const int interrupts[] = {SIGINT, SIGTERM, SIGHUP};
enum { INTERRUPTS = sizeof interrupts / sizeof interrupts[0] };

/* What an interrupt removes, while there is such a file */
static char unfinished[SYSTEM_NAME_MAX + 1];
static volatile sig_atomic_t is_unfinished;

/* What an interrupt ends first, so that it does not make that file again; 0: nothing */
static volatile pid_t drawing;

/* The signal's own action is in force again: raised once more, it ends the program when we return */
static void clean_up(int interrupt)
{
    if (drawing > 0) {
        (void)kill(drawing, SIGKILL);
        (void)waitpid(drawing, NULL, 0);
    }
    if (is_unfinished) {
        (void)unlink(unfinished);
    }
    (void)raise(interrupt);
}

/* What is ignored, as under nohup, stays ignored. `all` becomes the set of all three. */
static void catch_interrupts(sigset_t *all)
{
    (void)sigemptyset(all);
    for (int i = 0; i < INTERRUPTS; i++) {
        struct sigaction action;
        (void)sigaddset(all, interrupts[i]);
        if (sigaction(interrupts[i], NULL, &action) == 0 && action.sa_handler == SIG_DFL) {
            action.sa_handler = clean_up;
            action.sa_flags = (int)SA_RESETHAND;
            (void)sigaction(interrupts[i], &action, NULL);
        }
    }
}

FILE *system_create(char *temporary, const char *name)
{
    sigset_t all;
    sigset_t before;
    const int length = snprintf(temporary, SYSTEM_NAME_MAX + 1, "%s.%ld.tmp", name, (long)getpid());
    if (length < 0 || length > SYSTEM_NAME_MAX) {
        return NULL;
    }
    catch_interrupts(&all);
    (void)sigprocmask(SIG_BLOCK, &all, &before); /* not between the file and the note of it */
    const int descriptor = open(temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (descriptor >= 0) {
        memcpy(unfinished, temporary, (size_t)length + 1);
        is_unfinished = 1;
    }
    (void)sigprocmask(SIG_SETMASK, &before, NULL);
    return descriptor >= 0 ? fdopen(descriptor, "wb") : NULL;
}

void system_keep(void)
{
    is_unfinished = 0;
}

bool system_stderr_is_terminal(void)
{
    return isatty(STDERR_FILENO) == 1;
}

/* ---- gnuplot -------------------------------------------------------------------------------- */

enum { NO_SUCH_PROGRAM = 127 };

static void become_gnuplot(const char *script, const char *data, const char *picture)
{
    const int nowhere = open("/dev/null", O_WRONLY);
    (void)dup2(nowhere, STDOUT_FILENO);
    (void)dup2(nowhere, STDERR_FILENO);
    (void)execlp("gnuplot", "gnuplot", "-c", script, data, picture, (char *)NULL);
    _exit(NO_SUCH_PROGRAM);
}

/* No interrupt comes between the start of gnuplot and the note of it */
static pid_t start_gnuplot(const char *script, const char *data, const char *picture)
{
    sigset_t all;
    sigset_t before;
    (void)fflush(NULL); /* the child must not have what we have yet to print */
    catch_interrupts(&all);
    (void)sigprocmask(SIG_BLOCK, &all, &before);
    const pid_t child = fork();
    if (child != 0) {
        drawing = child;
    }
    (void)sigprocmask(SIG_SETMASK, &before, NULL);
    if (child == 0) {
        become_gnuplot(script, data, picture);
    }
    return child;
}

gnuplot_status_t system_gnuplot(const char *script, const char *data, const char *picture)
{
    int status = 0;
    const pid_t child = start_gnuplot(script, data, picture);
    const bool ended = child > 0 && waitpid(child, &status, 0) == child;
    drawing = 0;
    if (!ended || !WIFEXITED(status)) {
        return GNUPLOT_FAILED;
    }
    switch (WEXITSTATUS(status)) {
    case 0:
        return GNUPLOT_SUCCEEDED;
    case NO_SUCH_PROGRAM:
        return GNUPLOT_NOT_RUN;
    default:
        return GNUPLOT_FAILED;
    }
}
