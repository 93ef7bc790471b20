#include "tools/isoc/export/terminals.h"

#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

/* FNV-1a in 64 bits. */
const char *identity_of(const file_list *files, size_t count, const text *more)
{
    uint64_t hash = UINT64_C(0xCBF29CE484222325);
    for (size_t i = 0; i <= count; i++) {
        const text *t = i < count ? &files->files[i].text : more;
        for (size_t k = 0; k < t->length; k++) {
            hash = (hash ^ (uint8_t)t->bytes[k]) * UINT64_C(0x00000100000001B3);
        }
    }
    return arena_format(files->memory, "%016" PRIx64, hash);
}

/* The inputs that come over the link, with their safe values. */
void emit_wires(const plant *p, const naming *names, text *out)
{
    const mechanism *m = p->m;
    text_add(out, "enum { WIRES = %d };\n\n", m->inputs.wire_count);
    if (m->inputs.wire_count == 0) {
        return;
    }
    text_add(out, "/* The inputs that come in, each with its safe value, and after how many ticks without a frame. */\n"
                  "static const iso_wire wires[WIRES] = {\n");
    FOR_ALL (const wire, w, m->inputs.wires, m->inputs.wire_count) {
        text_add(out, "    {%s, %s, %.0f},\n", names->leaves.inputs[w->input].place,
                 code_literal(out->memory, w->safe, p->is_double), w->after);
    }
    text_add(out, "};\nstatic real values[WIRES];\n\n");
}

terminals terminals_of(const plant *p, const naming *names, const file_list *files)
{
    enum { FILES_OF_A_PLANT = 2 };
    arena *memory = files->memory;
    const mechanism *m = p->m;
    text wires = {.memory = memory};
    emit_wires(p, names, &wires);
    variable *inputs = arena_take(memory, (size_t)m->inputs.wire_count + 1, sizeof *inputs);
    for (int i = 0; i < m->inputs.wire_count; i++) {
        inputs[i] = m->inputs.all[m->inputs.wires[i].input];
    }
    char *prefix = arena_copy(memory, m->name, strlen(m->name));
    for (char *c = prefix; *c != '\0'; c++) {
        *c = (char)tolower((unsigned char)*c);
    }
    const char *called = isalpha((unsigned char)prefix[0]) ? prefix : arena_format(memory, "plant_%s", prefix);
    return (terminals){.prefix = called,
                       .capitals = capitals_of(memory, called),
                       .scene = m->name,
                       .inputs = {NULL, inputs, m->inputs.wire_count},
                       .outputs = names->y,
                       .tunables = names->p,
                       .identity = identity_of(files, FILES_OF_A_PLANT, &wires),
                       .period_ns = period_of(p),
                       .is_double = p->is_double};
}

const char *bound(arena *memory, double number, const char *infinity)
{
    return isinf(number) ? arena_format(memory, "%s%s", number < 0.0 ? "-" : "", infinity)
                         : arena_format(memory, "%.17g", number);
}
