#include "tools/isoc/export/terminals.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

/* The sizes of core/xcp that the A2L contains; the program that has both asserts them. */
enum { MAX_CTO = 64, MAX_DTO = 256, LISTS = 4, BLOCK_BYTES = 255 };

/* A duration of `count` times 10^unit ns. */
typedef struct duration {
    int unit;
    long count;
} duration;

/* The finest unit in which a duration is at most so many; exact, if in that one it is a whole number. */
static duration duration_of(long ns, long most)
{
    long size = 1;
    int exponent = 0;
    while ((ns + size / 2) / size > most) {
        size *= 10;
        exponent++;
    }
    return (duration){exponent, (ns + size / 2) / size};
}

/* A step as the cycle of an event, in the coarsest unit that changes nothing. */
static duration cycle_of(const plant *p)
{
    duration d = duration_of(period_of(p), UINT8_MAX);
    while (d.count % 10 == 0) {
        d.count /= 10;
        d.unit++;
    }
    return d;
}

/* A step as a count of the clock. */
static duration stamp_of(const plant *p)
{
    return duration_of(period_of(p), UINT16_MAX);
}

/* --- interface.c ------------------------------------------------------------------------------------------------- */

void emit_calibration(const plant *p, const naming *names, const char *lock, const char *identity, text *out)
{
    const mechanism *m = p->m;
    emission e = {.p = p, .names = names, .out = out};
    const bool is_open = strcmp(lock, "open") == 0, any = has_limits(&names->p);
    const duration stamp = stamp_of(p), cycle = cycle_of(p);
    text_add(out,
             "_Static_assert(ISO_XCP_MAX_CTO == %d && ISO_XCP_MAX_DTO == %d && ISO_XCP_LISTS == %d && "
             "ISO_XCP_BLOCK_BYTES == %d,\n               \"the A2L tells these sizes\");\n\n",
             MAX_CTO, MAX_DTO, LISTS, BLOCK_BYTES);
    emit_limits(&e, "parameter_limits", "PARAMETERS", &names->p);
    text_add(out, "%s%s%s", is_open ? "" : "extern const iso_xcp_lock ", is_open ? "" : lock, is_open ? "" : ";\n\n");
    text_add(out, "const char iso_xcp_the_epk[] = \"%s\";\n\n", identity);
    text_add(out, "const iso_xcp_description iso_xcp_the_description = {\n    .name = \"%s\",\n", m->name);
    text_add(out, "    .epk = iso_xcp_the_epk,\n%s", any ? "    .limits = parameter_limits,\n" : "");
    text_add(out, "%s%s%s", is_open ? "" : "    .lock = &", is_open ? "" : lock, is_open ? "" : ",\n");
    text_add(out, "    .stamp = {%d, %ld},\n    .cycle = {%d, %ld},\n};\n\n", stamp.unit, stamp.count, cycle.unit,
             cycle.count);
    text_add(out, "static const iso_service *const services[] = {&iso_xcp_service};\n\n");
}

/* --- The A2L ----------------------------------------------------------------------------------------------------- */

/* The quantities of an array, as the A2L has them. */
typedef struct section {
    const char *group, *about;
    char array;
    const quantities *content;
    int first; /* the place of the first in its array */
    bool is_tunable;
    const char *access; /* the text of the A2L behind their address: a master may stimulate inputs */
} section;

/* The units, each once, and their entries in the A2L: COMPU_METHOD unit_1 is that of the first. */
typedef struct units {
    const char **all;
    size_t count;
    text methods;
} units;

static size_t unit_number(units *u, const char *word)
{
    const size_t i = index_of_word(word, u->all, u->count);
    if (i == u->count) {
        u->all[u->count++] = word;
        text_add(&u->methods,
                 "    /begin COMPU_METHOD unit_%zu \"\" IDENTICAL \"%%12.6\" \"%s\"\n    /end COMPU_METHOD\n", u->count,
                 word);
    }
    return i + 1;
}

/* A limit; where there is none, the largest number of the type. */
static const char *limit_of_type(arena *memory, const plant *p, double x)
{
    const char *const most = p->is_double ? "1.7976931348623157e+308" : "3.4028234663852886e+38";
    return isinf(x) ? arena_format(memory, "%s%s", x < 0.0 ? "-" : "", most) : arena_format(memory, "%.15g", x);
}

static const char *type_of_reals(const plant *p)
{
    return p->is_double ? "FLOAT64_IEEE" : "FLOAT32_IEEE";
}

static const char *about(arena *memory, const section *s, const variable *v)
{
    return v->display_name != NULL ? arena_format(memory, "fault %s", v->display_name) : s->about;
}

static void emit_quantity(const emission *e, const section *s, int i, units *u)
{
    const variable *v = &s->content->all[i];
    text *out = e->out;
    const size_t offset =
        memory_place(e, s->array) + (size_t)(s->first + i) * (e->p->is_double ? sizeof(double) : sizeof(float));
    const char *least = limit_of_type(out->memory, e->p, v->least), *most = limit_of_type(out->memory, e->p, v->most);
    const size_t number = unit_number(u, v->unit);
    if (s->is_tunable) {
        text_add(out,
                 "    /begin CHARACTERISTIC %c.%s \"%s\" VALUE @memory+%zu@ real 0 unit_%zu %s %s\n    /end "
                 "CHARACTERISTIC\n",
                 s->array, v->name, about(out->memory, s, v), offset, number, least, most);
    } else {
        text_add(out,
                 "    /begin MEASUREMENT %c.%s \"%s\" %s unit_%zu 0 0 %s %s\n      ECU_ADDRESS @memory+%zu@\n%s"
                 "      /begin IF_DATA XCP /begin DAQ_EVENT FIXED_EVENT_LIST EVENT 0 /end DAQ_EVENT /end IF_DATA\n"
                 "    /end MEASUREMENT\n",
                 s->array, v->name, about(out->memory, s, v), type_of_reals(e->p), number, least, most, offset,
                 s->access);
    }
}

static void emit_group(text *out, const section *s)
{
    const char *refers = s->is_tunable ? "REF_CHARACTERISTIC" : "REF_MEASUREMENT";
    text_add(out, "    /begin GROUP %s \"%s\"\n      ROOT\n      /begin %s\n", s->group, s->group, refers);
    FOR_ALL (const variable, v, s->content->all, s->content->count) {
        text_add(out, "        %c.%s\n", s->array, v->name);
    }
    text_add(out, "      /end %s\n    /end GROUP\n", refers);
}

/* The words by which inputs can be stimulated, each as a whole. */
static const char *stimulation_words(const plant *p)
{
    return p->m->inputs.count == 0 ? ""
           : p->is_double          ? "        /begin STIM GRANULARITY_ODT_ENTRY_SIZE_STIM_DLONG 8 /end STIM\n"
                                   : "        /begin STIM GRANULARITY_ODT_ENTRY_SIZE_STIM_DWORD 4 /end STIM\n";
}

void emit_a2l(const plant *p, const naming *names, const char *identity, file_list *files)
{
    static const char *const units_of_time[] = {"1NS",   "10NS", "100NS", "1US",   "10US",
                                                "100US", "1MS",  "10MS",  "100MS", "1S"};
    const mechanism *m = p->m;
    arena *memory = files->memory;
    text all = {.memory = memory}, groups = all;
    const emission e = {.p = p, .names = names, .out = &all};
    const char *called = isalpha((unsigned char)m->name[0]) ? m->name : arena_format(memory, "plant_%s", m->name);
    const section sections[] = {
        {"states", "state", 'x', &names->x, 0, false, ""},
        {"inputs", "input", 'u', &names->u, 0, false, "      READ_WRITE\n"},
        {"memories", "memory of an effect", 'u', &names->memories, m->inputs.count, false, ""},
        {"tunables", "tunable", 'p', &names->p, 0, true, ""},
        {"outputs", "output", 'y', &names->y, 0, false, ""},
    };
    const int count = state_count(m) + held_count(m) + m->parameters.count + p->outputs.count;
    units u = {.all = arena_take(memory, (size_t)count, sizeof *u.all), .methods = {.memory = memory}};
    for (size_t k = 0; k < COUNT_OF(sections); k++) {
        for (int i = 0; i < sections[k].content->count; i++) {
            emit_quantity(&e, &sections[k], i, &u);
        }
        if (sections[k].content->count > 0) {
            emit_group(&groups, &sections[k]);
        }
    }
    const duration stamp = stamp_of(p), cycle = cycle_of(p);
    file_list_fill(files, "plant.a2l.in", "tools/client/plant.a2l.in",
                   (const filling[]){{"module", called},
                                     {"scene", m->name},
                                     {"identity", identity},
                                     {"type", type_of_reals(p)},
                                     {"most of a command", arena_format(memory, "%d", MAX_CTO)},
                                     {"most of a sample", arena_format(memory, "%d", MAX_DTO)},
                                     {"lists", arena_format(memory, "%d", LISTS)},
                                     {"stimulation", stimulation_words(p)},
                                     {"direction", m->inputs.count > 0 ? "DAQ_STIM" : "DAQ"},
                                     {"stamp", arena_format(memory, "%ld SIZE_DWORD UNIT_%s", stamp.count,
                                                            units_of_time[stamp.unit])},
                                     {"cycle", arena_format(memory, "%ld %d", cycle.count, cycle.unit)},
                                     {"quantities", all.bytes},
                                     {"units", u.methods.bytes},
                                     {"groups", groups.bytes},
                                     {NULL, NULL}});
}
