/* SPDX-License-Identifier: MIT */
#include "output.h"

#include "problem.h"

#include <stdlib.h>

static bool spares(const char *written, const char *other)
{
    return written == NULL || other == NULL || !system_same_file(written, other) ||
           problem("command line: expected a file of its own for each purpose, found one twice: "
                   "\"%.200s\", \"%.200s\"",
                   written, other);
}

static bool spares_all(const char *written, const char *const others[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!spares(written, others[i])) {
            return false;
        }
    }
    return true;
}

bool output_check(const char *const outputs[], size_t n_outputs, const char *const inputs[],
                  size_t n_inputs)
{
    for (size_t i = 0; i < n_outputs; i++) {
        if (!spares_all(outputs[i], outputs, i) || !spares_all(outputs[i], inputs, n_inputs)) {
            return false;
        }
    }
    return true;
}

static bool cannot_write(const char *name)
{
    return problem("%.1000s: cannot write the file", name);
}

bool output_open(output_t *output, const char *name)
{
    output->name = name;
    output->is_stream = system_is_stream(name);
    if (output->is_stream) {
        output->file = system_open_stream(name);
    } else if (system_follow(output->target, name)) {
        output->file = system_create(output->temporary, output->target);
    } else {
        output->file = NULL;
    }
    return output->file != NULL || cannot_write(name);
}

static bool put_in_place(const output_t *output)
{
#ifdef _WIN32
    (void)remove(output->target); /* there, rename does not replace */
#endif
    return rename(output->temporary, output->target) == 0;
}

static void remove_temporary(const output_t *output)
{
    if (!output->is_stream) {
        (void)remove(output->temporary);
        system_keep();
    }
}

bool output_commit(output_t *output)
{
    const bool written = !ferror(output->file);
    const bool closed = fclose(output->file) == 0;
    if (written && closed && (output->is_stream || put_in_place(output))) {
        system_keep();
        return true;
    }
    remove_temporary(output);
    return cannot_write(output->name);
}

void output_discard(output_t *output)
{
    (void)fclose(output->file);
    remove_temporary(output);
}

int output_finish(int status)
{
    if (status != EXIT_SUCCESS) {
        return status;
    }
    const bool printed = !ferror(stdout);
    if (fclose(stdout) == 0 && printed) {
        return EXIT_SUCCESS;
    }
    (void)problem("stdout: cannot write everything");
    return EXIT_DATA;
}
