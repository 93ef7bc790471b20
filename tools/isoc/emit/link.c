#include "tools/isoc/emit/link.h"

#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tools/isoc/base/embedded.h"
#include "tools/isoc/emit/a2l.h"

/* A quantity in a frame: an input, or an output. */
typedef struct terminal {
    const char *name, *unit;
    double least, most;
} terminal;

/* What the frames of a plant carry. */
typedef struct terminals {
    const char *prefix, *capitals; /* of names in C: cart_pole, CART_POLE */
    const char *scene;
    const terminal *inputs, *outputs;
    int input_count, output_count;
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

/* Which inputs come in, and what becomes of them when they do not. */
static void emit_wires(const plant *p, const naming *names, text *out)
{
    const mechanism *m = p->m;
    text_add(out, "enum { WIRES = %d };\n\n", m->inputs.wire_count);
    if (m->inputs.wire_count == 0) {
        return;
    }
    text_add(out, "/* The inputs that come in, each with its safe value, and after how many ticks without a frame. */\n"
                  "static const iso_wire wires[WIRES] = {\n");
    for (int i = 0; i < m->inputs.wire_count; i++) {
        const wire *w = &m->inputs.wires[i];
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

static terminals terminals_of(const plant *p, arena *memory, uint64_t identity)
{
    const mechanism *m = p->m;
    terminal *inputs = arena_take(memory, (size_t)m->inputs.wire_count + 1, sizeof *inputs);
    terminal *outputs = arena_take(memory, (size_t)p->outputs.count + 1, sizeof *outputs);
    for (int i = 0; i < m->inputs.wire_count; i++) {
        const variable *v = &m->inputs.all[m->inputs.wires[i].input];
        inputs[i] = (terminal){v->name, v->unit, v->least, v->most};
    }
    for (int i = 0; i < p->outputs.count; i++) {
        outputs[i] = (terminal){p->outputs.names[i], p->outputs.units[i], -HUGE_VAL, HUGE_VAL};
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
                       .outputs = outputs,
                       .input_count = m->inputs.wire_count,
                       .output_count = p->outputs.count,
                       .identity = identity,
                       .period_ns = lround(m->method.step * 1e9),
                       .is_double = p->is_double};
}

/* A number of a range as C or Python has it; none is `infinity`. */
static const char *bound(arena *memory, double number, const char *infinity)
{
    return isinf(number) ? arena_format(memory, "%s%s", number < 0.0 ? "-" : "", infinity)
                         : arena_format(memory, "%.17g", number);
}

/* The places in a frame, and what is known of each: enum {CART_POLE_U_FORCE, ...}. */
static void emit_terminals(const terminals *t, char array, const char *what, const terminal *all, int count, text *out)
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
    text_add(out, "\n");
}

/* What a controller calls: @ is the prefix of its names, ~ the same in capitals. */
static const char calls[] =
    "/* The link: set u, then exchange, and read y. It stays where it was opened. */\n"
    "typedef struct @_link {\n"
    "    @_real u[~_INPUTS + 1], y[~_OUTPUTS + 1];\n"
    "    iso_client client; /* client.tick, client.problem, client.over, client.end */\n"
    "    uint8_t received[~_FRAME_BYTES], sent[~_FRAME_BYTES];\n"
    "} @_link;\n\n"
    "/* Connects with unix:PATH, tcp:HOST:PORT, fd:NUMBER or the path of a device; NULL: as ISOCHRON_LINK says. "
    "*/\n"
    "static inline bool @_open(@_link *link, const char *address)\n"
    "{\n"
    "    memset(link, 0, sizeof *link);\n"
    "    link->client.identity = ~_IDENTITY;\n"
    "    link->client.real_bytes = sizeof(@_real);\n"
    "    link->client.inputs = ~_INPUTS;\n"
    "    link->client.outputs = ~_OUTPUTS;\n"
    "    link->client.u = link->u;\n"
    "    link->client.y = link->y;\n"
    "    link->client.received = link->received;\n"
    "    link->client.sent = link->sent;\n"
    "    link->client.room = sizeof link->received;\n"
    "    link->client.patience_ms = ISO_CLIENT_PATIENCE_MS;\n"
    "    link->client.file = iso_client_connect(address);\n"
    "    return link->client.file >= 0 || iso_client_fail(&link->client, \"the link\", strerror(errno));\n"
    "}\n\n"
    "/* Starts a run of so many ticks, 0: until it is stopped; ISO_CLIENT_LOCKSTEP or ISO_CLIENT_FREE. y is that "
    "of tick 0. "
    "*/\n"
    "static inline bool @_start(@_link *link, int mode, uint64_t ticks)\n"
    "{\n"
    "    return iso_client_start(&link->client, mode, ticks);\n"
    "}\n\n"
    "/* Sends u, and waits for the next y; in a free run for the latest. False: the run is over, or there is a "
    "problem. */\n"
    "static inline bool @_exchange(@_link *link)\n"
    "{\n"
    "    return iso_client_exchange(&link->client);\n"
    "}\n\n"
    "/* Ends the run. */\n"
    "static inline bool @_stop(@_link *link)\n"
    "{\n"
    "    return iso_client_stop(&link->client);\n"
    "}\n\n"
    "/* Commands, between two ticks; client.state is then how the plant is. Runs for so many ticks, 0: without an "
    "end. "
    "*/\n"
    "static inline bool @_run(@_link *link, uint64_t ticks)\n"
    "{\n"
    "    return iso_client_do(&link->client, ISO_CLIENT_RUN, ticks, 8);\n"
    "}\n\n"
    "/* Rests. */\n"
    "static inline bool @_pause(@_link *link)\n"
    "{\n"
    "    return iso_client_do(&link->client, ISO_CLIENT_REST, 0, 0);\n"
    "}\n\n"
    "/* Asks how the plant is. */\n"
    "static inline bool @_state(@_link *link)\n"
    "{\n"
    "    return iso_client_do(&link->client, ISO_CLIENT_STATE, 0, 0);\n"
    "}\n\n"
    "/* Begins a run in the mode of the last, also after the guard; the plant rests at tick 0. */\n"
    "static inline bool @_reset(@_link *link)\n"
    "{\n"
    "    return iso_client_move(&link->client, ISO_CLIENT_RESET, 0, 0);\n"
    "}\n\n"
    "/* Takes a snapshot of the plant into record[room]. Returns its bytes; 0: there is a problem. */\n"
    "static inline size_t @_snapshot(@_link *link, void *record, size_t room)\n"
    "{\n"
    "    return iso_client_snapshot(&link->client, record, room);\n"
    "}\n\n"
    "/* Puts the plant to a snapshot of any plant of its kind, on any target; it rests there. */\n"
    "static inline bool @_restore(@_link *link, const void *record, size_t bytes)\n"
    "{\n"
    "    return iso_client_restore(&link->client, record, bytes);\n"
    "}\n\n"
    "static inline void @_close(@_link *link)\n"
    "{\n"
    "    (void)close(link->client.file);\n"
    "}\n";

/* Calls of the client, for the plant's own struct. */
static void emit_calls(const terminals *t, text *out)
{
    for (const char *c = calls; *c != '\0'; c++) {
        if (*c == '@' || *c == '~') {
            text_add(out, "%s", *c == '@' ? t->prefix : t->capitals);
        } else {
            text_add(out, "%c", *c);
        }
    }
}

static void emit_client_header(const terminals *t, text *out)
{
    text_add(out, "/* A controller's end of the link to the plant of %s.scene. Made by isoc. In SI units. */\n",
             t->scene);
    text_add(out, "%s\n", embedded_text(client_files, "tools/client/client.h"));
    text_add(out, "#ifndef %s_LINK_H\n#define %s_LINK_H\n\n#include <math.h>\n\n", t->capitals, t->capitals);
    text_add(out, "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    text_add(out, "typedef %s %s_real;\n", t->is_double ? "double" : "float", t->prefix);
    text_add(out, "#define %s_IDENTITY UINT64_C(0x%016" PRIx64 ")\n", t->capitals, t->identity);
    text_add(out, "#define %s_PERIOD_NS %ld\n\n", t->capitals, t->period_ns);
    text_add(out, "/* Inputs u: place, name, unit and range. */\n");
    emit_terminals(t, 'U', "inputs", t->inputs, t->input_count, out);
    text_add(out, "/* Outputs y. */\n");
    emit_terminals(t, 'Y', "outputs", t->outputs, t->output_count, out);
    text_add(out, "/* Room for every frame: a tick with reals, or how a run went. */\n");
    text_add(out,
             "enum {\n    %s_FRAME_BYTES =\n        ISO_CLIENT_ROOM(8 + sizeof(iso_client_end) + (%s_INPUTS + "
             "%s_OUTPUTS) * sizeof(%s_real))\n};\n\n",
             t->capitals, t->capitals, t->capitals, t->prefix);
    emit_calls(t, out);
    text_add(out, "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
}

static void emit_dictionary(const char *called, const terminal *all, int count, text *out)
{
    text_add(out, "%s = {\n", called);
    for (int i = 0; i < count; i++) {
        text_add(out, "    \"%s\": (\"%s\", %s, %s),\n", all[i].name, all[i].unit,
                 bound(out->memory, all[i].least, "float(\"inf\")"), bound(out->memory, all[i].most, "float(\"inf\")"));
    }
    text_add(out, "}\n");
}

static void emit_client_module(const terminals *t, text *out)
{
    text_add(out, "# A controller's end of the link to the plant of %s.scene. Made by isoc. In SI units.\n", t->scene);
    text_add(out, "IDENTITY = 0x%016" PRIx64 "\nPERIOD_NS = %ld\nREAL = \"%s\"\n", t->identity, t->period_ns,
             t->is_double ? "d" : "f");
    text_add(out, "# Unit, least and most of each.\n");
    emit_dictionary("INPUTS", t->inputs, t->input_count, out);
    emit_dictionary("OUTPUTS", t->outputs, t->output_count, out);
    text_add(out, "\n%s", embedded_text(client_files, "tools/client/client.py"));
}

bool link_fits(const plant *p, const char *path)
{
    /* As core/link/frame.h counts them: a tick, the reals, type and CRC; in COBS, between two zeros. */
    enum { CHANNEL_BYTES = 2048, TICK_BYTES = 8, FRAMING_BYTES = 3, COBS_BLOCK = 254, ENDS = 3 };
    const bool is_in = p->m->inputs.wire_count > p->outputs.count;
    const int reals = is_in ? p->m->inputs.wire_count : p->outputs.count;
    const int bytes = TICK_BYTES + reals * (p->is_double ? 8 : 4) + FRAMING_BYTES;
    const int frame = bytes + bytes / COBS_BLOCK + ENDS;
    if (frame > CHANNEL_BYTES) {
        fprintf(
            stderr,
            "%s: error: a frame of its %d %s has %d bytes, and a channel takes %d at once; leave some of them out%s\n",
            path, reals, is_in ? "inputs" : "outputs", frame, CHANNEL_BYTES, is_in ? "" : ", or read them over XCP");
    }
    return frame <= CHANNEL_BYTES;
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
    const terminals t = terminals_of(p, memory, identity);
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
}
