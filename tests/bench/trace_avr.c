/* SPDX-License-Identifier: MIT */
/*
 * trace_avr TRACE MCU PROGRAM: runs a program on simavr and writes every instruction executed to a
 * file, as 64-bit words: its address, 2^32 times the stack pointer before it, 2^48 times its cycles.
 * The exit status is that of main.
 */
#include <inttypes.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_CYCLES 1000000000u

static avr_t *load(const char *mcu, const char *file)
{
    elf_firmware_t firmware;
    memset(&firmware, 0, sizeof firmware);
    if (elf_read_firmware(file, &firmware) != 0) {
        return NULL;
    }
    avr_t *avr = avr_make_mcu_by_name(mcu);
    if (avr != NULL && avr_init(avr) == 0) {
        avr->log = LOG_ERROR;
        avr_load_firmware(avr, &firmware);
        return avr;
    }
    return NULL;
}

static uint64_t stack_pointer(const avr_t *avr)
{
    return avr->data[R_SPL] + 256u * avr->data[R_SPH];
}

/* avr-libc ends in a loop of one instruction, with the interrupts off; the status is in r24 */
static int has_ended(const avr_t *avr)
{
    return avr->flash[avr->pc] == 0xFF && avr->flash[avr->pc + 1] == 0xCF && !avr->sreg[S_I];
}

static int run(avr_t *avr, FILE *trace)
{
    while (!has_ended(avr)) {
        const uint64_t at = avr->pc + (stack_pointer(avr) << 32);
        const avr_cycle_count_t before = avr->cycle;
        const int state = avr_run(avr);
        const uint64_t word = at + ((avr->cycle - before) << 48);
        if (fwrite(&word, sizeof word, 1, trace) != 1) {
            perror("trace_avr");
            return EXIT_FAILURE;
        }
        if (state == cpu_Crashed || avr->cycle > MOST_CYCLES) {
            (void)fputs("trace_avr: the program crashed or does not end\n", stderr);
            return EXIT_FAILURE;
        }
    }
    return avr->data[24];
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        (void)fputs("usage: trace_avr TRACE MCU PROGRAM\n", stderr);
        return EXIT_FAILURE;
    }
    avr_t *avr = load(argv[2], argv[3]);
    FILE *trace = fopen(argv[1], "wb");
    if (avr == NULL || trace == NULL) {
        (void)fprintf(stderr, "trace_avr: cannot run %s on %s\n", argv[3], argv[2]);
        return EXIT_FAILURE;
    }
    const int status = run(avr, trace);
    return fclose(trace) == 0 ? status : EXIT_FAILURE;
}
