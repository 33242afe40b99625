/*
 * A plugin of QEMU that counts instructions executed between two functions of the emulated program:
 *
 *   qemu-... -plugin libcount.so,begin=ADDRESS,end=ADDRESS,output=FILE
 *
 * Whenever the instruction at `end` is executed, a line with the number of instructions since the last
 * one at `begin` is written. Every instruction counts, wherever it lies: helper functions and trap
 * handlers too. Calls of both markers are counted along; take the same with a function that does
 * nothing off.
 *
 * Distributions ship no header of the plugin interface (QEMU 7.2: version 1); what is needed of it is
 * declared here.
 */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct qemu_plugin_tb;
struct qemu_plugin_insn;

typedef void (*on_translation)(uint64_t id, struct qemu_plugin_tb *block);
typedef void (*on_execution)(unsigned int processor, void *data);

enum { NO_REGISTERS = 0, ADD_U64 = 0 };

void qemu_plugin_register_vcpu_tb_trans_cb(uint64_t id, on_translation callback);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *block, size_t index);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *instruction);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *instruction, on_execution callback,
                                            int registers, void *data);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *instruction, int operation,
                                                void *counter, uint64_t addend);

int qemu_plugin_version = 1;
int qemu_plugin_install(uint64_t id, const void *machine, int count, char **arguments);

static uint64_t executed, at_begin, begin_address, end_address;
static FILE *output;

static void begin(unsigned int processor, void *data)
{
    (void)processor;
    (void)data;
    at_begin = executed;
}

static void end(unsigned int processor, void *data)
{
    (void)processor;
    (void)data;
    (void)fprintf(output, "%" PRIu64 "\n", executed - at_begin);
    (void)fflush(output); /* an emulator that is killed leaves what was counted */
}

static void translated(uint64_t id, struct qemu_plugin_tb *block)
{
    (void)id;
    for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); i++) {
        struct qemu_plugin_insn *const instruction = qemu_plugin_tb_get_insn(block, i);
        const uint64_t address = qemu_plugin_insn_vaddr(instruction);
        if (address == begin_address || address == end_address) {
            qemu_plugin_register_vcpu_insn_exec_cb(instruction, address == end_address ? end : begin,
                                                   NO_REGISTERS, NULL);
        }
        qemu_plugin_register_vcpu_insn_exec_inline(instruction, ADD_U64, &executed, 1);
    }
}

int qemu_plugin_install(uint64_t id, const void *machine, int count, char **arguments)
{
    (void)machine;
    for (int i = 0; i < count; i++) {
        const char *const equals = strchr(arguments[i], '=');
        const char *const value = equals == NULL ? "" : equals + 1;
        if (strncmp(arguments[i], "begin=", 6) == 0) {
            begin_address = strtoull(value, NULL, 0);
        } else if (strncmp(arguments[i], "end=", 4) == 0) {
            end_address = strtoull(value, NULL, 0);
        } else if (strncmp(arguments[i], "output=", 7) == 0) {
            output = fopen(value, "w");
        }
    }
    if (output == NULL || begin_address == 0 || end_address == 0) {
        (void)fputs("count_instructions: begin=, end= and output= are needed\n", stderr);
        return 1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    return 0;
}
