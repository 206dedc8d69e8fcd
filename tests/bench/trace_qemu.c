/* SPDX-License-Identifier: MIT */
/*
 * A plugin of QEMU that writes the address of every instruction executed, as 64-bit words, to the
 * file that its argument trace= names.
 *
 * Debian ships no qemu-plugin.h: what is used of its version 1 is declared here.
 */
#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint64_t qemu_plugin_id_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
typedef void on_translation_t(qemu_plugin_id_t id, struct qemu_plugin_tb *block);
typedef void on_execution_t(unsigned cpu, void *data);
typedef void on_exit_t(qemu_plugin_id_t id, void *data);

size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *block, size_t index);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *instruction);
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, on_translation_t *call);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *instruction,
                                            on_execution_t *call, int flags, void *data);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, on_exit_t *call, void *data);

extern int qemu_plugin_version;
int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int argc, char **argv);

int qemu_plugin_version = 1;
static FILE *trace;

static void executed(unsigned cpu, void *data)
{
    const uint64_t address = (uintptr_t)data;
    (void)cpu;
    if (fwrite(&address, sizeof address, 1, trace) != 1) {
        perror("trace");
        exit(EXIT_FAILURE);
    }
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *block)
{
    (void)id;
    for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); i++) {
        struct qemu_plugin_insn *instruction = qemu_plugin_tb_get_insn(block, i);
        const uintptr_t address = (uintptr_t)qemu_plugin_insn_vaddr(instruction);
        qemu_plugin_register_vcpu_insn_exec_cb(instruction, executed, 0, (void *)address);
    }
}

static void finished(qemu_plugin_id_t id, void *data)
{
    (void)id;
    (void)data;
    (void)fclose(trace);
}

int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int argc, char **argv)
{
    (void)info;
    if (argc != 1 || strncmp(argv[0], "trace=", 6) != 0) {
        (void)fputs("trace: no trace=FILE to write to\n", stderr);
        return -1;
    }
    trace = fopen(argv[0] + 6, "wb");
    if (trace == NULL) {
        perror("trace");
        return -1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    qemu_plugin_register_atexit_cb(id, finished, NULL);
    return 0;
}
