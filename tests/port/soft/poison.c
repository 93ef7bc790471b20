/* Under memcheck: every operation of port/soft on operands that are marked undefined. A branch, a loop or an address
 * that follows from one is an error that memcheck counts. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <valgrind/memcheck.h>

#include "tests/port/soft/operations.h"
#include "tests/port/soft/wide_operations.h"

enum { KINDS = 14 };

static bool report(const int number, const char *const name, const bool passed)
{
    printf("%sok %d - %s\n", passed ? "" : "not ", number, name);
    return passed;
}

/* Those of binary64. */
static bool is_wide_unbranched(const wide_kind kind)
{
    uint64_t a = UINT64_C(0x3FF0000000000001), b = UINT64_C(0xBFF0000000000001);
    const unsigned long before = VALGRIND_COUNT_ERRORS;
    VALGRIND_MAKE_MEM_UNDEFINED(&a, sizeof a);
    VALGRIND_MAKE_MEM_UNDEFINED(&b, sizeof b);
    const uint64_t result = wide_operations[kind](a, b);
    uint64_t marks = 0;
    return VALGRIND_GET_VBITS(&result, &marks, sizeof marks) == 1 && marks != 0 && VALGRIND_COUNT_ERRORS == before;
}

int main(void)
{
    const operations *const soft = &the_operations;
    const struct {
        const char *name;
        uint32_t (*tried)(uint32_t a, uint32_t b);
        bool has_two; /* operands: the second one of the others says which half is asked for, or nothing */
    } cases[KINDS] = {
        {"sum", soft->add, true},
        {"difference", soft->subtract, true},
        {"product", soft->multiply, true},
        {"quotient", soft->divide, true},
        {"root", soft->root, false},
        {"comparison", soft->compare, true},
        {"from int32", soft->from_int32, false},
        {"from uint32", soft->from_uint32, false},
        {"from int64", soft->from_int64, true},
        {"from uint64", soft->from_uint64, true},
        {"to int32", soft->to_int32, false},
        {"to uint32", soft->to_uint32, false},
        {"to int64", soft->to_int64, false},
        {"to uint64", soft->to_uint64, false},
    };
    int failures = 0;
    for (int i = 0; i < KINDS; i++) {
        uint32_t a = 0x3F800001, b = cases[i].has_two ? 0xBF800001 : 0;
        const unsigned long before = VALGRIND_COUNT_ERRORS;
        VALGRIND_MAKE_MEM_UNDEFINED(&a, sizeof a);
        if (cases[i].has_two) {
            VALGRIND_MAKE_MEM_UNDEFINED(&b, sizeof b);
        }
        const uint32_t result = cases[i].tried(a, b);
        uint32_t marks = 0;
        const bool is_marked = VALGRIND_GET_VBITS(&result, &marks, sizeof marks) == 1 && marks != 0;
        failures += report(i + 1, cases[i].name, VALGRIND_COUNT_ERRORS == before && is_marked) ? 0 : 1;
    }
    for (int i = 0; i < WIDE_KINDS; i++) {
        char name[32];
        (void)snprintf(name, sizeof name, "double: %s", wide_names[i]);
        failures += report(KINDS + i + 1, name, is_wide_unbranched((wide_kind)i)) ? 0 : 1;
    }
    printf("1..%d\n", KINDS + WIDE_KINDS);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
