/* SPDX-License-Identifier: MIT */
#include "report.h"

void report_header(FILE *file, bool has_force)
{
    (void)fputs("time_s,displacement_m,z_m,force_N", file);
    (void)fputs(has_force ? ",measured_N,residual_N\n" : "\n", file);
}

/* 9 digits tell every float from its neighbours; + 0.0 turns -0 into 0 */
void report_row(FILE *file, const replay_sample_t *sample, bool has_force)
{
    (void)fprintf(file, "%.15g,%.9g,%.9g,%.9g", sample->time_s + 0.0, sample->displacement_m + 0.0,
                  sample->z_m + 0.0, sample->force_N + 0.0);
    if (has_force) {
        (void)fprintf(file, ",%.9g,%.9g", sample->measured_N + 0.0, sample->residual_N + 0.0);
    }
    (void)fputc('\n', file);
}

static void print_share(const char *name, double time, double duration)
{
    (void)printf("%-18s%.1f %% of the time\n", name, 100.0 * time / duration);
}

void report_summary(const replay_t *replay)
{
    const replay_summary_t *s = &replay->summary;
    (void)printf("rows              %lu\n", s->rows);
    (void)printf("duration          %.6g s\n", s->duration_s);
    (void)printf("reversals         %lu\n", s->reversals);
    print_share("elastic", s->time_in[REGIME_ELASTIC], s->duration_s);
    print_share("mixed", s->time_in[REGIME_MIXED], s->duration_s);
    print_share("sliding", s->time_in[REGIME_SLIDING], s->duration_s);
    (void)printf("largest |z|/z_max %.4f\n", s->largest_z);
    (void)printf("rejected samples  %lu\n", (unsigned long)s->rejected);
    if (replay->has_force) {
        const double rms = replay_rms_residual(s);
        (void)printf("rms residual      %.4g N (%.3g %% of f_c)\n", rms,
                     100.0 * rms / (double)replay->coeffs.f_c);
        (void)printf("mean residual     %.4g N\n", replay_mean_residual(s));
    }
}
