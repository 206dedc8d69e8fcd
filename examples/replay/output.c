/* SPDX-License-Identifier: MIT */
#include "output.h"

#include "problem.h"

bool output_open(output_t *output, const char *name)
{
    output->name = name;
    (void)snprintf(output->temporary, sizeof output->temporary, "%.1000s.epf_replay.tmp", name);
    output->file = fopen(output->temporary, "wb");
    if (output->file == NULL) {
        problem("%s: cannot write %s", name, output->temporary);
    }
    return output->file != NULL;
}

static bool put_in_place(const output_t *output)
{
#ifdef _WIN32
    (void)remove(output->name); /* there, rename does not replace */
#endif
    return rename(output->temporary, output->name) == 0;
}

bool output_commit(output_t *output)
{
    const bool written = !ferror(output->file);
    const bool closed = fclose(output->file) == 0;
    if (written && closed && put_in_place(output)) {
        return true;
    }
    problem("%s: cannot write the file", output->name);
    (void)remove(output->temporary);
    return false;
}

void output_discard(output_t *output)
{
    (void)fclose(output->file);
    (void)remove(output->temporary);
}
