/* SPDX-License-Identifier: MIT */
/*
 * libFuzzer drives parameters, weights and inputs of q31 and q15: whatever is accepted, every step keeps
 * every promise of fixed_properties.h. The bytes are aimed: parameters of all exponents and at the
 * corners of what is accepted, displacements that just reach or miss z_ba and z_ss, the ends of the types.
 *
 * Linked with tests/theorems/{fixed_properties,fixed_step,q31_variant,q15_variant}.c, src/coeffs.c and
 * src/params.c.
 */
#include "../theorems/fixed_properties.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

void fixed_check(const fixed_step_t *step, bool condition, const char *claim)
{
    if (!condition) {
        char text[FIXED_STEP_TEXT];
        fixed_step_describe(step, claim, text);
        (void)fprintf(stderr, "%s\n", text);
        abort();
    }
}

/* ---- numbers from bytes: 0 where they have run out ------------------------------------------- */

typedef struct {
    const uint8_t *data;
    size_t left;
} bytes_t;

static uint32_t byte(bytes_t *bytes)
{
    if (bytes->left == 0) {
        return 0;
    }
    bytes->left--;
    return *bytes->data++;
}

static uint32_t word(bytes_t *bytes)
{
    const uint32_t high = byte(bytes) << 8 | byte(bytes);
    return high << 16 | byte(bytes) << 8 | byte(bytes);
}

/* From 1 to below 2, often exactly 1 */
static float mantissa(bytes_t *bytes)
{
    const uint32_t bits = byte(bytes) << 8 | byte(bytes);
    return bits % 4 == 0 ? 1.0f : 1.0f + (float)bits / 65536.0f;
}

/* Every binary magnitude from 2^low to 2^high */
static float magnitude(bytes_t *bytes, int low, int high)
{
    const int exponent = low + (int)(byte(bytes) % (uint32_t)(high - low + 1));
    return ldexpf(mantissa(bytes), exponent);
}

static float or_nothing(bytes_t *bytes, float x)
{
    return byte(bytes) % 8 == 0 ? 0.0f : x;
}

/* A float of any bits, in one case of 64 */
static float or_any(bytes_t *bytes, float x)
{
    if (byte(bytes) % 64 == 63) {
        const uint32_t bits = word(bytes);
        memcpy(&x, &bits, sizeof x);
    }
    return x;
}

/* ---- a contact ------------------------------------------------------------------------------- */

/* A number next to x, or any share of it, below x */
static float share_of(bytes_t *bytes, float x)
{
    switch (byte(bytes) % 4) {
    case 0:
        return nextafterf(x, 0.0f);
    case 1:
        return x - x * magnitude(bytes, -23, -2);
    case 2:
        return x * magnitude(bytes, -30, -2);
    default:
        return x * ((float)byte(bytes) + 1.0f) / 257.0f;
    }
}

static float at_least(bytes_t *bytes, float x)
{
    switch (byte(bytes) % 4) {
    case 0:
        return x;
    case 1:
        return nextafterf(x, INFINITY);
    case 2:
        return x + x * magnitude(bytes, -23, -1);
    default:
        return x * magnitude(bytes, 0, 20);
    }
}

/* One count as z_ba has it, or as leads to a z_shift from 0 to 29 */
static float count_of(bytes_t *bytes, float z_max, float z_ba)
{
    return byte(bytes) % 8 == 0 ? z_ba : z_max / magnitude(bytes, 0, 29);
}

static void choose(bytes_t *bytes, epf_params_t *p, epf_lsb_t *lsb)
{
    p->sigma_0 = or_any(bytes, magnitude(bytes, -60, 60));
    p->f_c = or_any(bytes, magnitude(bytes, -60, 60));
    p->f_max = or_any(bytes, at_least(bytes, p->f_c));
    p->v_s = or_any(bytes, magnitude(bytes, -60, 60));
    p->z_ba = or_any(bytes, share_of(bytes, p->f_c / p->sigma_0));
    p->stribeck = (epf_stribeck_t)(byte(bytes) % 3);
    p->update = (epf_update_t)(byte(bytes) % 2);
    lsb->x = or_any(bytes, count_of(bytes, p->f_max / p->sigma_0, p->z_ba));
    lsb->v = or_any(bytes, p->v_s * magnitude(bytes, -33, 23));
    lsb->f = or_any(bytes, p->f_max / magnitude(bytes, 0, byte(bytes) % 2 ? 14 : 30));
    lsb->t = or_any(bytes, magnitude(bytes, -60, 60));
    const float viscous = p->sigma_0 * (lsb->x / lsb->v) * magnitude(bytes, -40, 23);
    p->sigma_2 = or_any(bytes, or_nothing(bytes, viscous));
    p->sigma_1 = or_any(bytes, or_nothing(bytes, p->sigma_0 * lsb->t * magnitude(bytes, -40, 23)));
}

/* ---- inputs ---------------------------------------------------------------------------------- */

static int32_t fitting(int64_t x, int32_t largest)
{
    return (int32_t)(x > largest ? largest : x < -(int64_t)largest - 1 ? -(int64_t)largest - 1 : x);
}

/* A state to aim at: z_ba, z_ss or z_max, on either side */
static int32_t target(bytes_t *bytes, const fixed_step_t *step, const any_contact_t *ep)
{
    const fixed_lengths_t *c = &step->lengths;
    const int32_t targets[] = {c->z_ba, step->variant->z_ss(ep), c->z_max, c->z_c, 0};
    const uint32_t pick = byte(bytes);
    return pick % 2 ? targets[pick / 2 % 5] : -targets[pick / 2 % 5];
}

static int64_t displacement(bytes_t *bytes, const fixed_step_t *step, const any_contact_t *ep)
{
    const fixed_lengths_t *c = &step->lengths;
    const uint32_t pick = byte(bytes);
    const int64_t sign = pick / 16 % 2 ? 1 : -1;
    switch (pick % 8) {
    case 0:
        return 0;
    case 1:
        return sign * (1 + byte(bytes) % 3);
    case 2:
        return sign * INT64_C(4294967296);
    case 3:
        return sign * ((int64_t)c->leap - byte(bytes) % 3);
    case 4:
        return (int32_t)word(bytes) >> (byte(bytes) % 32);
    case 5:
        return sign * (1 + (int64_t)(word(bytes) % (2 * c->leap)));
    default: {
        const int64_t way = (int64_t)target(bytes, step, ep) - step->variant->z(ep);
        return way / (int64_t)c->unit + byte(bytes) % 3 - 1;
    }
    }
}

static int64_t velocity(bytes_t *bytes)
{
    const uint32_t pick = byte(bytes);
    const int64_t sign = pick / 16 % 2 ? 1 : -1;
    switch (pick % 4) {
    case 0:
        return sign * (byte(bytes) % 3);
    case 1:
        return sign * INT64_C(4294967296);
    default:
        return (int32_t)word(bytes) >> (byte(bytes) % 32);
    }
}

static uint32_t duration(bytes_t *bytes, uint32_t largest)
{
    const uint32_t pick = byte(bytes);
    return pick % 4 == 0   ? pick / 4 % 3
           : pick % 4 == 1 ? largest
                           : word(bytes) >> (pick / 4 % 32) & largest;
}

/* Sometimes a state of one's own, next to where something happens; or a counter that is nearly full */
static void disturb(bytes_t *bytes, const fixed_step_t *step, any_contact_t *ep)
{
    const uint32_t pick = byte(bytes);
    if (pick % 8 == 0) {
        step->variant->reset(ep, (int32_t)word(bytes));
    } else if (pick % 8 == 1) {
        step->variant->reset(ep, target(bytes, step, ep) + (int32_t)(byte(bytes) % 5) - 2);
    } else if (pick == 2) {
        *step->variant->rejected(ep) = UINT16_MAX - 1;
    }
}

static void run(const fixed_variant_t *variant, bytes_t bytes, const epf_params_t *params,
                const epf_lsb_t *lsb)
{
    any_coeffs_t coeffs;
    if (variant->coeffs_init(&coeffs, params, lsb) != EPF_OK) {
        return;
    }
    fixed_step_t step = {.variant = variant,
                         .coeffs = &coeffs,
                         .lengths = variant->lengths(&coeffs),
                         .contact = "of the fuzzer",
                         .sequence = "of the fuzzer",
                         .params = params,
                         .lsb = lsb};
    any_contact_t ep;
    variant->init(&ep, &coeffs);
    for (; bytes.left > 0; step.index++) {
        disturb(&bytes, &step, &ep);
        step.v = fitting(velocity(&bytes), variant->signal_max);
        step.dt = duration(&bytes, variant->time_max);
        variant->set_velocity(&ep, step.v); /* the displacement is aimed at the z_ss of this step */
        step.dx = fitting(displacement(&bytes, &step, &ep), variant->signal_max);
        fixed_step_take(&step, &ep);
        fixed_check_all(&step);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    bytes_t bytes = {data, size};
    epf_params_t params;
    epf_lsb_t lsb;
    choose(&bytes, &params, &lsb);
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        run(fixed_variants[i], bytes, &params, &lsb);
    }
    return 0;
}
