/* isoc: from a scene to a plant in straight-line C. */
#include <stdio.h>
#include <string.h>

#include "tools/isoc/base/real_range.h"
#include "tools/isoc/dynamics/assembly.h"
#include "tools/isoc/emit/emit.h"
#include "tools/isoc/emit/link.h"
#include "tools/isoc/emit/prefix.h"
#include "tools/isoc/emit/standalone.h"
#include "tools/isoc/plant/check_pivots.h"
#include "tools/isoc/plant/check_range.h"
#include "tools/isoc/plant/check_start.h"
#include "tools/isoc/plant/input_check.h"
#include "tools/isoc/plant/reduced_plant.h"
#include "tools/isoc/plant/rows.h"
#include "tools/isoc/plant/summary.h"
#include "tools/isoc/scene/dot.h"
#include "tools/isoc/scene/leave_out.h"
#include "tools/isoc/scene/parser.h"
#include "tools/isoc/stability/stability.h"
#include "tools/isoc/stability/switching.h"
#include "tools/isoc/tree/point_query.h"

static const char version[] = "isoc 0.1\n";

static const char help[] =
    "isoc: compiles a scene to a plant in straight-line C\n"
    "\n"
    "  isoc SCENE -o DIR [--name NAME] [--standalone] [--link [--xcp LOCK]] [--method M] [--step H] [--tolerance T] "
    "[--real "
    "float|double]\n"
    "       [--inputs held|smooth] [--set 'NAME = VALUE'] [--without 'EFFECT; ...'] [--formulation F] [--factors F]\n"
    "  isoc SCENE --dot\n"
    "  isoc SCENE --files\n"
    "  isoc SCENE --effects\n"
    "\n"
    "  SCENE          the scene, a text file\n"
    "  -o DIR         where plant.h and plant.c go; made if it is not there\n"
    "  --name NAME    for a part of other firmware: NAME.h and NAME.c, in which all names begin with NAME_, so that\n"
    "                 several plants, and several of one, stand in one program\n"
    "  --standalone   puts beside it what it needs of core, so that the folder compiles alone\n"
    "  --link         puts beside it what it shows to a controller at the other end of a wire, interface.c, and that "
    "end\n"
    "                 in C and in Python, SCENE_link.h and SCENE_link.py\n"
    "  --xcp LOCK     with --link: measurement and calibration, and plant.a2l.in; LOCK is open, or the name of an "
    "iso_xcp_lock\n"
    "  --method M     a method, instead of the scene's; --methods lists them\n"
    "  --step H       the step with its unit, e.g. 1ms, instead of the scene's\n"
    "  --tolerance T  of adams, which then takes as many sub-steps as it needs\n"
    "  --real R       the number type of the plant: float (default) or double\n"
    "  --inputs R     all inputs held, or all smooth, instead of the scene's reading\n"
    "  --set 'NAME = VALUE; ...'  constants and tunables, instead of the scene's values\n"
    "  --without 'EFFECT; ...'  leaves out these effects of the scene, with the outputs and the inputs that are theirs "
    "alone\n"
    "  --formulation F  instead of the cheapest; of a tree composite or articulated bodies, of closed loops composite "
    "bodies\n"
    "                 with the closures in the axes of their base, composite, or of a side, parent_axes or child_axes\n"
    "  --factors F    of an implicit method of a tree, instead of what suits its size: of a full or of a sparse "
    "matrix, or\n"
    "                 looped, of the sparse one by loops over constant tables\n"
    "  --dot          nothing but a graph of bodies, joints and closures, for graphviz: isoc SCENE --dot | dot -Tsvg\n"
    "  --files        nothing but the files that the scene is read from, one on a line, also those that are not there\n"
    "  --effects      nothing but the effects of the scene: the name and the kind of each, on a line\n"
    "  --methods      what each method costs, as a table\n"
    "  --help         this text\n"
    "  --version      the version\n"
    "\n"
    "Prints what the plant costs: states, inputs, outputs, operations of a derivative and of a step, bytes of state.\n"
    "A mistake in the scene is told as file:line:column; the exit status is then 1 and no file is touched.\n";

typedef struct options {
    const char *scene, *directory, *name, *method, *step, *tolerance, *set, *without, *inputs, *lock;
    bool is_double, draws, lists, lists_effects, is_standalone, is_linked;
    build_options wanted;
} options;

static bool complain(const char *message, const char *argument)
{
    fprintf(stderr, "isoc: error: %s%s%s\nisoc --help lists the options\n", message, argument == NULL ? "" : " ",
            argument == NULL ? "" : argument);
    return false;
}

/* The value of an option: it must follow, and an option must be given once. */
static bool take_option(char **argument, const char **slot)
{
    if (argument[1] == NULL) {
        return complain("a value is missing after", argument[0]);
    }
    if (*slot != NULL) {
        return complain("given twice:", argument[0]);
    }
    *slot = argument[1];
    return true;
}

/* Where a word stands among others, or their number. */
static int find_word(const char *word, const char *const *words, int count)
{
    int found = 0;
    while (found < count && (word == NULL || strcmp(word, words[found]) != 0)) {
        found++;
    }
    return found;
}

static bool is_identifier(const char *word)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", digits[] = "0123456789";
    const size_t length = strlen(word);
    size_t known = 0;
    while (known < length && (strchr(letters, word[known]) != NULL || strchr(digits, word[known]) != NULL)) {
        known++;
    }
    return known > 0 && known == length && strchr(letters, word[0]) != NULL;
}

static bool read_options(char **arguments, options *o)
{
    const char *real_name = NULL, *formulation_name = NULL, *factors_name = NULL;
    for (char **a = arguments; *a != NULL; a++) {
        const char **slot = strcmp(*a, "-o") == 0              ? &o->directory
                            : strcmp(*a, "--name") == 0        ? &o->name
                            : strcmp(*a, "--method") == 0      ? &o->method
                            : strcmp(*a, "--step") == 0        ? &o->step
                            : strcmp(*a, "--tolerance") == 0   ? &o->tolerance
                            : strcmp(*a, "--set") == 0         ? &o->set
                            : strcmp(*a, "--without") == 0     ? &o->without
                            : strcmp(*a, "--inputs") == 0      ? &o->inputs
                            : strcmp(*a, "--xcp") == 0         ? &o->lock
                            : strcmp(*a, "--real") == 0        ? &real_name
                            : strcmp(*a, "--formulation") == 0 ? &formulation_name
                            : strcmp(*a, "--factors") == 0     ? &factors_name
                                                               : NULL;
        if (slot != NULL) {
            if (!take_option(a, slot)) {
                return false;
            }
            a++;
        } else if (strcmp(*a, "--dot") == 0) {
            o->draws = true;
        } else if (strcmp(*a, "--files") == 0) {
            o->lists = true;
        } else if (strcmp(*a, "--effects") == 0) {
            o->lists_effects = true;
        } else if (strcmp(*a, "--standalone") == 0) {
            o->is_standalone = true;
        } else if (strcmp(*a, "--link") == 0) {
            o->is_linked = true;
        } else if ((*a)[0] == '-' && (*a)[1] != '\0') {
            return complain("unknown option", *a);
        } else if (o->scene != NULL) {
            return complain("more than one scene:", *a);
        } else {
            o->scene = *a;
        }
    }
    o->is_double = real_name != NULL && strcmp(real_name, "double") == 0;
    o->wanted.formulation = (formulation)find_word(formulation_name, formulation_names, FORMULATIONS);
    o->wanted.factors = (factoring)find_word(factors_name, factoring_names, FACTORINGS);
    const bool makes_none = o->draws || o->lists || o->lists_effects;
    if (o->scene == NULL || (o->directory == NULL && !makes_none)) {
        return complain(o->scene == NULL ? "no scene is given" : "no folder for the plant: -o DIR", NULL);
    }
    if (o->directory != NULL && makes_none) {
        return complain(o->draws   ? "--dot makes no plant: leave out -o"
                        : o->lists ? "--files makes no plant: leave out -o"
                                   : "--effects makes no plant: leave out -o",
                        o->directory);
    }
    if (o->is_linked && (o->name != NULL || o->is_standalone || makes_none)) {
        return complain("--link is of a whole program: leave out", o->name != NULL    ? "--name"
                                                                   : o->is_standalone ? "--standalone"
                                                                   : o->draws         ? "--dot"
                                                                   : o->lists         ? "--files"
                                                                                      : "--effects");
    }
    if (o->lock != NULL && !o->is_linked) {
        return complain("--xcp is of a plant with a link: add --link to --xcp", o->lock);
    }
    if (o->lock != NULL && !is_identifier(o->lock)) {
        return complain("--xcp is open, or the name of an iso_xcp_lock in C; not", o->lock);
    }
    if (real_name != NULL && !o->is_double && strcmp(real_name, "float") != 0) {
        return complain("--real must be float or double, not", real_name);
    }
    if (o->inputs != NULL && strcmp(o->inputs, "held") != 0 && strcmp(o->inputs, "smooth") != 0) {
        return complain("--inputs must be held or smooth, not", o->inputs);
    }
    if (formulation_name != NULL && o->wanted.formulation == FORMULATIONS) {
        return complain("--formulation must be composite, articulated, parent_axes or child_axes, not",
                        formulation_name);
    }
    if (factors_name != NULL && o->wanted.factors == FACTORINGS) {
        return complain("--factors must be full, sparse or looped, not", factors_name);
    }
    return true;
}

static bool check_prefix(arena *memory, const char *prefix)
{
    const char *fault = prefix == NULL ? NULL : prefix_fault(prefix, memory);
    return fault == NULL || complain(arena_format(memory, "--name of a plant: %s; not", fault), prefix);
}

/* Reads --step, --method and --tolerance as statements of the scene, and reports their problems at once. */
static bool override(arena *memory, const options *o, scene *s)
{
    if (o->step == NULL && o->method == NULL && o->tolerance == NULL) {
        return true;
    }
    const char *step = o->step == NULL ? "" : arena_format(memory, "step %s\n", o->step);
    const char *method = o->method == NULL ? step : arena_format(memory, "%smethod %s\n", step, o->method);
    const char *named = o->method != NULL ? o->method : s->method.text;
    const bool was_adams = s->method.text != NULL && strcmp(s->method.text, "adams") == 0;
    const bool is_adams = named != NULL && strcmp(named, "adams") == 0;
    const char *words = o->tolerance == NULL ? method
                                             : arena_format(memory, "%stolerance %s\n%s", method, o->tolerance,
                                                            is_adams ? "substeps 1000000\n" : "");
    source given = source_of_text(memory, "command line", words);
    const scene read = parse_scene(&given);
    graph g;
    graph_start(&g, memory);
    graph_section(&g, "");
    mechanism_method_and_step(&given, &g, &read, o->is_double);
    source_report(&given);
    if (was_adams != is_adams) {
        s->substeps = NULL; /* a budget is no number of parts */
    }
    s->step = read.step == NULL ? s->step : read.step;
    s->method = read.method.text == NULL ? s->method : read.method;
    s->tolerance = read.tolerance == NULL ? s->tolerance : read.tolerance;
    s->substeps = read.substeps == NULL ? s->substeps : read.substeps;
    return given.problem_count == 0;
}

static bool write_plant(arena *memory, const options *o, const plant *p, graph *g)
{
    text header = {.memory = memory}, source_text = {.memory = memory}, summary = {.memory = memory};
    const naming names = naming_of(p, memory, o->name);
    file_list files = {.memory = memory, .folder = o->directory};
    double out_of_range_value = 0.0;
    emit_header(p, &names, &header);
    if (!emit_source(p, g, &names, &source_text, &out_of_range_value)) {
        fprintf(stderr, "%s: error: the equations contain %g; %s\n", o->scene, out_of_range_value,
                real_advice(out_of_range_value, o->is_double));
        return false;
    }
    if (o->is_linked && !link_fits(p, o->scene)) {
        return false;
    }
    write_summary(p, g, &summary);
    file_list_add(&files, arena_format(memory, "%s.h", names.prefix), &header);
    file_list_add(&files, arena_format(memory, "%s.c", names.prefix), &source_text);
    if (o->is_linked) {
        emit_link(p, &names, o->lock, &files);
    }
    if (o->is_standalone) {
        standalone_files(&files, o->is_double);
    }
    return write_files(&files) && write_out(summary.bytes, summary.length);
}

static bool write_graph(arena *memory, const scene *written, const mechanism *m)
{
    text drawing = {.memory = memory};
    const state *all = mechanism_states(m, memory);
    name *names = arena_take(memory, (size_t)state_count(m) + 1, sizeof *names);
    for (int i = 0; i < state_count(m); i++) {
        names[i] = (name){all[i].about.name, all[i].at};
    }
    dot_write(written, &(drawn_states){names, (size_t)state_count(m)}, &drawing);
    return write_out(drawing.bytes, drawing.length);
}

static bool write_files_read(arena *memory, const source *s)
{
    text list = {.memory = memory};
    for (size_t i = 0; i < s->path_count; i++) {
        text_add(&list, "%s\n", s->paths[i]);
    }
    return write_out(list.bytes, list.length);
}

static bool write_effects(arena *memory, const scene *written)
{
    text list = {.memory = memory};
    for (size_t i = 0; i < written->effect_count; i++) {
        const effect_use *use = &written->effects[i];
        if (!use->left_out && use->name.text != NULL && use->kind.text != NULL) {
            text_add(&list, "%s %s\n", use->name.text, use->kind.text);
        }
    }
    return write_out(list.bytes, list.length);
}

static bool compile(arena *memory, const options *o)
{
    source s;
    graph g;
    if (!source_read(&s, memory, o->scene)) {
        return false;
    }
    scene written = parse_scene(&s);
    written.name = source_name(&s);
    if (o->lists) {
        return write_files_read(memory, &s);
    }
    if (!override(memory, o, &written)) {
        return false;
    }
    if (o->set != NULL) {
        scene_set(&s, &written, source_add(&s, "--set", o->set));
    }
    if (o->without != NULL) {
        scene_leave_out(&s, &written, source_add(&s, "--without", o->without));
    }
    if (s.problem_count == 0 && o->lists_effects) {
        return write_effects(memory, &written);
    }
    for (size_t i = 0; i < written.input_count && o->inputs != NULL; i++) {
        written.inputs[i].smooth = strcmp(o->inputs, "smooth") == 0;
    }
    graph_start(&g, memory);
    graph_section(&g, "Constants of the scene");
    mechanism m = mechanism_build(&s, &g, &written, o->is_double, NULL);
    if (o->name != NULL || o->is_standalone) {
        mechanism_without_loop(&s, &written);
    }
    if (s.problem_count == 0 && o->tolerance != NULL && !ISO_IS(m.recipe, ISO_ADAMS)) {
        return complain("--tolerance is of adams; it has no effect on", method_names[ISO_METHOD_OF(m.recipe)]);
    }
    if (s.problem_count == 0 && o->draws) {
        return write_graph(memory, &written, &m);
    }
    if (s.problem_count == 0) {
        if (o->wanted.formulation != FORMULATIONS && !formulation_fits(&m, o->wanted.formulation)) {
            return complain(m.closure_count > 0 ? "closed loops have no such formulation:"
                                                : "a tree has no such formulation:",
                            o->scene);
        }
        assemble(&s, &g, &m);
        point_queries_resolve(&g, &m);
    }
    /* Constants of the equations may depend on the start: so that comes first. */
    if (s.problem_count == 0) {
        plant p = plant_build(&g, &m, o->is_double, o->wanted);
        rows_build(&s, &g, &p, NULL);
        if (s.problem_count == 0) {
            pivots_check(&s, &g, &p);
        }
        if (s.problem_count == 0) {
            range_check(&s, &g, &p);
        }
        if (s.problem_count == 0) {
            start_check(&s, &g, &p);
        }
        if (s.problem_count == 0) {
            stability_check(&s, &g, &p);
        }
        if (s.problem_count == 0) {
            if (o->inputs == NULL) {
                samples_check(&s, &g, &written, &p);
            }
            switching_check(&s, &g, &p);
            reduced_plants_build(&s, &written, &p, o->wanted);
            return write_plant(memory, o, &p, &g);
        }
    }
    source_report(&s);
    return false;
}

/* --version, --help and --methods, which need no scene. */
static bool is_question(const char *argument)
{
    return strcmp(argument, "--version") == 0 || strcmp(argument, "--help") == 0 || strcmp(argument, "--methods") == 0;
}

static bool answer(arena *memory, const char *question)
{
    text table = {.memory = memory};
    write_methods(&table);
    return strcmp(question, "--version") == 0 ? write_out(version, strlen(version))
           : strcmp(question, "--help") == 0  ? write_out(help, strlen(help))
                                              : write_out(table.bytes, table.length);
}

static bool run(arena *memory, char **arguments)
{
    for (char **a = arguments; *a != NULL; a++) {
        if (is_question(*a)) {
            return answer(memory, *a);
        }
    }
    options o = {0};
    return read_options(arguments, &o) && check_prefix(memory, o.name) && compile(memory, &o);
}

int main(int count, char **arguments)
{
    arena *memory = arena_new();
    const bool good = count > 0 && run(memory, arguments + 1);
    arena_free(memory);
    return good ? 0 : 1;
}
