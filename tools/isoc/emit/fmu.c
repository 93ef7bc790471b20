#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "tools/isoc/base/embedded.h"
#include "tools/isoc/emit/fmu.h"

/* --- the model in C ---------------------------------------------------------------------------------------------- */

static const char *decimal(arena *memory, long number)
{
    return arena_format(memory, "%ld", number);
}

static const char *table_or_null(const fmu *f, int count, const char *what)
{
    return count == 0 ? "NULL" : arena_format(f->memory, "%s_%s", f->names->prefix, what);
}

const char *fmu_kinds(const fmu *f)
{
    text kinds = {.memory = f->memory};
    int parts = 0;
    text_add(&kinds, "%s", "");
    for (int i = 0; i < state_count(f->p->m); i++) {
        const state_kind kind = f->names->states[i].kind;
        parts = kind == STATE_QUATERNION ? parts + 1 : 0;
        text_add(&kinds, "%s%s", i == 0 ? "" : ", ",
                 kind == STATE_TURN                           ? "FMU_TURN"
                 : kind == STATE_QUATERNION && parts % 4 == 1 ? "FMU_QUATERNION"
                                                              : "FMU_PLAIN");
    }
    return kinds.bytes;
}

static void add_model(const fmu *f, text *out)
{
    const mechanism *m = f->p->m;
    text driven = {.memory = f->memory};
    for (int i = 0; i < m->inputs.count; i++) {
        text_add(&driven, "%s, ", m->inputs.driven[i] ? "true" : "false");
    }
    text_add(&driven, "false");
    const bool changes = strstr(driven.bytes, "true") != NULL || m->parameters.change_count > 0;
    text_fill(out, embedded_text(client_files, "tools/fmu/model.h.in"),
              (const filling[]){{"scene", m->name},
                                {"name", f->names->prefix},
                                {"token", f->identity},
                                {"identity", f->identity},
                                {"period_ns", decimal(f->memory, lround(m->method.step * 1e9))},
                                {"states", decimal(f->memory, state_count(m))},
                                {"inputs", decimal(f->memory, m->inputs.count)},
                                {"parameters", decimal(f->memory, m->parameters.count)},
                                {"outputs", decimal(f->memory, f->p->outputs.count)},
                                {"input table", table_or_null(f, m->inputs.count, "inputs")},
                                {"parameter table", table_or_null(f, m->parameters.count, "parameters")},
                                {"driven", driven.bytes},
                                {"kinds", fmu_kinds(f)},
                                {"timed", changes ? "true" : "false"},
                                {"exchanges", f->exchanges ? "true" : "false"},
                                {"before", ISO_IS_WATCHED(m->method.recipe) ? ", before" : ""},
                                {NULL, NULL}});
}

/* FNV-1a in 64 bits over the texts of the plant. */
static uint64_t identity_of_files(const file_list *files)
{
    uint64_t hash = UINT64_C(0xCBF29CE484222325);
    for (size_t k = 0; k < files->count; k++) {
        const text *t = &files->files[k].text;
        for (size_t i = 0; i < t->length; i++) {
            hash = (hash ^ (uint8_t)t->bytes[i]) * UINT64_C(0x00000100000001B3);
        }
    }
    return hash;
}

const char *fmu_name(const plant *p, arena *memory)
{
    char *word = arena_copy(memory, p->m->name, strlen(p->m->name));
    for (char *c = word; *c != '\0'; c++) {
        *c = isalnum((unsigned char)*c) ? (char)tolower((unsigned char)*c) : '_';
    }
    return prefix_fault(word, memory) == NULL ? word : arena_format(memory, "plant_%s", word);
}

const char *fmu_sources(const fmu *f, const char *line)
{
    static const char *const fixed[] = {"fmu_slopes.c", "core/numbers/self_check.c", "core/runtime/snapshot.c"};
    text lines = {.memory = f->memory};
    text_add(&lines, line, arena_format(f->memory, "%s.c", f->names->prefix));
    text_add(&lines, line, f->version == 3 ? "fmi3.c" : "fmi2.c");
    for (size_t i = 0; i < sizeof fixed / sizeof fixed[0]; i++) {
        text_add(&lines, line, fixed[i]);
    }
    return lines.bytes;
}

void emit_fmu(const plant *p, const graph *g, const naming *names, int version, bool exchanges, file_list *files)
{
    static const char *const fixed[][2] = {{"fmu_instance.h", "tools/fmu/instance.h.in"},
                                           {"fmu_record.h", "tools/fmu/record.h.in"},
                                           {"fmu_exchange.h", "tools/fmu/exchange.h.in"}};
    static const char *const calls[][2] = {{"fmi2.h", "tools/fmu/fmi2.h.in"},
                                           {"fmi2.c", "tools/fmu/fmi2.c.in"},
                                           {"fmi3.h", "tools/fmu/fmi3.h.in"},
                                           {"fmi3.c", "tools/fmu/fmi3.c.in"}};
    arena *memory = files->memory;
    const fmu f = {p,       g,        names, memory, arena_format(memory, "%016" PRIx64, identity_of_files(files)),
                   version, exchanges};
    text model = {.memory = memory}, description = model, build = model;
    add_model(&f, &model);
    file_list_add(files, "fmu_model.h", &model);
    for (size_t i = 0; i < 5; i++) {
        const char *const *pair = i < 3 ? fixed[i] : calls[2 * (size_t)(version - 2) + i - 3];
        text copy = {.memory = memory};
        text_add(&copy, "%s", embedded_text(client_files, pair[1]));
        file_list_add(files, pair[0], &copy);
    }
    fmu_describe(&f, &description);
    file_list_add(files, "modelDescription.xml", &description);
    text_fill(&build, embedded_text(client_files, "tools/fmu/buildDescription.xml.in"),
              (const filling[]){{"name", names->prefix},
                                {"sources", fmu_sources(&f, "      <SourceFile name=\"%s\"/>\n")},
                                {"version", decimal(memory, version)},
                                {NULL, NULL}});
    file_list_add(files, "buildDescription.xml", &build);
}
