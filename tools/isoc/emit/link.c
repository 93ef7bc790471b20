
#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/application/protocol.h"
#include "core/link/frame.h"
#include "port/channel.h"
#include "tools/isoc/base/embedded.h"
#include "tools/isoc/emit/parts.h"

/* The content of the frames of a plant. */
typedef struct terminals {
    const char *prefix, *capitals; /* of names in C: cart_pole, CART_POLE */
    const char *scene;
    const variable *inputs, *outputs, *tunables;
    int input_count, output_count, tunable_count;
    uint64_t identity;
    long period_ns;
    bool is_double;
} terminals;

/* FNV-1a in 64 bits, continued over a text. */
static uint64_t hash_text(uint64_t hash, const text *t)
{
    for (size_t i = 0; i < t->length; i++) {
        hash = (hash ^ (uint8_t)t->bytes[i]) * UINT64_C(0x00000100000001B3);
    }
    return hash;
}

static const char *literal_of_plant(arena *memory, const plant *p, double number)
{
    return code_literal(memory, number, p->is_double);
}

/* --- interface.c ------------------------------------------------------------------------------------------------- */

/* The inputs that come over the link, with their safe values. */
static void emit_wires(const plant *p, const naming *names, text *out)
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
                 literal_of_plant(out->memory, p, w->safe), w->after);
    }
    text_add(out, "};\nstatic real values[WIRES];\n\n");
}

static void emit_interface(const plant *p, const naming *names, const text *wires, uint64_t identity, const char *lock,
                           text *out)
{
    const char *capitals = names->capitals;
    const bool any = p->m->inputs.wire_count > 0;
    text_add(out, "/* What the plant of %s.scene shows at its link. Made by isoc. */\n", p->m->name);
    text_add(out, "#include \"%s.h\"\n\n#include \"core/link/link.h\"\n%s\n%s", names->prefix,
             lock == NULL ? "" : "#include \"core/xcp/service.h\"\n", wires->bytes);
    if (lock != NULL) {
        emit_calibration(p, names, lock, identity, out);
    }
    text_add(out, "static uint8_t received[ISO_LINK_BYTES(WIRES, %s_OUTPUTS)], sent[sizeof received];\n", capitals);
    text_add(out, "_Static_assert(sizeof received <= ISO_CHANNEL_BYTES, \"a channel takes a frame at once\");\n");
    text_add(out, "static unsigned char record[ISO_SNAPSHOT_BYTES(sizeof(%s_memory))];\n\n", names->prefix);
    text_add(out, "const iso_interface iso_the_interface = {\n    .identity = UINT64_C(0x%016" PRIx64 "),\n", identity);
    text_add(out, "%s", any ? "    .wires = wires,\n    .wire_count = WIRES,\n    .values = values,\n" : "");
    text_add(out, "%s", lock == NULL ? "" : "    .services = services,\n    .service_count = 1,\n");
    text_add(out, "    .received = received,\n    .sent = sent,\n    .frame_bytes = sizeof received,\n"
                  "    .record = record,\n    .record_bytes = sizeof record,\n};\n");
}

/* --- The controller's end ---------------------------------------------------------------------------------------- */

static terminals terminals_of(const plant *p, const naming *names, arena *memory, uint64_t identity)
{
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
                       .identity = identity,
                       .period_ns = lround(m->method.step * 1e9),
                       .is_double = p->is_double};
}

static const char *identity_of(const terminals *t, arena *memory)
{
    return arena_format(memory, "0x%016" PRIx64, t->identity);
}

/* A number of a range as C or Python has it; none is `infinity`. */
static const char *bound(arena *memory, double number, const char *infinity)
{
    return isinf(number) ? arena_format(memory, "%s%s", number < 0.0 ? "-" : "", infinity)
                         : arena_format(memory, "%.17g", number);
}

/* The places in a frame, with name, unit and comment of each: enum {CART_POLE_U_FORCE, ...}. */
static void emit_terminals(const terminals *t, char array, const char *what, const variable *all, int count, text *out)
{
    text_add(out, "enum {\n");
    for (int i = 0; i < count; i++) {
        text_add(out, "    %s_%c_%s, /* %s */\n", t->capitals, array, capitals_of(out->memory, all[i].name),
                 all[i].unit);
    }
    text_add(out, "    %s_%s\n};\n", t->capitals, capitals_of(out->memory, what));
    if (count > 0) {
        text_add(out, "static const iso_client_quantity %s_%s[%s_%s] = {\n", t->prefix, what, t->capitals,
                 capitals_of(out->memory, what));
        for (int i = 0; i < count; i++) {
            text_add(out, "    {\"%s\", \"%s\", %s, %s},\n", all[i].name, all[i].unit,
                     bound(out->memory, all[i].least, "HUGE_VAL"), bound(out->memory, all[i].most, "HUGE_VAL"));
        }
        text_add(out, "};\n");
    }
}

static void emit_client_header(const terminals *t, text *out)
{
    text inputs = {.memory = out->memory}, outputs = inputs, tunables = inputs;
    emit_terminals(t, 'U', "inputs", t->inputs, t->input_count, &inputs);
    emit_terminals(t, 'Y', "outputs", t->outputs, t->output_count, &outputs);
    emit_terminals(t, 'P', "tunables", t->tunables, t->tunable_count, &tunables);
    text_fill(out, embedded_text(client_files, "tools/client/link.h.in"),
              (const filling[]){{"scene", t->scene},
                                {"tables", protocol_in_c(out->memory)},
                                {"client", embedded_text(client_files, "tools/client/client.h")},
                                {"commands", embedded_text(client_files, "tools/client/commands.h")},
                                {"prefix", t->prefix},
                                {"PREFIX", t->capitals},
                                {"real", t->is_double ? "double" : "float"},
                                {"identity", identity_of(t, out->memory)},
                                {"period_ns", arena_format(out->memory, "%ld", t->period_ns)},
                                {"inputs", inputs.bytes},
                                {"outputs", outputs.bytes},
                                {"tunables", tunables.bytes},
                                {NULL, NULL}});
}

static const char *python_dictionary(arena *memory, const variable *all, int count)
{
    text rows = {.memory = memory};
    text_add(&rows, "{\n");
    for (int i = 0; i < count; i++) {
        text_add(&rows, "    \"%s\": (\"%s\", %s, %s),\n", all[i].name, all[i].unit,
                 bound(memory, all[i].least, "float(\"inf\")"), bound(memory, all[i].most, "float(\"inf\")"));
    }
    text_add(&rows, "}");
    return rows.bytes;
}

static void emit_client_module(const terminals *t, text *out)
{
    static const char assignment[] = "    @name@=@number@,\n", entry[] = "    @number@: @words@,\n",
                      layout[] = "    @name@=\"@layout@\",\n", quoted[] = "    \"@name@\",\n";
    arena *memory = out->memory;
    text_fill(out, embedded_text(client_files, "tools/client/client.py.in"),
              (const filling[]){{"scene", t->scene},
                                {"type", t->is_double ? "d" : "f"},
                                {"identity", identity_of(t, memory)},
                                {"period_ns", arena_format(memory, "%ld", t->period_ns)},
                                {"inputs", python_dictionary(memory, t->inputs, t->input_count)},
                                {"outputs", python_dictionary(memory, t->outputs, t->output_count)},
                                {"tunables", python_dictionary(memory, t->tunables, t->tunable_count)},
                                {"frames", protocol_rows(memory, PROTOCOL_FRAMES, "    @name@=b@number@,\n")},
                                {"modes", protocol_rows(memory, PROTOCOL_MODES, "    @words@: @number@,\n")},
                                {"reasons", protocol_rows(memory, PROTOCOL_REASONS, entry)},
                                {"commands", protocol_rows(memory, PROTOCOL_COMMANDS, assignment)},
                                {"states", protocol_rows(memory, PROTOCOL_STATES, entry)},
                                {"answers", protocol_rows(memory, PROTOCOL_ANSWERS, entry)},
                                {"version", protocol_version(memory)},
                                {"piece", protocol_piece(memory)},
                                {"start fields", protocol_rows(memory, PROTOCOL_START_FIELDS, quoted)},
                                {"state fields", protocol_rows(memory, PROTOCOL_STATE_FIELDS, quoted)},
                                {"state layout", protocol_rows(memory, PROTOCOL_STATE_FIELDS, "@layout@")},
                                {"layouts", protocol_rows(memory, PROTOCOL_FRAMES, layout)},
                                {"command layouts", protocol_rows(memory, PROTOCOL_COMMANDS, layout)},
                                {"words", protocol_rows(memory, PROTOCOL_WORDS, quoted)},
                                {NULL, NULL}});
}

/* The files by which pip installs the module. */
static void add_package(const terminals *t, file_list *files)
{
    arena *memory = files->memory;
    const char *module = arena_format(memory, "%s_link", t->prefix);
    const char *const parts[][2] = {
        {"pyproject.toml", "tools/client/pyproject.toml.in"},
        {arena_format(memory, "%s_wheel.py", module), "tools/client/wheel.py.in"},
    };
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        text filled = {.memory = memory};
        text_fill(&filled, embedded_text(client_files, parts[i][1]),
                  (const filling[]){{"scene", t->scene},
                                    {"module", module},
                                    {"identity", arena_format(memory, "%016" PRIx64, t->identity)},
                                    {NULL, NULL}});
        file_list_add(files, parts[i][0], &filled);
    }
}

bool link_fits(const plant *p, const char *path)
{
    enum { TICK_BYTES = 0 ISO_LINK_OUTPUTS_FIELDS(ISO_FIELD_BYTES) };
    const bool is_in = p->m->inputs.wire_count > p->outputs.count;
    const int reals = is_in ? p->m->inputs.wire_count : p->outputs.count;
    const int frame = ISO_FRAME_BYTES(TICK_BYTES + reals * (int)(p->is_double ? sizeof(double) : sizeof(float)));
    if (frame > ISO_CHANNEL_BYTES) {
        fprintf(
            stderr,
            "%s: error: a frame of its %d %s has %d bytes, and a channel takes %d at once; leave some of them out%s\n",
            path, reals, is_in ? "inputs" : "outputs", frame, ISO_CHANNEL_BYTES,
            is_in ? "" : ", or read them over XCP");
    }
    return frame <= ISO_CHANNEL_BYTES;
}

void emit_link(const plant *p, const naming *names, const char *lock, file_list *files)
{
    arena *memory = files->memory;
    text wires = {.memory = memory}, interface = {.memory = memory};
    text header = {.memory = memory}, module = {.memory = memory};
    emit_wires(p, names, &wires);
    uint64_t identity = UINT64_C(0xCBF29CE484222325);
    for (size_t i = 0; i < files->count; i++) {
        identity = hash_text(identity, &files->files[i].text);
    }
    identity = hash_text(identity, &wires);
    const terminals t = terminals_of(p, names, memory, identity);
    emit_interface(p, names, &wires, identity, lock, &interface);
    emit_client_header(&t, &header);
    emit_client_module(&t, &module);
    file_list_add(files, "interface.c", &interface);
    if (lock != NULL) {
        text a2l = {.memory = memory};
        emit_a2l(p, names, identity, &a2l);
        file_list_add(files, "plant.a2l.in", &a2l);
    }
    file_list_add(files, arena_format(memory, "%s_link.h", t.prefix), &header);
    file_list_add(files, arena_format(memory, "%s_link.py", t.prefix), &module);
    add_package(&t, files);
}
