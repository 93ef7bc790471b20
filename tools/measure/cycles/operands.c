#include "tools/measure/cycles/cycles.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { SP = 13, PC = 15, FIRST_OF_FLOAT = 16, WORD_BYTES = 4, OPERANDS_MOST = 6 };

/* One operand: its place, and its registers. */
typedef struct operand {
    const char *text;
    size_t length;
    registers all;
    int32_t words; /* of a list, else 0 */
} operand;

/* The number of a register by its name, -1 if it is none; *width is how many of 32 bits it stands for. */
static int register_of(const char *const name, const size_t length, int *const width)
{
    static const char *const named[] = {"sl", "fp", "ip", "sp", "lr", "pc"}; /* from 10 on */
    *width = 1;
    for (int i = 0; i < 6; i++) {
        if (length == 2 && strncmp(name, named[i], length) == 0) {
            return 10 + i;
        }
    }
    if (length < 2 || !isdigit((unsigned char)name[1]) || strchr("rsd", name[0]) == NULL) {
        return -1;
    }
    const int number = atoi(name + 1);
    *width = name[0] == 'd' ? 2 : 1;
    return name[0] == 'r' ? number : name[0] == 's' ? FIRST_OF_FLOAT + number : FIRST_OF_FLOAT + 2 * number;
}

/* Adds the registers in a text; a-b stands for all from a to b. Returns how many words they are. */
static int32_t find_registers(const char *const text, const size_t length, registers *const set)
{
    int32_t words = 0;
    int last = -1;
    bool ranges = false;
    for (size_t i = 0; i < length;) {
        size_t end = i;
        while (end < length && isalnum((unsigned char)text[end])) {
            end++;
        }
        int width = 1;
        const int number = end > i ? register_of(text + i, end - i, &width) : -1;
        if (number >= 0 && number + width <= REGISTERS) {
            for (int r = ranges && last >= 0 ? last + 1 : number; r < number + width; r++) {
                *set |= (registers)1 << r;
                words++;
            }
            last = number + width - 1;
            ranges = false;
        } else if (end > i) {
            last = -1;
        }
        ranges = end < length && text[end] == '-';
        i = end + 1;
    }
    return words;
}

/* Splits at the commas that stand in no bracket. */
static int split(const char *text, operand *const o)
{
    int count = 0, depth = 0;
    const char *begin = text;
    for (;; text++) {
        depth += *text == '[' || *text == '{';
        depth -= *text == ']' || *text == '}';
        const bool ends = *text == '\0' || *text == '\n' || *text == '@' || *text == ';';
        if (ends || (*text == ',' && depth == 0)) {
            begin += strspn(begin, " \t");
            if (count < OPERANDS_MOST && text > begin) {
                o[count] = (operand){.text = begin, .length = (size_t)(text - begin)};
                const int32_t words = find_registers(begin, o[count].length, &o[count].all);
                o[count].words = *begin == '{' ? words : 0;
                count++;
            }
            begin = text + 1;
        }
        if (ends) {
            return count;
        }
    }
}

/* The number behind a #, as in #-4; 0 if there is none. */
static int32_t number_in(const operand *const o)
{
    const char *const sign = memchr(o->text, '#', o->length);
    return sign == NULL ? 0 : (int32_t)strtol(sign + 1, NULL, 10);
}

static bool is_sp(const operand *const o)
{
    return o->length >= 2 && strncmp(o->text, "sp", 2) == 0 &&
           (o->length == 2 || o->text[2] == '!' || o->text[2] == ' ');
}

/* The growth of the stack: lists at the stack pointer, sums and differences, addresses that are written back. */
static void find_growth(const operand *const o, const int count, instruction *const i)
{
    const bool is_store = i->rule->kind == STORE;
    const bool is_list = o[0].words > 0 || (count > 1 && o[1].words > 0);
    if (is_list && (i->at_stack || (count > 1 && is_sp(&o[0])))) {
        const bool stays = o[0].words == 0 && memchr(o[0].text, '!', o[0].length) == NULL;
        i->at_stack = true;
        i->pushes = stays ? 0 : (is_store ? 1 : -1) * WORD_BYTES * i->words;
    } else if (count > 1 && is_sp(&o[0]) && (strncmp(i->name, "sub", 3) == 0 || strncmp(i->name, "add", 3) == 0)) {
        const operand *const by = &o[count - 1];
        const int32_t sign = i->name[0] == 's' ? 1 : -1;
        i->pushes = sign * number_in(by);
        if (by->all != 0 && sign < 0) {
            i->grows_by = (int8_t)__builtin_ctzll(by->all);
        }
    } else if (i->at_stack && !is_list) {
        const operand *const last = &o[count - 1];
        const bool before = memchr(last->text, '!', last->length) != NULL;
        const bool behind = last->text[0] == '#';
        i->pushes = before || behind ? -number_in(last) : 0;
    }
}

/* The word of the program that `ldr r3, [pc, #8] @ (1234 <f+0x10>)` loads. */
static void find_constant(const char *const text, const operand *const o, instruction *const i)
{
    const char *const place = strstr(text, "@ (");
    if (i->rule->kind == LOAD && place != NULL && strstr(text, "[pc") != NULL && o[0].all != 0 && o[0].all < 1U << SP) {
        i->constant = (uint32_t)strtoul(place + 3, NULL, 16);
        i->loads = (int8_t)__builtin_ctzll(o[0].all);
    }
}

void operands_of_thumb(const char *const text, instruction *const i)
{
    operand o[OPERANDS_MOST] = {{0}};
    const int count = split(text, o);
    const unsigned use = i->rule->use;
    const bool stores = (use & READS) != 0;
    const int written = stores ? 0 : (use & TWO) != 0 ? 2 : 1;
    const bool is_based = count > 1 && o[1].words > 0; /* ldm r0!, {r1, r2} */
    i->at_stack = (use & STACK) != 0;
    for (int k = 0; k < count; k++) {
        i->words += o[k].words;
        if (o[k].text[0] == '[' || (is_based && k == 0)) {
            i->addresses |= o[k].all;
            i->at_stack = i->at_stack || (o[k].all >> SP & 1) != 0;
            i->is_literal = (o[k].all >> PC & 1) != 0;
            i->is_indexed = o[k].text[0] == '[' && (o[k].all & (o[k].all - 1)) != 0;
        } else if (is_based ? !stores : k < written) {
            i->writes |= o[k].all;
        } else {
            i->reads |= o[k].all;
        }
    }
    if ((use & BOTH) != 0) {
        i->reads |= o[0].all;
    }
    if ((use & WIDE) != 0) {
        i->words = find_registers(o[0].text, o[0].length, &o[0].all);
    }
    i->leaves = (strncmp(i->name, "bx", 2) == 0 && strncmp(o[0].text != NULL ? o[0].text : "", "lr", 2) == 0) ||
                (i->rule->kind == LOAD && (i->writes >> PC & 1) != 0);
    if (count > 0) {
        find_growth(o, count, i);
        find_constant(text, o, i);
    }
}
