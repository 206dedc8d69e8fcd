/* SPDX-License-Identifier: MIT */
/**
 * @file epf.h
 * epf: friction estimation for microcontrollers. This page is the map; each header is a manual.
 *
 * Something moves against friction: a slide, a joint, a force-feedback wheel, a haptic handle. The
 * firmware knows its position to a fraction of a micrometre and does not know the friction force.
 * The estimator makes the force from displacement and velocity. It follows the elasto-plastic model
 * of Hayward, Armstrong, Altpeter and Dupont (2009): a contact that first deflects like a spring,
 * then yields, then slides, and that loses no position however long it is shaken while it sticks.
 *
 *     parameters --- coeffs_init, or a macro at compile time ---> coefficients (constant, in flash)
 *                                                                      |
 *     velocity v ------ set_velocity: z_ss(v), eq. (9) ----------.     |
 *                                                                 v    v
 *     displacement dx --- advance: eqs. (12), (13) ----------> state z_k --- force: eq. (14) ---> f
 *                                                                                                 |
 *                                                         output: one load, any context <---------'
 *
 * Which call goes where:
 *
 *     start-up               coeffs_init (or EPF_F32_COEFFS, ...), init
 *     encoder interrupt      advance, force                     no division in advance
 *     velocity loop          set_velocity                       may be preempted by the above
 *     anywhere               output                             one word, never torn on a 32-bit core
 *     a single control loop  step                               all of it in one call
 *
 * Three variants, the same calls and the same contexts:
 *
 *     epf_f32_...   single precision, SI units: for cores with an FPU
 *     epf_q31_...   32-bit integers in units of yours: encoder counts in, actuator units out
 *     epf_q15_...   16-bit integers, no 64-bit arithmetic: for Cortex-M0 and AVR
 *
 * Theorems of the paper, checked by the tests on generated sequences of displacements. In q31 and q15
 * they hold in exact integer arithmetic and are proven on the source (tests/proof); in f32 they hold up
 * to the rounding of z, and displacements far below it may stop short of z_ss:
 *
 *     Theorem 1  |z_k| <= z_max, for every sequence of inputs
 *     Theorem 2  in steady motion z_k converges to z_ss(v)
 *     Theorem 3  plastic displacement dissipates: f dw > 0 wherever dw = dx - dz is not 0
 *     Theorem 4  the estimator is passive: f dx > W_k - W_{k-1} with W = sigma_0 z^2/2
 *
 *     params.h    the model: parameters, their conditions, eq. (22)
 *     f32.h       the estimator in single precision
 *     q31.h       the estimator on 32-bit integers
 *     q15.h       the estimator on 16-bit integers
 *     fixed.h     the manual of both, and their numbers
 *     version.h   EPF_VERSION_MAJOR, _MINOR, _PATCH
 */
#ifndef EPF_EPF_H
#define EPF_EPF_H

#include "epf/f32.h"
#include "epf/params.h"
#include "epf/q15.h"
#include "epf/q31.h"
#include "epf/version.h"

#endif
