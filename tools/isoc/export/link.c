#include "tools/isoc/export/terminals.h"

#include <stdio.h>

#include "core/link/frame.h"
#include "core/wire/protocol.h"
#include "port/channel.h"
#include "tools/isoc/base/embedded.h"

/* --- interface.c ------------------------------------------------------------------------------------------------- */

static void emit_interface(const plant *p, const naming *names, const char *identity, const char *lock, text *out)
{
    const char *capitals = names->capitals;
    const bool any = p->m->inputs.wire_count > 0;
    text_add(out, "/* What the plant of %s.scene shows at its link. Made by isoc. */\n", p->m->name);
    text_add(out, "#include \"%s.h\"\n\n#include \"core/link/link.h\"\n%s\n", names->prefix,
             lock == NULL ? "" : "#include \"core/xcp/service.h\"\n");
    emit_wires(p, names, out);
    if (lock != NULL) {
        emit_calibration(p, names, lock, identity, out);
    }
    text_add(out, "static uint8_t received[ISO_LINK_BYTES(WIRES, %s_OUTPUTS)], sent[sizeof received];\n", capitals);
    text_add(out, "_Static_assert(sizeof received <= ISO_CHANNEL_BYTES, \"a channel takes a frame at once\");\n");
    text_add(out, "static unsigned char snapshot[ISO_SNAPSHOT_BYTES(sizeof(%s_memory))];\n\n", names->prefix);
    text_add(out, "const iso_interface iso_the_interface = {\n    .identity = UINT64_C(0x%s),\n", identity);
    text_add(out, "%s", any ? "    .wires = wires,\n    .wire_count = WIRES,\n    .values = values,\n" : "");
    text_add(out, "%s", lock == NULL ? "" : "    .services = services,\n    .service_count = 1,\n");
    text_add(out, "    .received = received,\n    .sent = sent,\n    .frame_bytes = sizeof received,\n"
                  "    .snapshot = snapshot,\n    .snapshot_bytes = sizeof snapshot,\n};\n");
}

/* --- The controller's end ---------------------------------------------------------------------------------------- */

/* The places in a frame, with name, unit and comment of each: enum {CART_POLE_U_FORCE, ...}. */
static void emit_terminals(const terminals *t, char array, const char *what, const quantities *content, text *out)
{
    text_add(out, "enum {\n");
    FOR_ALL (const variable, v, content->all, content->count) {
        text_add(out, "    %s_%c_%s, /* %s */\n", t->capitals, array, capitals_of(out->memory, v->name), v->unit);
    }
    text_add(out, "    %s_%s\n};\n", t->capitals, capitals_of(out->memory, what));
    if (content->count > 0) {
        text_add(out, "static const iso_client_quantity %s_%s[%s_%s] = {\n", t->prefix, what, t->capitals,
                 capitals_of(out->memory, what));
        FOR_ALL (const variable, v, content->all, content->count) {
            text_add(out, "    {\"%s\", \"%s\", %s, %s},\n", v->name, v->unit, bound(out->memory, v->least, "HUGE_VAL"),
                     bound(out->memory, v->most, "HUGE_VAL"));
        }
        text_add(out, "};\n");
    }
}

/* The inputs that do not begin with 0. */
static const char *starts_in_c(const terminals *t, arena *memory)
{
    text lines = empty_text(memory);
    FOR_ALL (const variable, v, t->inputs.all, t->inputs.count) {
        if (v->start != 0.0) {
            text_add(&lines, "    link->u[%s_U_%s] = (%s_real)%.17g;\n", t->capitals, capitals_of(memory, v->name),
                     t->prefix, v->start);
        }
    }
    return lines.bytes;
}

static void emit_client_header(const terminals *t, file_list *files)
{
    arena *memory = files->memory;
    text inputs = {.memory = memory}, outputs = inputs, tunables = inputs;
    emit_terminals(t, 'U', "inputs", &t->inputs, &inputs);
    emit_terminals(t, 'Y', "outputs", &t->outputs, &outputs);
    emit_terminals(t, 'P', "tunables", &t->tunables, &tunables);
    file_list_fill(files, arena_format(memory, "%s_link.h", t->prefix), "tools/client/link.h.in",
                   (const filling[]){{"scene", t->scene},
                                     {"tables", protocol_in_c(memory)},
                                     {"inside", embedded_text(client_files, "tools/client/inside.h")},
                                     {"client", embedded_text(client_files, "tools/client/client.h")},
                                     {"commands", embedded_text(client_files, "tools/client/commands.h")},
                                     {"process", embedded_text(client_files, "tools/client/process.h")},
                                     {"keep", embedded_text(client_files, "tools/client/keep.h")},
                                     {"prefix", t->prefix},
                                     {"PREFIX", t->capitals},
                                     {"real", t->is_double ? "double" : "float"},
                                     {"identity", arena_format(memory, "0x%s", t->identity)},
                                     {"period_ns", arena_format(memory, "%ld", t->period_ns)},
                                     {"inputs", inputs.bytes},
                                     {"starts", starts_in_c(t, memory)},
                                     {"outputs", outputs.bytes},
                                     {"tunables", tunables.bytes},
                                     {NULL, NULL}});
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
    text interface = {.memory = files->memory};
    const terminals t = terminals_of(p, names, files);
    emit_interface(p, names, t.identity, lock, &interface);
    file_list_add(files, "interface.c", &interface);
    if (lock != NULL) {
        emit_a2l(p, names, t.identity, files);
    }
    emit_client_header(&t, files);
    add_python_of_link(&t, files);
}
