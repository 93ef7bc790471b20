/* Instructions and cycles of one call of a function on a Cortex-M4F, from an execution trace of QEMU.
 *
 *     qemu-system-arm -singlestep -d nochain,exec ... 2>&1 >/dev/null | cycles [--range] FUNCTION LISTING [LEFT_OUT...]
 *
 * LISTING is what `objdump -d` prints of the program. Of the calls of FUNCTION in the trace the last that returns counts, with
 * all that it calls, and with interrupts in it, but for the functions LEFT_OUT; one that the listing does not have is none.
 * With --range before FUNCTION it prints the least and the most instructions of all calls that return.
 * Cycles by Arm (2020), Cortex-M4 Technical Reference Manual r0p1 (100166), tables 3-1 and 7-1, with memory
 * without wait states:
 *
 * - floating point: add, subtract, multiply, compare, convert, move 1; multiply-accumulate 3; divide, square root 14; an
 *   arithmetic result that the very next instruction takes costs 1 more; load, store 2, of n registers 1 + n;
 * - integer: 1; load 2, behind another load or store 1; store 1; several registers 1 + n; multiply-accumulate 2; divide 12;
 * - a branch that is taken 3: itself and the pipeline.
 */
#include <ctype.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS = 1 << 19, TEXT = 16, OPERANDS = 48, LINE = 1024, LEFT_OUT_MAX = 32 };

typedef struct instruction {
    char name[TEXT]; /* without condition codes and types: vmul for vmul.f32 */
    char operands[OPERANDS];
    uint32_t bytes; /* 0: there is none here */
} instruction;

static instruction code[WORDS];         /* by half of their address */
static uint32_t entry;                  /* of the function */
static uint32_t left_out[LEFT_OUT_MAX]; /* entries of functions, 0 for one that is not there */

_Noreturn static void fail(const char *const what, const char *const which)
{
    fprintf(stderr, "cycles: %s%s\n", what, which);
    exit(EXIT_FAILURE);
}

static instruction *at(const uint32_t address)
{
    return address / 2 < WORDS ? &code[address / 2] : NULL;
}

/* A line `    12f4:\tee70 0a25 \tvadd.f32\ts1, s0, s11`. */
static void read_instruction(const char *const line)
{
    unsigned address = 0;
    int used = 0;
    char name[TEXT], operands[OPERANDS] = "";
    if (sscanf(line, " %x:%n", &address, &used) != 1 || used == 0 || line[used] != '\t') {
        return;
    }
    const char *const text = strchr(line + used + 1, '\t');
    if (text == NULL || sscanf(text, " %15s %47[^\n;@]", name, operands) < 1) {
        return;
    }
    instruction *const i = at(address);
    if (i != NULL) {
        name[strcspn(name, ".")] = '\0';
        memcpy(i->name, name, sizeof name);
        memcpy(i->operands, operands, sizeof operands);
        /* One group of four digits is 16 bits, two are 32. */
        i->bytes = isxdigit((unsigned char)line[used + 6]) ? 4 : 2;
    }
}

static void read_listing(const char *const path, const char *const function, char **const others)
{
    char line[LINE], label[LINE];
    unsigned address = 0;
    FILE *const file = fopen(path, "r");
    if (file == NULL) {
        fail("cannot read ", path);
    }
    while (fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "%x <%1000[^>]>:", &address, label) == 2) {
            entry = strcmp(label, function) == 0 ? address : entry;
            for (int i = 0; i < LEFT_OUT_MAX && others[i] != NULL; i++) {
                left_out[i] = strcmp(label, others[i]) == 0 ? address : left_out[i];
            }
        }
        read_instruction(line);
    }
    fclose(file);
    if (entry == 0) {
        fail("the listing has no function ", function);
    }
}

static bool is(const instruction *const i, const char *const start)
{
    return strncmp(i->name, start, strlen(start)) == 0;
}

/* The registers of a list {r4, r5} or {s16-s31}. */
static int registers(const char *text)
{
    int count = 0;
    for (text = strchr(text, '{'); text != NULL && *text != '}' && *text != '\0'; text += strcspn(text, ",}")) {
        int from = 0, to = 0;
        text += text[0] == '{' || text[0] == ',';
        const int found = sscanf(text, " %*[a-z]%d-%*[a-z]%d", &from, &to);
        count += found == 2 ? to - from + 1 : 1;
    }
    return count;
}

static bool is_load(const instruction *const i)
{
    return is(i, "ldr") || is(i, "str");
}

/* Floating-point arithmetic, whose result comes a cycle late for the next instruction. */
static bool is_arithmetic(const instruction *const i)
{
    return is(i, "vadd") || is(i, "vsub") || is(i, "vmul") || is(i, "vnmul") || is(i, "vml") || is(i, "vnml") ||
           is(i, "vdiv") || is(i, "vsqrt") || is(i, "vfm") || is(i, "vfnm");
}

/* Whether an instruction takes what the one before it makes in its first operand. */
static bool takes_result(const instruction *const i, const instruction *const before)
{
    char result[TEXT] = "";
    if (!is_arithmetic(before) || !is(i, "v") || sscanf(before->operands, "%15[a-z0-9]", result) != 1) {
        return false;
    }
    const size_t length = strlen(result);
    const bool all = is(i, "vstr") || is(i, "vcmp") || is(i, "vml") || is(i, "vnml") || is(i, "vfm");
    const char *from = all ? i->operands : strchr(i->operands, ',');
    for (from = from == NULL ? NULL : strstr(from, result); from != NULL; from = strstr(from + 1, result)) {
        const bool begins = from == i->operands || strchr(" ,{", from[-1]) != NULL;
        if (begins && (from[length] < '0' || from[length] > '9')) {
            return true;
        }
    }
    return false;
}

static int cycles_of(const instruction *const i, const instruction *const before)
{
    if (is(i, "vldm") || is(i, "vstm") || is(i, "vpush") || is(i, "vpop") || is(i, "ldm") || is(i, "stm") ||
        is(i, "push") || is(i, "pop")) {
        return 1 + registers(i->operands);
    }
    if (is(i, "vdiv") || is(i, "vsqrt")) {
        return 14;
    }
    if (is(i, "vml") || is(i, "vnml") || is(i, "vfm") || is(i, "vfnm")) {
        return 3;
    }
    if (is(i, "vldr") || is(i, "vstr")) {
        return 2;
    }
    if (is(i, "ldrd") || is(i, "strd")) {
        return 3;
    }
    if (is(i, "ldr")) {
        return is_load(before) ? 1 : 2;
    }
    if (is(i, "mla") || is(i, "mls")) {
        return 2;
    }
    return is(i, "sdiv") || is(i, "udiv") ? 12 : 1;
}

static bool is_left_out(const uint32_t address)
{
    bool found = false;
    for (int i = 0; i < LEFT_OUT_MAX; i++) {
        found = found || (left_out[i] != 0 && left_out[i] == address);
    }
    return found;
}

/* The address of the next instruction of the trace; false at its end. Lines read `Trace 0: 0x... [flags/address/...]`. */
static bool next_address(uint32_t *const address)
{
    char line[LINE];
    while (fgets(line, sizeof line, stdin) != NULL) {
        const char *const bracket = strchr(line, '[');
        if (strncmp(line, "Trace", 5) == 0 && bracket != NULL && sscanf(bracket, "[%*x/%" SCNx32, address) == 1) {
            return true;
        }
    }
    return false;
}

int main(int argc, char **argv)
{
    const bool ranges = argc > 1 && strcmp(argv[1], "--range") == 0;
    argc -= ranges;
    argv += ranges;
    if (argc < 3) {
        fail("usage: cycles [--range] FUNCTION LISTING [LEFT_OUT...] <TRACE", "");
    }
    read_listing(argv[2], argv[1], argv + 3);

    enum { BRANCH_REFILL = 2 };
    uint64_t instructions = 0, cycles = 0, last_instructions = 0, last_cycles = 0, least = UINT64_MAX, most = 0;
    uint32_t address = 0, before = 0;
    uint32_t back = 0, resume = 0; /* where the call returns to, and one that is left out; 0 outside of one */
    while (next_address(&address)) {
        const instruction *const i = at(address), *const previous = at(before);
        if (back != 0 && address == back) {
            last_instructions = instructions;
            last_cycles = cycles;
            least = instructions < least ? instructions : least;
            most = instructions > most ? instructions : most;
            back = 0;
        }
        if (back == 0 && address == entry && previous != NULL) {
            back = before + previous->bytes;
            instructions = cycles = 0;
        }
        if (address == resume) {
            resume = 0;
        }
        if (back != 0 && resume == 0 && is_left_out(address) && previous != NULL) {
            resume = before + previous->bytes;
        }
        if (back != 0 && resume == 0) {
            if (i == NULL || i->bytes == 0 || previous == NULL) {
                fail("the trace leaves the listing", "");
            }
            const bool jumped = address != before + previous->bytes && instructions > 0;
            instructions++;
            cycles += (uint64_t)cycles_of(i, previous) + takes_result(i, previous) + (jumped ? BRANCH_REFILL : 0);
        }
        before = address;
    }
    if (last_instructions == 0) {
        fail("the trace has no call that returns of ", argv[1]);
    }
    if (ranges) {
        printf("least %" PRIu64 "\nmost %" PRIu64 "\n", least, most);
    } else {
        printf("instructions %" PRIu64 "\ncycles %" PRIu64 "\n", last_instructions, last_cycles);
    }
    return EXIT_SUCCESS;
}
