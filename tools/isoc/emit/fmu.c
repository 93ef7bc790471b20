#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "tools/isoc/base/embedded.h"
#include "tools/isoc/emit/parts.h"
#include "tools/isoc/scene/unit.h"

/* What the description and the model of an FMU are written from. */
typedef struct fmu {
    const plant *p;
    const naming *names;
    arena *memory;
    const char *identity; /* 16 digits */
} fmu;

/* The quantities of an array, as variables; their references follow each other. */
typedef struct variables {
    const char *folder; /* before a name that an output has too */
    const char *traits; /* attributes */
    const variable *all;
    int count;
    bool has_start, has_range;
} variables;

/* --- XML --------------------------------------------------------------------------------------------------------- */

/* A text as the value of an attribute. */
static const char *escaped(arena *memory, const char *words)
{
    text out = {.memory = memory};
    text_add(&out, "%s", "");
    for (const char *c = words; *c != '\0'; c++) {
        const char *entity = *c == '&'   ? "&amp;"
                             : *c == '<' ? "&lt;"
                             : *c == '>' ? "&gt;"
                             : *c == '"' ? "&quot;"
                                         : NULL;
        if (entity != NULL) {
            text_add(&out, "%s", entity);
        } else {
            text_add(&out, "%c", *c == '\t' ? ' ' : *c);
        }
    }
    return out.bytes;
}

/* A number that reads back as that of the plant. */
static const char *xml_number(const fmu *f, double value)
{
    return arena_format(f->memory, "%.17g", f->p->is_double ? value : (double)(float)value);
}

/* --- units ------------------------------------------------------------------------------------------------------- */

/* The dimension of a unit in words: N*m/rad^2. False where a part of it is no unit of isoc. */
static bool read_unit(arena *memory, const char *words, dimension *found)
{
    int sign = 1;
    *found = (dimension){0};
    for (const char *at = words; *at != '\0';) {
        const size_t length = strcspn(at, "*/^");
        int power = 1;
        unit part = unit_one;
        const char *word = arena_copy(memory, at, length);
        if (strcmp(word, "1") != 0 && !unit_find(word, &part)) {
            return false;
        }
        at += length;
        if (*at == '^') {
            const bool is_negative = at[1] == '-';
            power = at[is_negative ? 2 : 1] - '0';
            power = is_negative ? -power : power;
            at += is_negative ? 3 : 2;
        }
        if (!dimension_times(found, part.of, sign * power)) {
            return false;
        }
        sign = *at == '/' ? -1 : 1;
        at += *at == '\0' ? 0 : 1;
    }
    return true;
}

/* The units in which people read one of the SI, and whether a number is shown in them where nothing else is asked. */
static const struct {
    const char *unit, *shown, *factor;
    bool is_default;
} display_units[] = {
    {"rad", "deg", "57.295779513082323", true},
    {"rad", "rev", "0.15915494309189535", false},
    {"rad/s", "deg/s", "57.295779513082323", true},
    {"rad/s", "rpm", "9.5492965855137201", false},
    {"rad/s^2", "deg/s^2", "57.295779513082323", true},
    {"m", "mm", "1000", false},
    {"m/s", "km/h", "3.6", false},
};

static const char *shown_in(const char *unit_words)
{
    for (size_t i = 0; i < sizeof display_units / sizeof display_units[0]; i++) {
        if (display_units[i].is_default && strcmp(display_units[i].unit, unit_words) == 0) {
            return display_units[i].shown;
        }
    }
    return NULL;
}

static void add_exponent_of(text *out, const char *base, int exponent)
{
    if (exponent != 0) {
        text_add(out, " %s=\"%d\"", base, exponent);
    }
}

static void add_unit(const fmu *f, const char *words, text *out)
{
    dimension of;
    text_add(out, "    <Unit name=\"%s\">\n", words);
    if (read_unit(f->memory, words, &of) && of.root_s == 0) {
        text_add(out, "      <BaseUnit");
        add_exponent_of(out, "kg", of.kg);
        add_exponent_of(out, "m", of.m);
        add_exponent_of(out, "s", of.s);
        add_exponent_of(out, "A", of.A);
        add_exponent_of(out, "K", of.K);
        add_exponent_of(out, "rad", of.rad);
        text_add(out, "/>\n");
    }
    for (size_t i = 0; i < sizeof display_units / sizeof display_units[0]; i++) {
        if (strcmp(display_units[i].unit, words) == 0) {
            text_add(out, "      <DisplayUnit name=\"%s\" factor=\"%s\"/>\n", display_units[i].shown,
                     display_units[i].factor);
        }
    }
    text_add(out, "    </Unit>\n");
}

/* Each unit once; a pure number has none. */
static void add_units(const fmu *f, const variables *groups, int group_count, text *out)
{
    text known = {.memory = f->memory};
    text_add(&known, "\ns\n"); /* units have spaces: m or rad */
    text_add(out, "  <UnitDefinitions>\n");
    add_unit(f, "s", out);
    for (int k = 0; k < group_count; k++) {
        for (int i = 0; i < groups[k].count; i++) {
            const char *unit = groups[k].all[i].unit;
            if (strcmp(unit, "1") != 0 && strstr(known.bytes, arena_format(f->memory, "\n%s\n", unit)) == NULL) {
                text_add(&known, "%s\n", unit);
                add_unit(f, unit, out);
            }
        }
    }
    text_add(out, "  </UnitDefinitions>\n");
}

/* --- variables --------------------------------------------------------------------------------------------------- */

static bool is_output(const fmu *f, const char *name)
{
    bool any = false;
    for (int i = 0; i < f->p->outputs.count; i++) {
        any = any || strcmp(f->p->outputs.names[i], name) == 0;
    }
    return any;
}

/* States, and what an output is called like, have their folder before the name. */
static const char *name_of(const fmu *f, const variables *group, const variable *v)
{
    const bool is_bare = group->folder[0] == '\0' || (strcmp(group->folder, "states") != 0 && !is_output(f, v->name));
    return is_bare ? v->name : arena_format(f->memory, "%s.%s", group->folder, v->name);
}

static const char *description_of(const fmu *f, const variable *v)
{
    const char *quote = v->quote == NULL ? "" : v->quote;
    return escaped(f->memory, v->display_name == NULL ? quote : arena_format(f->memory, "fault %s", v->display_name));
}

static void add_variable(const fmu *f, const variables *group, int i, int reference, text *out)
{
    const variable *v = &group->all[i];
    const char *shown = shown_in(v->unit), *what = description_of(f, v);
    const bool is_driven = group->all == f->p->m->inputs.all && f->p->m->inputs.driven[i];
    const char *traits = is_driven ? "causality=\"local\" variability=\"discrete\"" : group->traits;
    text_add(out, "    <Float64 name=\"%s\" valueReference=\"%d\" %s", name_of(f, group, v), reference, traits);
    if (strcmp(v->unit, "1") != 0) {
        text_add(out, " unit=\"%s\"", v->unit);
    }
    if (shown != NULL) {
        text_add(out, " displayUnit=\"%s\"", shown);
    }
    if (group->has_range && !isinf(v->least)) {
        text_add(out, " min=\"%s\"", xml_number(f, v->least));
    }
    if (group->has_range && !isinf(v->most)) {
        text_add(out, " max=\"%s\"", xml_number(f, v->most));
    }
    if (group->has_start && !is_driven) {
        text_add(out, " start=\"%s\"", xml_number(f, v->start));
    }
    if (what[0] != '\0') {
        text_add(out, " description=\"%s\"", what);
    }
    text_add(out, "/>\n");
}

/* --- modelDescription.xml ---------------------------------------------------------------------------------------- */

static const char *step_of(const fmu *f)
{
    const char *step = code_literal(f->memory, f->p->m->method.step, true); /* R(0.001) */
    return arena_copy(f->memory, step + 2, strlen(step) - 3);
}

/* The variables of all arrays; what the outputs depend on is left to their reader: on all that there is. */
static void add_description(const fmu *f, text *out)
{
    const mechanism *m = f->p->m;
    const variables groups[] = {
        {"inputs", "causality=\"input\" variability=\"continuous\"", m->inputs.all, m->inputs.count, true, true},
        {"tunables", "causality=\"parameter\" variability=\"tunable\" initial=\"exact\"", m->parameters.all,
         m->parameters.count, true, true},
        {"", "causality=\"output\" variability=\"continuous\" initial=\"calculated\"", f->names->about_outputs,
         f->p->outputs.count, false, false},
        {"states", "causality=\"local\" variability=\"continuous\" initial=\"exact\"", f->names->about_states,
         state_count(m), true, false},
    };
    const int group_count = sizeof groups / sizeof groups[0];
    text units = {.memory = f->memory}, all = units, structure = units;
    int reference = 1;
    add_units(f, groups, group_count, &units);
    text_add(&structure, "%s", "");
    for (int k = 0; k < group_count; k++) {
        for (int i = 0; i < groups[k].count; i++, reference++) {
            add_variable(f, &groups[k], i, reference, &all);
            if (groups[k].all == f->names->about_outputs) {
                text_add(&structure, "    <Output valueReference=\"%d\"/>\n", reference);
            }
        }
    }
    for (int i = 0; i < f->p->outputs.count; i++) {
        text_add(&structure, "    <InitialUnknown valueReference=\"%d\"/>\n",
                 1 + m->inputs.count + m->parameters.count + i);
    }
    text_fill(out, embedded_text(client_files, "tools/fmu/modelDescription.xml.in"),
              (const filling[]){{"scene", m->name},
                                {"name", f->names->prefix},
                                {"token", f->identity},
                                {"method", method_names[ISO_METHOD_OF(m->method.recipe)]},
                                {"step", step_of(f)},
                                {"units", units.bytes},
                                {"variables", all.bytes},
                                {"hash", arena_format(f->memory, "%d", reference + state_count(m))},
                                {"structure", structure.bytes},
                                {NULL, NULL}});
}

/* --- the model in C ---------------------------------------------------------------------------------------------- */

static const char *decimal(arena *memory, long value)
{
    return arena_format(memory, "%ld", value);
}

static const char *table_or_null(const fmu *f, int count, const char *what)
{
    return count == 0 ? "NULL" : arena_format(f->memory, "%s_%s", f->names->prefix, what);
}

static void add_model(const fmu *f, text *out)
{
    const mechanism *m = f->p->m;
    text driven = {.memory = f->memory};
    for (int i = 0; i < m->inputs.count; i++) {
        text_add(&driven, "%s, ", m->inputs.driven[i] ? "true" : "false");
    }
    text_add(&driven, "false");
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

void emit_fmu(const plant *p, const naming *names, file_list *files)
{
    static const char *const fixed[][2] = {
        {"fmu_instance.h", "tools/fmu/instance.h.in"},
        {"fmu_record.h", "tools/fmu/record.h.in"},
        {"fmi3.h", "tools/fmu/fmi3.h.in"},
        {"fmi3.c", "tools/fmu/fmi3.c.in"},
    };
    arena *memory = files->memory;
    const fmu f = {p, names, memory, arena_format(memory, "%016" PRIx64, identity_of_files(files))};
    text model = {.memory = memory}, description = model, build = model;
    add_model(&f, &model);
    file_list_add(files, "fmu_model.h", &model);
    for (size_t i = 0; i < sizeof fixed / sizeof fixed[0]; i++) {
        text copy = {.memory = memory};
        text_add(&copy, "%s", embedded_text(client_files, fixed[i][1]));
        file_list_add(files, fixed[i][0], &copy);
    }
    add_description(&f, &description);
    file_list_add(files, "modelDescription.xml", &description);
    text_fill(&build, embedded_text(client_files, "tools/fmu/buildDescription.xml.in"),
              (const filling[]){{"name", names->prefix}, {NULL, NULL}});
    file_list_add(files, "buildDescription.xml", &build);
}
