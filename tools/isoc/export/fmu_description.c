/* modelDescription.xml of an FMU. */
#include <math.h>
#include <string.h>

#include "tools/isoc/base/embedded.h"
#include "tools/isoc/export/fmu.h"
#include "tools/isoc/scene/parser.h"

/* The quantities of an array, as variables; their references follow each other. */
typedef struct variables {
    const char *folder; /* before a name that an output has too */
    const char *traits; /* attributes */
    const quantities *content;
    bool has_start, has_range;
    int rate_of; /* of derivatives, the reference of the first of their states; else 0 */
} variables;

/* --- XML --------------------------------------------------------------------------------------------------------- */

/* A text as the value of an attribute. */
static const char *escaped(arena *memory, const char *words)
{
    text out = empty_text(memory);
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

/* Adds an attribute; nothing where the words are NULL. */
static void add_attribute(text *out, const char *called, const char *words)
{
    if (words != NULL) {
        text_add(out, " %s=\"%s\"", called, words);
    }
}

/* A number that reads back as that of the plant. */
static const char *xml_number(const fmu *f, double number)
{
    return arena_format(f->memory, "%.17g", f->p->is_double ? number : (double)(float)number);
}

/* --- units ------------------------------------------------------------------------------------------------------- */

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
    for (size_t i = 0; i < COUNT_OF(display_units); i++) {
        if (display_units[i].is_default && strcmp(display_units[i].unit, unit_words) == 0) {
            return display_units[i].shown;
        }
    }
    return NULL;
}

static void add_unit(const fmu *f, const char *words, text *out)
{
    const dimension dim = unit_of_text(f->memory, words).dim; /* of a plain number where it is no unit of isoc */
    text_add(out, "    <Unit name=\"%s\">\n", words);
    if (!dimension_equal(dim, unit_one.dim) && dimension_is_whole(dim)) {
        static const char *const bases[] = {"kg", "m", "s", "A", "K", "rad"};
        const int exponents[] = {dim.kg / 2, dim.m / 2, dim.s / 2, dim.A / 2, dim.K / 2, dim.rad / 2};
        text_add(out, "      <BaseUnit");
        for (size_t i = 0; i < COUNT_OF(bases); i++) {
            add_attribute(out, bases[i], exponents[i] != 0 ? arena_format(f->memory, "%d", exponents[i]) : NULL);
        }
        text_add(out, "/>\n");
    }
    for (size_t i = 0; i < COUNT_OF(display_units); i++) {
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
        FOR_ALL (const variable, v, groups[k].content->all, groups[k].content->count) {
            if (strcmp(v->unit, "1") != 0 && strstr(known.bytes, arena_format(f->memory, "\n%s\n", v->unit)) == NULL) {
                text_add(&known, "%s\n", v->unit);
                add_unit(f, v->unit, out);
            }
        }
    }
    text_add(out, "  </UnitDefinitions>\n");
}

/* --- variables --------------------------------------------------------------------------------------------------- */

/* States, and quantities with the name of an output, have their folder before the name. */
static const char *name_of(const fmu *f, const variables *group, const variable *v)
{
    if (group->rate_of > 0) {
        return arena_format(f->memory, "der(states.%s)", v->name);
    }
    const size_t outputs = (size_t)f->p->outputs.count;
    const bool is_output = index_of_word(v->name, f->p->outputs.names, outputs) < outputs;
    const bool is_bare = group->folder[0] == '\0' || (strcmp(group->folder, "states") != 0 && !is_output);
    return is_bare ? v->name : arena_format(f->memory, "%s.%s", group->folder, v->name);
}

static const char *description_of(const fmu *f, const variable *v)
{
    const char *quote = v->quote == NULL ? "" : v->quote;
    return escaped(f->memory, v->display_name == NULL ? quote : arena_format(f->memory, "fault %s", v->display_name));
}

/* The attributes of the number itself: its unit, its limits and its start. */
static void add_number(const fmu *f, const variables *group, const variable *v, bool has_start, text *out)
{
    add_attribute(out, "unit", strcmp(v->unit, "1") != 0 ? v->unit : NULL);
    add_attribute(out, "displayUnit", shown_in(v->unit));
    add_attribute(out, "min", group->has_range && !isinf(v->least) ? xml_number(f, v->least) : NULL);
    add_attribute(out, "max", group->has_range && !isinf(v->most) ? xml_number(f, v->most) : NULL);
    add_attribute(out, "start", has_start ? xml_number(f, v->start) : NULL);
}

/* A variable: in version 3.0 an element of its type, in 2.0 one that has that in it. */
static void add_variable(const fmu *f, const char *called, int reference, const char *traits, const char *type,
                         const char *number, const char *description, text *out)
{
    const char *about = description[0] == '\0' ? "" : arena_format(f->memory, " description=\"%s\"", description);
    text_add(out, "    <%s name=\"%s\" valueReference=\"%d\" %s", f->version == 3 ? type : "ScalarVariable", called,
             reference, traits);
    if (f->version == 3) {
        text_add(out, "%s%s/>\n", number, about);
    } else {
        text_add(out, "%s><%s%s/></ScalarVariable>\n", about, strcmp(type, "String") == 0 ? type : "Real", number);
    }
}

/* The attributes of a derivative and of a state for model exchange: references in version 3.0, in 2.0 numbers from 1.
 */
static void add_motion(const fmu *f, const variables *group, int i, text *out)
{
    if (group->rate_of > 0) {
        text_add(out, " derivative=\"%d\"", group->rate_of + i + (f->version == 2 ? 1 : 0));
    } else if (f->exchanges && group->content == &f->names->x) {
        const state_kind kind = f->names->states[i].kind;
        text_add(out, " nominal=\"%s\"%s", xml_number(f, fmax(1.0, fabs(group->content->all[i].start))),
                 kind == STATE_TURN || kind == STATE_QUATERNION ? " reinit=\"true\"" : "");
    }
}

static void add_quantity(const fmu *f, const variables *group, int i, int reference, text *out)
{
    const variable *v = &group->content->all[i];
    const bool is_driven = group->content == &f->names->u && f->p->m->inputs.driven[i];
    text number = empty_text(f->memory);
    add_number(f, group, v, group->has_start && !is_driven, &number);
    add_motion(f, group, i, &number);
    add_variable(f, name_of(f, group, v), reference,
                 is_driven ? "causality=\"local\" variability=\"discrete\"" : group->traits, "Float64", number.bytes,
                 description_of(f, v), out);
}

/* --- structure --------------------------------------------------------------------------------------------------- */

/* Outputs, or derivatives of states. */
typedef struct unknown_list {
    const node *roots;
    int first, count; /* the reference of the first */
} unknown_list;

/* Adds the references of known variables; version 2.0 counts the variables from 1, of which time with the reference 0
 * is the first. */
static void add_known(const fmu *f, int first, const bool *is, int count, text *out)
{
    for (int i = 0; i < count; i++) {
        if (is[i]) {
            text_add(out, "%s%d", out->length == 0 ? "" : " ", first + i + (f->version == 2 ? 1 : 0));
        }
    }
}

/* The dependencies of an unknown: at the start inputs, tunables, states and time. Later inputs count at once in model
 * exchange alone, in co-simulation from the next tick on; and version 2.0 has no tunables there, and states in model
 * exchange alone. */
static const char *dependencies_of(const fmu *f, node root, bool at_start)
{
    const mechanism *m = f->p->m;
    const fmu_readings reads = fmu_depends(f, root, at_start);
    const int first_parameter = 1 + m->inputs.count;
    bool *inputs = arena_take(f->memory, (size_t)m->inputs.count + 1, sizeof *inputs);
    text list = empty_text(f->memory);
    for (int i = 0; i < m->inputs.count; i++) {
        inputs[i] = (at_start || f->exchanges) && reads.inputs[i] && !m->inputs.driven[i];
    }
    add_known(f, 0, &reads.time, 1, &list);
    add_known(f, 1, inputs, m->inputs.count, &list);
    if (at_start || f->version == 3) {
        add_known(f, first_parameter, reads.parameters, m->parameters.count, &list);
    }
    if (at_start || f->version == 3 || f->exchanges) {
        add_known(f, first_parameter + m->parameters.count + f->p->outputs.count, reads.states, state_count(m), &list);
    }
    return list.bytes;
}

/* Unknowns, whose references follow each other. */
static void add_unknowns(const fmu *f, const char *element, bool at_start, const unknown_list *all, text *out)
{
    for (int i = 0; i < all->count; i++) {
        const char *known = dependencies_of(f, all->roots[i], at_start);
        if (f->version == 3) {
            text_add(out, "    <%s valueReference=\"%d\" dependencies=\"%s\"/>\n", element, all->first + i, known);
        } else {
            text_add(out, "      <Unknown index=\"%d\" dependencies=\"%s\"/>\n", all->first + i + 1, known);
        }
    }
}

/* A list of them, which version 2.0 has an element for. */
static void add_list(const fmu *f, const char *element, bool at_start, const unknown_list *all, int count, text *out)
{
    const bool is_element = f->version == 2 && all[0].count + all[count - 1].count > 0;
    if (is_element) {
        text_add(out, "    <%ss>\n", element);
    }
    for (int i = 0; i < count; i++) {
        add_unknowns(f, element, at_start, &all[i], out);
    }
    if (is_element) {
        text_add(out, "    </%ss>\n", element);
    }
}

/* --- modelDescription.xml ---------------------------------------------------------------------------------------- */

/* The derivatives of the states as variables. */
static quantities rates_of(const fmu *f)
{
    const quantities *x = &f->names->x;
    variable *all = arena_take(f->memory, (size_t)x->count, sizeof *all);
    for (int i = 0; i < x->count; i++) {
        all[i] = unlimited(x->all[i].name, unit_of_rate(f->memory, x->all[i].unit), NULL);
    }
    return (quantities){NULL, all, x->count};
}

/* The element that says that there is model exchange, and whether the importer must report each completed step. */
static const char *exchange_element(const fmu *f)
{
    const char *kinds = fmu_kinds(f);
    const bool is_told = strstr(kinds, "FMU_TURN") != NULL || strstr(kinds, "FMU_QUATERNION") != NULL;
    return !f->exchanges ? ""
                         : arena_format(f->memory,
                                        "  <ModelExchange modelIdentifier=\"%s\" canGetAndSetFMUState=\"true\" "
                                        "canSerializeFMUState=\"true\"\n      providesDirectionalDerivatives=\"true\" "
                                        "needsCompletedIntegratorStep=\"%s\"/>\n",
                                        f->names->prefix, is_told ? "true" : "false");
}

static void add_variables(const fmu *f, const variables *groups, int group_count, text *out)
{
    int reference = 0;
    add_variable(f, "time", reference++, "causality=\"independent\" variability=\"continuous\"", "Float64",
                 " unit=\"s\"", "", out);
    for (int k = 0; k < group_count; k++) {
        for (int i = 0; i < groups[k].content->count; i++) {
            add_quantity(f, &groups[k], i, reference++, out);
        }
    }
    const int last = reference + (f->exchanges ? 0 : state_count(f->p->m));
    add_variable(f, "run.hash", last, "causality=\"local\" variability=\"discrete\"", "String", "",
                 "FNV-1a of the states after each tick, as make run prints it", out);
}

void fmu_describe(const fmu *f, file_list *files)
{
    const mechanism *m = f->p->m;
    const int states = state_count(m), outputs = f->p->outputs.count;
    const int first_output = 1 + m->inputs.count + m->parameters.count, first_state = first_output + outputs;
    const naming *names = f->names;
    const quantities rates = rates_of(f);
    const variables groups[] = {
        {"inputs", "causality=\"input\" variability=\"continuous\"", &names->u, true, true, 0},
        {"tunables", "causality=\"parameter\" variability=\"tunable\" initial=\"exact\"", &names->p, true, true, 0},
        {"", "causality=\"output\" variability=\"continuous\" initial=\"calculated\"", &names->y, false, false, 0},
        {"states", "causality=\"local\" variability=\"continuous\" initial=\"exact\"", &names->x, true, false, 0},
        {"", "causality=\"local\" variability=\"continuous\" initial=\"calculated\"", &rates, false, false,
         first_state},
    };
    const int group_count = (int)COUNT_OF(groups) - (f->exchanges ? 0 : 1);
    const unknown_list all_unknowns[] = {{f->p->outputs.roots, first_output, outputs},
                                         {f->p->derivatives, first_state + states, f->exchanges ? states : 0}};
    text units = empty_text(f->memory), all = units, structure = units;
    add_units(f, groups, group_count, &units);
    add_variables(f, groups, group_count, &all);
    add_list(f, "Output", false, all_unknowns, 1, &structure);
    add_list(f, f->version == 3 ? "ContinuousStateDerivative" : "Derivative", false, all_unknowns + 1, 1, &structure);
    add_list(f, "InitialUnknown", true, all_unknowns, 2, &structure);
    file_list_fill(files, "modelDescription.xml",
                   f->version == 3 ? "tools/fmu/modelDescription3.xml.in" : "tools/fmu/modelDescription2.xml.in",
                   (const filling[]){{"scene", m->name},
                                     {"name", names->prefix},
                                     {"token", f->identity},
                                     {"method", method_names[ISO_METHOD_OF(m->method.recipe)]},
                                     {"step", code_decimal(f->memory, m->method.step, true)},
                                     {"sources", fmu_sources(f, "      <File name=\"%s\"/>\n")},
                                     {"exchange", exchange_element(f)},
                                     {"units", units.bytes},
                                     {"categories", embedded_text(client_files, "tools/fmu/logCategories.xml.in")},
                                     {"variables", all.bytes},
                                     {"structure", structure.bytes},
                                     {NULL, NULL}});
}
