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

/* What the integers of the run weigh */
static void print_weights(const char *variant, const estimator_fixed_t *fixed)
{
    (void)printf("variant           %s\n", variant);
    (void)printf("lsb_x             %.6g m\n", (double)fixed->lsb.x);
    (void)printf("lsb_v             %.6g m/s\n", (double)fixed->lsb.v);
    (void)printf("lsb_f             %.6g N\n", (double)fixed->lsb.f);
    (void)printf("lsb_t             %.6g s\n", (double)fixed->lsb.t);
    (void)printf("z_shift           %d\n", fixed->z_shift);
}

static void print_force(const char *name, double force, double f_c)
{
    (void)printf("%-18s%.4g N (%.3g %% of f_c)\n", name, force, 100.0 * force / f_c);
}

static void print_figures(const replay_t *replay)
{
    const replay_summary_t *s = &replay->summary;
    (void)printf("rows              %lu\n", s->rows);
    (void)printf("duration          %.6g s\n", s->duration_s);
    (void)printf("reversals         %lu\n", s->reversals);
    print_share("elastic", s->time_in[REGIME_ELASTIC], s->duration_s);
    print_share("mixed", s->time_in[REGIME_MIXED], s->duration_s);
    print_share("sliding", s->time_in[REGIME_SLIDING], s->duration_s);
    (void)printf("largest |z|/z_max %.4f\n", s->largest_z);
    (void)printf("rejected samples  %lu\n", s->rejected);
    if (replay->has_force) {
        print_force("rms residual", replay_rms_residual(s), (double)replay_model(replay)->f_c);
        (void)printf("mean residual     %.4g N\n", replay_mean_residual(s));
    }
}

/* How the run differs from that of f32 */
static void print_comparison(const replay_t *replay)
{
    const comparison_t *c = &replay->comparison;
    const epf_f32_coeffs_t *model = replay_model(replay);
    const double f_c = (double)model->f_c;
    (void)printf("clipped signals   %lu\n", replay->estimator.as.fixed.clipped);
    (void)printf("z off f32, most   %.3g z_max\n", c->largest_z_m / (double)model->z_max);
    print_force("f off f32, most", c->largest_force_N, f_c);
    print_force("f off f32, rms", comparison_rms_force(c), f_c);
    if (!replay->has_force) {
        return;
    }
    const double rms = comparison_rms_residual(c);
    print_force("rms residual, f32", rms, f_c);
    if (rms > 0.0) {
        (void)printf("residual off f32  %+.2g %%\n",
                     100.0 * (replay_rms_residual(&replay->summary) / rms - 1.0));
    }
}

void report_summary(const replay_t *replay)
{
    const variant_t *variant = replay->estimator.variant;
    const bool has_weights = variant->format != NULL;
    if (has_weights) {
        print_weights(variant->name, &replay->estimator.as.fixed);
    }
    print_figures(replay);
    if (has_weights) {
        print_comparison(replay);
    }
}
