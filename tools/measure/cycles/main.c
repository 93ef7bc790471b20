/* Instructions and cycles of a function, from the trace of a simulator, by a table of cycles of each instruction.
 *
 *     SIMULATOR | cycles count [--range] CORE LISTING FUNCTION [LEFT_OUT...]
 *     SIMULATOR | cycles tick CORE LISTING FUNCTION WHAT PART=FUNCTIONS...
 *     cycles unknown CORE <NAMES
 *
 * CORE is a table (cores/), LISTING the output of `objdump -d` for the program. `count` prints those of the last call
 * of FUNCTION that returns, with all that it calls, but for interrupts and the functions LEFT_OUT; with --range the
 * least and the most instructions of all calls, the number of the first call with the most, and their mean. `tick`
 * prints a table of the call that takes most cycles, with WHAT as its kind, by parts of functions that are called in
 * it; the part `interrupt` has those of interrupts, that of the name
 * `-` is left out. `unknown` prints those of the instructions, a name in each line, of which the table has no rule.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/file/file.h"
#include "tools/measure/cycles/cycles.h"

/* Reads CORE and LISTING, for `parts` of functions, and walks the calls of FUNCTION. */
static walk_result *walked(walk_plan *const plan, char **const argv, const size_t parts)
{
    static core c;
    static listing l;
    static walk_result result;
    c = core_read(argv[0]);
    l = listing_read(argv[1], &c, argv[2], plan->parts, parts);
    plan->core = &c;
    plan->listing = &l;
    walk(plan, &result);
    if (result.calls == 0) {
        quit("cycles: the trace has no call that returns of %s", argv[2]);
    }
    return &result;
}

static int count(int argc, char **argv)
{
    const bool ranges = argc > 0 && strcmp(argv[0], "--range") == 0;
    argc -= ranges;
    argv += ranges;
    if (argc < 3) {
        quit("cycles: usage: cycles count [--range] CORE LISTING FUNCTION [LEFT_OUT...] <TRACE");
    }
    /* tick_interrupt on boards of QEMU, __vector_15 on the AVR. */
    part parts[PARTS_MOST] = {{"interrupt", "tick_interrupt,__vector_15"}};
    size_t number = 1;
    for (int i = 3; i < argc; i++) {
        if (number == PARTS_MOST) {
            quit("cycles: too many functions are left out");
        }
        parts[number++] = (part){"-", argv[i]};
    }
    walk_plan plan = {.parts = parts, .count = 1, .interrupt = 1};
    const walk_result *const result = walked(&plan, argv, number);
    if (ranges) {
        printf("least %" PRIu64 "\nmost %" PRIu64 "\nlongest %" PRIu64 "\nmean %" PRIu64 "\n", result->least,
               result->most, result->longest, (result->all + result->calls / 2) / result->calls);
    } else {
        const amount all = call_total(&plan, &result->last);
        printf("instructions %" PRIu64 "\ncycles %" PRIi64 "\n", all.instructions, (all.most + HALVES - 1) / HALVES);
    }
    return EXIT_SUCCESS;
}

static void print_amount(const char *const row, const char *const name, const amount a)
{
    printf("%s\t%s\t%" PRIu64 "\t%.12g\t%.12g\t%" PRIu64 "\n", row, name, a.instructions,
           (double)a.least / (double)HALVES, (double)a.most / (double)HALVES, a.counted);
}

static void print_tick(const walk_plan *const plan, const walk_result *const result, const char *const what)
{
    const call *const dearest = &result->dearest;
    printf("core\t%s\nsource\t%s\nnote\t%s\nof\t%s\n", plan->core->name, plan->core->source, plan->core->note, what);
    printf("ticks\t%" PRIu64 "\nnumber\t%" PRIu64 "\nmean\t%.0f\n", result->calls, dearest->number,
           (double)result->sum / (double)HALVES / (double)result->calls);
    for (size_t g = 0; g <= plan->count; g++) {
        const char *const name = g == 0 ? "loop" : plan->parts[g - 1].name;
        if (g == 0 || (g != plan->left_out && g != plan->interrupt)) {
            print_amount("part", name, part_total(dearest, g));
        }
    }
    print_amount("part", "tick", call_total(plan, dearest));
    print_amount("part", "interrupt", dearest->interrupt);
    for (size_t g = 1; g <= plan->count; g++) {
        if (strcmp(plan->parts[g - 1].name, "step") == 0) {
            for (size_t k = 0; k < KINDS; k++) {
                print_amount("kind", kind_names[k], dearest->amounts[g][k]);
            }
            printf("stack_of_step\t%" PRIi32 "\n", dearest->stack_of[g]);
        }
    }
    printf("stack\t%" PRIi32 "\n", dearest->stack);
}

static int tick(const int argc, char **const argv)
{
    enum { FIRST_PART = 4 };
    part parts[PARTS_MOST];
    walk_plan plan = {.parts = parts};
    for (int i = FIRST_PART; i < argc; i++) {
        char *const sign = strchr(argv[i], '=');
        if (sign == NULL || plan.count == PARTS_MOST) {
            quit("cycles: no part of functions: %s", argv[i]);
        }
        *sign = '\0';
        parts[plan.count++] = (part){argv[i], sign + 1};
        plan.left_out = strcmp(argv[i], "-") == 0 ? plan.count : plan.left_out;
        plan.interrupt = strcmp(argv[i], "interrupt") == 0 ? plan.count : plan.interrupt;
    }
    if (plan.count == 0) {
        quit("cycles: usage: cycles tick CORE LISTING FUNCTION WHAT PART=FUNCTIONS... <TRACE");
    }
    print_tick(&plan, walked(&plan, argv, plan.count), argv[3]);
    return EXIT_SUCCESS;
}

static int unknown(const int argc, char **const argv)
{
    char name[NAME_CHARACTERS];
    if (argc != 1) {
        quit("cycles: usage: cycles unknown CORE <NAMES");
    }
    const core c = core_read(argv[0]);
    while (scanf("%15s", name) == 1) {
        if (core_rule(&c, name) == NULL) {
            puts(name);
        }
    }
    return EXIT_SUCCESS;
}

int main(const int argc, char **const argv)
{
    if (argc > 1 && strcmp(argv[1], "count") == 0) {
        return count(argc - 2, argv + 2);
    }
    if (argc > 1 && strcmp(argv[1], "tick") == 0) {
        return tick(argc - 2, argv + 2);
    }
    if (argc > 1 && strcmp(argv[1], "unknown") == 0) {
        return unknown(argc - 2, argv + 2);
    }
    quit("cycles: usage: cycles count|tick|unknown ...");
}
