#include "tools/isoc/request.h"

#include <stdio.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/dynamics/dynamics.h"
#include "tools/isoc/export/export.h"
#include "tools/isoc/linear/linear.h"
#include "tools/isoc/plant/plant.h"
#include "tools/isoc/scene/parser.h"
#include "tools/isoc/stability/stability.h"
#include "tools/isoc/sweep/sweep.h"
#include "tools/isoc/tree/tree.h"

/* The files that a scene is read from, one on a line. */
static bool write_paths(const source *s)
{
    text list = {.memory = s->memory};
    for (size_t i = 0; i < s->path_count; i++) {
        text_add(&list, "%s\n", s->paths[i]);
    }
    return write_out(list.bytes, list.length);
}

/* The name and the kind of each effect, on a line. */
static bool write_effects(source *s, const scene *written)
{
    text list = {.memory = s->memory};
    FOR_EACH (const effect_use, use, written->effects) {
        if (!use->left_out && use->name.text != NULL && use->kind.text != NULL) {
            text_add(&list, "%s %s\n", use->name.text, use->kind.text);
        }
    }
    return s->problem_count > 0 ? source_report(s) : write_out(list.bytes, list.length);
}

/* The data of a picture of the mechanism besides the poses of its bodies. */
static bool write_scene_shape(source *s, const scene *written)
{
    text shape = {.memory = s->memory};
    graph g;
    graph_start(&g, s->memory, "");
    mechanism_shape(s, &g, written, &shape);
    return s->problem_count > 0 ? source_report(s) : write_out(shape.bytes, shape.length);
}

/* Bodies, joints and closures, for graphviz. */
static bool write_graph(source *s, const scene *written, const mechanism *m)
{
    text drawing = {.memory = s->memory};
    const name_list names = names_of_states(s, m);
    dot_write(written, &names, &drawing);
    return write_out(drawing.bytes, drawing.length);
}

/* The mechanism for MuJoCo. */
static bool write_mjcf(arena *memory, const request *r, graph *g, const mechanism *m)
{
    text file = {.memory = memory};
    const char *fault = emit_mjcf(g, m, &file);
    if (fault != NULL) {
        fprintf(stderr, "%s: error: %s\n", r->scene, fault);
        return false;
    }
    return write_out(file.bytes, file.length);
}

/* Checks that a plant is useful at its start, each where those before it hold. */
static void check(source *s, const graph *g, const plant *p)
{
    static void (*const checks[])(source * s, const graph *g, const plant *p) = {
        pivots_check,    /* a joint moves no inertia: the mass matrix is singular */
        range_check,     /* a constant is beyond the number type */
        start_check,     /* the derivative is not finite in that type */
        stability_check, /* the Jacobian is not finite; warns where method and step do not hold the plant */
        pace_check,      /* warns of joints that turn too far in a step */
    };
    for (size_t i = 0; i < COUNT_OF(checks) && s->problem_count == 0; i++) {
        checks[i](s, g, p);
    }
}

/* A plant that firmware or another program steps has no loop of core, of which policies are. */
static void check_policies(source *s, const request *r, const scene *written)
{
    if (r->name != NULL || r->is_standalone) {
        mechanism_without_loop(s, written,
                               "--name or --standalone a plant has none, and the firmware that calls iso_plant_tick "
                               "times its ticks");
    } else if (r->lanes != NULL) {
        mechanism_without_loop(s, written,
                               "--lanes plants have none, and the program that calls iso_lanes_tick times their ticks");
    }
}

/* Checks the uses of the plant besides runs. Returns whether it is an FMU for model exchange too. */
static bool check_uses(source *s, const request *r, const graph *g, const scene *written, const plant *p)
{
    sweep_check_varied(s, p->m, r->vary);
    return r->fmi_version == 3 && exchange_fits(s, written, g, p, r->exchange != NULL);
}

/* Header and source of the plant, with the files beside them; and its cost on standard output. */
static bool write_plant(arena *memory, const request *r, const plant *p, graph *g, bool exchanges)
{
    text header = {.memory = memory}, source_text = {.memory = memory}, summary = {.memory = memory};
    file_list files = {.memory = memory, .folder = r->directory};
    double out_of_range_value = 0.0;
    const bool is_fmu = r->fmi_version > 0;
    const char *prefix = is_fmu && r->name == NULL ? fmu_name(p, memory) : r->name;
    naming names = naming_of(p, memory, prefix); /* of states, arrays and functions in C */
    names.is_checked = r->name != NULL || r->is_standalone;
    names.is_fmu = is_fmu;
    names.has_lanes = r->lanes != NULL;
    names.cut = cut_of(p, g, &names); /* the values that a step prepares for the next one */
    emit_header(p, &names, &header);  /* places, units and limits; the struct of the memory */
    if (!emit_source(p, g, &names, &source_text,
                     &out_of_range_value)) { /* straight-line C of the equations; the step */
        fprintf(stderr, "%s: error: the equations contain %g; %s\n", r->scene, out_of_range_value,
                real_advice(out_of_range_value, r->is_double));
        return false;
    }
    if (r->link != NULL && !link_fits(p, r->scene)) {
        return false;
    }
    file_list_add(&files, arena_format(memory, "%s.h", names.prefix), &header);
    file_list_add(&files, arena_format(memory, "%s.c", names.prefix), &source_text);
    if (r->link != NULL) {
        emit_link(p, &names, r->lock, &files); /* the controller's end of a wire */
    }
    if (r->python != NULL) {
        emit_python(p, &names, &files); /* the package of a program that has the plant in it */
    }
    if (is_fmu && !emit_exchange(p, g, &names, exchanges, &files)) { /* the slopes of f and g */
        fprintf(stderr, "%s: error: the slopes of the equations contain a number beyond the number type\n", r->scene);
        return false;
    }
    if (is_fmu) {
        emit_fmu(p, g, &names, r->fmi_version, exchanges,
                 &files); /* the calls of the standard, and the description of the model */
    }
    if (r->is_standalone) {
        standalone_files(&files, &names, r->is_double, !is_fmu); /* the files of core that these include */
    }
    write_summary(p, g, &summary); /* operations of a derivative and of a step, bytes of state */
    stability_line(p, &summary);
    return write_files(&files) && write_out(summary.bytes, summary.length);
}

/* The plant, or its equations for a reader. */
static bool write_plant_or_equations(arena *memory, const request *r, const scene *written, const plant *p, graph *g,
                                     bool exchanges)
{
    if (r->instead.equations == NULL) {
        return write_plant(memory, r, p, g, exchanges);
    }
    text document = {.memory = memory};
    const naming names = naming_of(p, memory, NULL);
    const size_t style = index_of_word(r->instead.equations, equations_styles, EQUATIONS_STYLES);
    describe_equations(p, g, &names, written, (equations_style)style, &document);
    return r->directory == NULL ? write_out(document.bytes, document.length)
                                : write_file(memory, r->directory, &document);
}

/* The text of the scene. What was warned of when the plant was made is not said again at the end of a run. */
static bool read_scene(source *s, arena *memory, const request *r)
{
    const bool is_read = source_read(s, memory, r->scene);
    s->is_silent = r->instead.ended != NULL;
    return is_read;
}

/* The whole compiler. A pass notes the problems of the source, and goes on with the rest; a group of passes ends at
 * problems. */
bool compile(arena *memory, const request *r)
{
    source s;
    graph g;
    /* The scene: statements as they are written. */
    if (!read_scene(&s, memory, r)) { /* the text of its file */
        return false;
    }
    scene written = parse_scene(&s); /* statements with their places, also those of repeats and of included files */
    if (r->instead.files != NULL) {
        return write_paths(&s);
    }
    if (!override_scene(memory, r, &s, &written)) { /* the command line's values replace the scene's */
        return false;
    }
    if (r->instead.effects != NULL || r->instead.shape != NULL) {
        return r->instead.effects != NULL ? write_effects(&s, &written) : write_scene_shape(&s, &written);
    }
    /* The mechanism: names are found, units checked, formulas are nodes of a graph; bodies are parts of segments. */
    graph_start(&g, memory, "Constants of the scene");
    mechanism m = mechanism_build(&s, &g, &written, r->is_double, NULL); /* by passes of its own */
    check_policies(&s, r, &written); /* statements that only the loop of core carries out */
    if (s.problem_count > 0 || !request_fits(r, &m)) {
        return source_report(&s);
    }
    if (r->instead.dot != NULL) {
        return write_graph(&s, &written, &m);
    }
    assemble(&s, &g, &m);          /* the start: numbers that satisfy the closures, of which constants may follow */
    point_queries_resolve(&g, &m); /* quantities of points in formulas: nodes of the states instead of leaves */
    if (s.problem_count > 0) {
        return source_report(&s);
    }
    if (r->instead.mjcf != NULL) {
        return write_mjcf(memory, r, &g, &m);
    }
    /* The plant: all that a tick computes, as nodes of states, inputs and tunables. */
    plant p = plant_build(&g, &m, r->is_double, r->wanted); /* derivative, outputs, factors of an implicit method */
    rows_build(&s, &g, &p, NULL);                           /* the assignments of a row, in order; starts of effects */
    if (r->instead.linear != NULL && s.problem_count == 0) {
        return linear_run(&s, &g, &written, &p, &r->linear);
    }
    if (r->sweep.set != NULL && s.problem_count == 0) {
        return sweep_run(&s, &g, &written, &p, &r->sweep);
    }
    if (r->instead.ended != NULL && s.problem_count == 0) {
        return ended_check(&s, &g, &p, r->instead.ended);
    }
    const bool exchanges = check_uses(&s, r, &g, &written, &p);
    check(&s, &g, &p);
    if (s.problem_count > 0) {
        return source_report(&s);
    }
    if (r->in_place.inputs == NULL) {
        samples_check(&s, &g, &written, &p); /* warns where held inputs lower the order of the method */
    }
    switching_check(&s, &g, &p);                       /* warns of effects that jump within a step */
    reduced_plants_build(&s, &written, &p, r->wanted); /* the same without the effects that a ladder drops */
    return write_plant_or_equations(memory, r, &written, &p, &g, exchanges);
}
