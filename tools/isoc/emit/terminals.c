#include "tools/isoc/emit/parts.h"

#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

/* FNV-1a in 64 bits, continued over a text. */
static uint64_t hash_text(uint64_t hash, const text *t)
{
    for (size_t i = 0; i < t->length; i++) {
        hash = (hash ^ (uint8_t)t->bytes[i]) * UINT64_C(0x00000100000001B3);
    }
    return hash;
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

static uint64_t identity_by(const plant *p, const naming *names, const file_list *files)
{
    enum { FILES_OF_A_PLANT = 2 };
    text wires = {.memory = files->memory};
    emit_wires(p, names, &wires);
    uint64_t identity = UINT64_C(0xCBF29CE484222325);
    for (size_t i = 0; i < FILES_OF_A_PLANT; i++) {
        identity = hash_text(identity, &files->files[i].text);
    }
    return hash_text(identity, &wires);
}

terminals terminals_of(const plant *p, const naming *names, const file_list *files)
{
    arena *memory = files->memory;
    const mechanism *m = p->m;
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
                       .inputs = inputs,
                       .outputs = names->about_outputs,
                       .tunables = m->parameters.all,
                       .input_count = m->inputs.wire_count,
                       .output_count = p->outputs.count,
                       .tunable_count = m->parameters.count,
                       .identity = identity_by(p, names, files),
                       .period_ns = lround(m->method.step * 1e9),
                       .is_double = p->is_double};
}

const char *identity_of(const terminals *t, arena *memory)
{
    return arena_format(memory, "0x%016" PRIx64, t->identity);
}

/* A number of a range as C or Python has it; none is `infinity`. */
const char *bound(arena *memory, double number, const char *infinity)
{
    return isinf(number) ? arena_format(memory, "%s%s", number < 0.0 ? "-" : "", infinity)
                         : arena_format(memory, "%.17g", number);
}
