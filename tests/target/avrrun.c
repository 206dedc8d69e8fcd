/* SPDX-License-Identifier: MIT */
/*
 * avrrun MCU FIRMWARE.elf: runs a program for an AVR, built on libsimavr.
 *
 * The first UART goes to standard output. When main returns, its status is that of avrrun. What no
 * exit status of a test is: 124 after too many cycles, 139 when the processor runs away, 140 when
 * the stack runs into the data; 2 for a bad command line.
 */
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { STATUS_USAGE = 2, STATUS_CYCLES = 124, STATUS_CRASH = 139, STATUS_STACK = 140 };

#define CYCLES_AT_MOST 4000000000u /* 250 s at 16 MHz */
#define RJMP_TO_ITSELF 0xcfffu
#define CLI            0x94f8u

static int stop(const char *why, int status)
{
    (void)fflush(stdout);
    (void)fprintf(stderr, "avrrun: %s\n", why);
    return status;
}

/* What simavr says about itself */
static void say_nothing(avr_t *avr, const int level, const char *format, va_list args)
{
    (void)avr;
    (void)level;
    (void)format;
    (void)args;
}

/* simavr takes any file for a firmware, and falls over some */
static bool is_firmware(const char *path)
{
    enum { MACHINE = 18, AVR = 83, HEADER = 20 };
    unsigned char header[HEADER] = {0};
    FILE *file = fopen(path, "rb");
    if (file != NULL) {
        (void)fread(header, 1, sizeof header, file);
        (void)fclose(file);
    }
    return memcmp(header, "\177ELF", 4) == 0 && header[MACHINE] == AVR;
}

static void show(struct avr_irq_t *irq, uint32_t value, void *param)
{
    (void)irq;
    (void)param;
    (void)putchar((int)(value & 0xffu));
}

/* Ours instead of what simavr does with it: it would colour each line, and sleep while it is polled */
static void connect_uart(avr_t *avr)
{
    uint32_t flags = 0;
    avr_ioctl(avr, AVR_IOCTL_UART_GET_FLAGS('0'), &flags);
    flags &= ~(uint32_t)(AVR_UART_FLAG_STDIO | AVR_UART_FLAG_POLL_SLEEP);
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), show,
                            NULL);
}

static unsigned instruction(const avr_t *avr, avr_flashaddr_t address)
{
    return avr->flash[address] | (unsigned)avr->flash[address + 1] << 8;
}

/* avr-libc ends in `cli; rjmp .`, with the status of main where main returned it */
static bool has_ended(const avr_t *avr)
{
    return instruction(avr, avr->pc) == RJMP_TO_ITSELF && instruction(avr, avr->pc - 2) == CLI;
}

static unsigned stack_pointer(const avr_t *avr)
{
    return avr->data[R_SPL] | (unsigned)avr->data[R_SPH] << 8;
}

static int run(avr_t *avr, unsigned end_of_data)
{
    int low = 0; /* instructions for which the stack has been in the data */
    while (avr->cycle < CYCLES_AT_MOST) {
        if (has_ended(avr)) {
            (void)fflush(stdout);
            return avr->data[24];
        }
        const int state = avr_run(avr);
        if (state == cpu_Crashed || state == cpu_Done) {
            return stop("the processor ran away", STATUS_CRASH);
        }
        /* SPH and SPL are written one after the other: between the two it may look low */
        low = stack_pointer(avr) < end_of_data ? low + 1 : 0;
        if (low > 4) {
            return stop("the stack ran into the data", STATUS_STACK);
        }
    }
    return stop("too many cycles", STATUS_CYCLES);
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        return stop("expected MCU FIRMWARE.elf", STATUS_USAGE);
    }
    (void)setvbuf(stdout, NULL, _IOLBF, 0); /* what was said before a time-out is to be seen */
    avr_global_logger_set(say_nothing);
    elf_firmware_t firmware;
    memset(&firmware, 0, sizeof firmware);
    if (!is_firmware(argv[2]) || elf_read_firmware(argv[2], &firmware) != 0) {
        return stop("the firmware is no program for an AVR", STATUS_USAGE);
    }
    avr_t *avr = avr_make_mcu_by_name(argv[1]);
    if (avr == NULL) {
        return stop("unknown MCU", STATUS_USAGE);
    }
    avr_init(avr);
    avr->frequency = 16000000;
    avr_load_firmware(avr, &firmware);
    connect_uart(avr);
    return run(avr, avr->ioend + 1u + firmware.datasize + firmware.bsssize);
}
