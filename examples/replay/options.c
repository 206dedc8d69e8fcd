/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "problem.h"
#include "system.h"

#include <stdio.h>
#include <string.h>

const char options_script[] = EPF_REPLAY_DIR "/plot.gp";

static const char help[] =
    "usage: epf_replay [RECORD.csv] [options]\n"
    "\n"
    "Runs the friction estimator over a recorded motion. Without RECORD.csv, over an example.\n"
    "\n"
    "RECORD.csv has a header row with the columns time_s and position_m, and if you like\n"
    "velocity_m_s and a measured force, friction_force_N or force_N. Others are ignored.\n"
    "\n"
    "  --sigma_0 VALUE    stiffness of the contact, N/m\n"
    "  --sigma_1 VALUE    damping of the contact, N s/m      (0)\n"
    "  --sigma_2 VALUE    viscous friction, N s/m            (0)\n"
    "  --f_c VALUE        Coulomb friction, N\n"
    "  --f_max VALUE      largest static friction, N         (f_c)\n"
    "  --v_s VALUE        Stribeck velocity, m/s             (1e-3)\n"
    "  --z_ba VALUE       break-away deflection, m\n"
    "  --stribeck FORM    lorentzian, gaussian or coulomb    (lorentzian)\n"
    "  --params FILE      the same from a file: lines name = value, # begins a comment;\n"
    "                     the command line wins\n"
    "\n"
    "  --variant NAME     f32, q31 or q15: floats, or integers of 32 or 16 bits   (f32)\n"
    "  --lsb_x VALUE      with q31 and q15: what 1 in each integer signal weighs, of\n"
    "                     the displacement, m                (z_max/1e6, z_max/16000)\n"
    "  --lsb_v VALUE      of the velocity, m/s               (v_s/1e5, v_s/100)\n"
    "  --lsb_f VALUE      of the force, N                    (f_max/1e6, f_max/16000)\n"
    "  --lsb_t VALUE      of the time, s                     (1e-6, 1e-5)\n"
    "\n"
    "  --force-column NAME   column of the measured force\n"
    "  --out FILE            where the result goes           (replay.csv)\n"
    "  --picture FILE        where its picture goes          (the same, .png)\n"
    "  --no-picture          make none\n"
    "  --help                print this\n";

void options_print_help(void)
{
    (void)fputs(help, stdout);
}

/* Where the value of an option that takes text goes; NULL if there is no such option */
static const char **text_option(options_t *options, const char *name)
{
    const struct {
        const char *name;
        const char **value;
    } table[] = {
        {"--params", &options->params_file},
        {"--force-column", &options->force_column},
        {"--out", &options->out},
        {"--picture", &options->picture},
        {"--variant", &options->variant_name},
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        if (strcmp(name, table[i].name) == 0) {
            return table[i].value;
        }
    }
    return NULL;
}

static bool set_text(const char **target, const char *name, const char *value)
{
    if (*target != NULL) {
        problem("command line: %s: expected once, found \"%.40s\" and \"%.40s\"", name, *target,
                value);
        return false;
    }
    if (*value == '\0' || strlen(value) > OPTIONS_NAME_MAX) {
        problem("command line: %s: expected 1 to %d characters, found %lu", name, OPTIONS_NAME_MAX,
                (unsigned long)strlen(value));
        return false;
    }
    *target = value;
    return true;
}

/* An option that stands alone */
static bool read_switch(options_t *options, const char *name)
{
    options->help = options->help || strcmp(name, "--help") == 0;
    options->no_picture = options->no_picture || strcmp(name, "--no-picture") == 0;
    return strcmp(name, "--help") == 0 || strcmp(name, "--no-picture") == 0;
}

/* An option and its value, NULL if the command line ends before it */
static bool read_option(options_t *options, const char *name, const char *value)
{
    const char **text = text_option(options, name);
    const bool is_parameter = strncmp(name, "--", 2) == 0 && parameters_known(name + 2);
    if (text == NULL && !is_parameter) {
        problem("command line: expected an option (see --help), " FOUND, name);
        return false;
    }
    if (value == NULL) {
        problem("command line: %s: expected a value after it, found none", name);
        return false;
    }
    return text != NULL ? set_text(text, name, value)
                        : parameters_set(&options->parameters, "command line", name + 2, value);
}

static bool read_arguments(options_t *options, int argc, char **argv)
{
    bool good = true;
    for (int i = 1; good && i < argc; i++) {
        if (argv[i][0] != '-') {
            good = set_text(&options->record, "RECORD.csv", argv[i]);
        } else if (!read_switch(options, argv[i])) {
            good = read_option(options, argv[i], argv[i + 1]); /* argv[argc] is NULL */
            i++;
        }
    }
    return good;
}

/* The name of the result, with .png in place of its ending */
static const char *picture_by_default(options_t *options)
{
    const char *const dot = strrchr(options->out, '.');
    const bool has_ending = dot != NULL && strpbrk(dot, "/\\") == NULL;
    const size_t stem = has_ending ? (size_t)(dot - options->out) : strlen(options->out);
    (void)snprintf(options->picture_by_default, sizeof options->picture_by_default, "%.*s.png",
                   (int)stem, options->out);
    return options->picture_by_default;
}

static void fill_in_defaults(options_t *options)
{
    options->example = options->record == NULL;
    if (options->example) {
        options->record = EPF_REPLAY_DIR "/example.csv";
        if (options->params_file == NULL) {
            options->params_file = EPF_REPLAY_DIR "/example.params";
        }
    }
    if (options->variant_name == NULL) {
        options->variant_name = "f32";
    }
    if (options->out == NULL) {
        options->out = "replay.csv";
    }
    if (options->picture == NULL && !options->no_picture && !system_is_stream(options->out)) {
        options->picture = picture_by_default(options);
    }
}

/* Looks the variant up by its name. Floats weigh what they say: whoever gives them a weight errs. A
   parameter file may hold some all the same, for the other variants. */
static bool choose_variant(options_t *options)
{
    options->variant = variant_find(options->variant_name);
    if (options->variant == NULL) {
        problem("command line: --variant: expected f32, q31 or q15, " FOUND, options->variant_name);
        return false;
    }
    if (options->variant->format == NULL && parameters_have_lsb(&options->parameters)) {
        problem("command line: --lsb_x, --lsb_v, --lsb_f, --lsb_t: expected with --variant q31 or "
                "q15, found with %s",
                options->variant->name);
        return false;
    }
    return true;
}

/* No file may be written over another that is in use */
static bool different(const char *written, const char *other)
{
    if (written == NULL || other == NULL || !system_same_file(written, other)) {
        return true;
    }
    problem("command line: expected a file of its own for each purpose, found one twice: "
            "\"%.200s\", \"%.200s\"",
            written, other);
    return false;
}

/* From every file that is read, and from one another */
static bool outputs_are_different(const options_t *options)
{
    const char *const script = options->picture == NULL ? NULL : options_script;
    const char *const inputs[] = {options->record, options->params_file, script};
    bool good = different(options->out, options->picture);
    for (size_t i = 0; good && i < sizeof inputs / sizeof inputs[0]; i++) {
        good = different(options->out, inputs[i]) && different(options->picture, inputs[i]);
    }
    return good;
}

static bool check_picture(const options_t *options)
{
    if (options->picture == NULL) {
        return true;
    }
    if (options->no_picture) {
        problem("command line: expected --picture or --no-picture, found both");
        return false;
    }
    if (system_is_stream(options->out)) {
        problem("command line: --picture: expected a result that can be read again, " FOUND,
                options->out);
        return false;
    }
    return true;
}

bool options_read(options_t *options, int argc, char **argv)
{
    *options = (options_t){.record = NULL};
    if (!read_arguments(options, argc, argv)) {
        return false;
    }
    fill_in_defaults(options);
    return check_picture(options) && choose_variant(options) && outputs_are_different(options);
}
