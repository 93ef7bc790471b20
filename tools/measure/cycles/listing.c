#include "tools/measure/cycles/cycles.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/file/file.h"

enum { LINE = 1024, LABEL = 256, WORDS = 1 << 19 };

const instruction *listing_at(const listing *const l, const uint32_t address)
{
    return address / 2 < l->words ? &l->code[address / 2] : NULL;
}

static int8_t part_of(const char *const label, const part *const parts, const size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (is_listed(parts[i].functions, ",", label)) {
            return (int8_t)(i + 1);
        }
    }
    return 0;
}

/* A line `    12f4:\tee70 0a25 \tvadd.f32\ts1, s0, s11`, or `      3c:\t0c 94 e8 23 \tjmp\t0x47d0\t; 0x47d0 <f>`. */
static void read_instruction(const char *const line, const core *const c, listing *const l)
{
    unsigned address = 0;
    int used = 0;
    if (sscanf(line, " %x:%n", &address, &used) != 1 || used == 0 || line[used] != '\t' || address / 2 >= WORDS) {
        return;
    }
    const char *const digits = line + used + 1;
    const char *const text = strchr(digits, '\t');
    if (text == NULL) {
        return;
    }
    uint32_t count = 0;
    for (const char *at = digits; at < text; at++) {
        count += isxdigit((unsigned char)*at) != 0;
    }
    instruction *const i = &l->code[address / 2];
    const char *const operands = text + 1 + strcspn(text + 1, "\t\n");
    if (strncmp(text + 1, ".word", 5) == 0) {
        l->constant[address / 2] = (uint32_t)strtoul(operands, NULL, 16);
    }
    snprintf(i->name, sizeof i->name, "%.*s", (int)strcspn(text + 1, " \t\n"), text + 1);
    i->bytes = count / 2;
    i->rule = core_rule(c, i->name);
    i->grows_by = i->loads = -1;
    if (i->rule != NULL && c->is_thumb) {
        operands_of_thumb(operands, i);
    } else if (i->rule != NULL) {
        const char *const at = strstr(operands, c->stack);
        i->at_stack = (i->rule->use & STACK) != 0 || (at != NULL && at < operands + strcspn(operands, ";"));
        i->leaves = strcmp(i->name, "reti") == 0;
    }
}

/* The function in whose vector the AVR jumps, `jmp 0x47d0 ; 0x47d0 <__vector_15>`; an empty text for other lines. */
static void vector_of(const char *const line, char *const label)
{
    const char *const jump = strstr(line, "\tjmp\t"), *const name = strchr(line, '<');
    label[0] = '\0';
    if (jump != NULL && name != NULL) {
        snprintf(label, LABEL, "%.*s", (int)strcspn(name + 1, ">+"), name + 1);
    }
}

listing listing_read(const char *const path, const core *const c, const char *const entry, const part *const parts,
                     const size_t count)
{
    listing l = {memory_for(WORDS, sizeof(instruction)), memory_for(WORDS, sizeof(uint32_t)), WORDS, 0};
    char line[LINE], label[LABEL];
    unsigned address = 0;
    bool in_vectors = false;
    FILE *const file = fopen(path, "r");
    if (file == NULL) {
        quit("cycles: cannot read %s", path);
    }
    while (fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "%x <%255[^>]>:", &address, label) == 2 && address / 2 < WORDS) {
            if (strcmp(label, entry) == 0) {
                l.entry = address;
            }
            l.code[address / 2].part = part_of(label, parts, count);
            in_vectors = strcmp(label, "__vectors") == 0;
            continue;
        }
        read_instruction(line, c, &l);
        if (in_vectors && sscanf(line, " %x:", &address) == 1 && address / 2 < WORDS) {
            vector_of(line, label);
            l.code[address / 2].part = part_of(label, parts, count);
        }
    }
    fclose(file);
    if (l.entry == 0) {
        quit("cycles: the listing has no function %s", entry);
    }
    return l;
}
