#include "tools/isoc/export/fmu.h"

#include <string.h>

static const char *decimal(const fmu *f, long number)
{
    return arena_format(f->memory, "%ld", number);
}

static const char *table_or_null(const fmu *f, int count, const char *what)
{
    return count == 0 ? "NULL" : arena_format(f->memory, "%s_%s", f->names->prefix, what);
}

const char *fmu_kinds(const fmu *f)
{
    text kinds = empty_text(f->memory);
    int parts = 0;
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

void fmu_add_model(const fmu *f, file_list *files)
{
    const mechanism *m = f->p->m;
    text driven = {.memory = f->memory}, smooth = driven, starts = driven;
    for (int i = 0; i < m->inputs.count; i++) {
        text_add(&driven, "%s, ", m->inputs.driven[i] ? "true" : "false");
        text_add(&smooth, "%s, ", m->inputs.driven[i] && m->inputs.smooth[i] ? "true" : "false");
        text_add(&starts, "%s, ", code_literal(f->memory, m->inputs.all[i].start, f->p->is_double));
    }
    text_add(&driven, "false");
    text_add(&smooth, "false");
    text_add(&starts, "%s", code_literal(f->memory, 0.0, f->p->is_double));
    const bool changes = strstr(driven.bytes, "true") != NULL || m->parameters.change_count > 0;
    file_list_fill(files, "fmu_model.h", "tools/fmu/model.h.in",
                   (const filling[]){{"scene", m->name},
                                     {"name", f->names->prefix},
                                     {"token", f->identity},
                                     {"identity", f->identity},
                                     {"period_ns", decimal(f, period_of(f->p))},
                                     {"states", decimal(f, state_count(m))},
                                     {"inputs", decimal(f, m->inputs.count)},
                                     {"parameters", decimal(f, m->parameters.count)},
                                     {"outputs", decimal(f, f->p->outputs.count)},
                                     {"input table", table_or_null(f, m->inputs.count, "inputs")},
                                     {"parameter table", table_or_null(f, m->parameters.count, "parameters")},
                                     {"driven", driven.bytes},
                                     {"smooth", smooth.bytes},
                                     {"values", starts.bytes},
                                     {"kinds", fmu_kinds(f)},
                                     {"timed", changes ? "true" : "false"},
                                     {"exchanges", f->exchanges ? "true" : "false"},
                                     {"before", ISO_IS_WATCHED(m->method.recipe) ? ", before" : ""},
                                     {NULL, NULL}});
}

const char *fmu_sources(const fmu *f, const char *line)
{
    static const char *const fixed[] = {"fmu_slopes.c", "core/numbers/self_check.c"};
    text lines = {.memory = f->memory};
    text_add(&lines, line, arena_format(f->memory, "%s.c", f->names->prefix));
    text_add(&lines, line, f->version == 3 ? "fmi3.c" : "fmi2.c");
    for (size_t i = 0; i < COUNT_OF(fixed); i++) {
        text_add(&lines, line, fixed[i]);
    }
    return lines.bytes;
}
