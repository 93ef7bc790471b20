/* What isoc writes of a compilation. */
#include <stdio.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/export/export.h"
#include "tools/isoc/request.h"
#include "tools/isoc/scene/parser.h"
#include "tools/isoc/stability/stability.h"

/* The files that a scene is read from, one on a line. */
static bool write_paths(compilation *c)
{
    text list = {.memory = c->memory};
    for (size_t i = 0; i < c->s->path_count; i++) {
        text_add(&list, "%s\n", c->s->paths[i]);
    }
    return write_out(list.bytes, list.length);
}

/* The name and the kind of each effect, on a line. */
static bool write_effects(compilation *c)
{
    text list = {.memory = c->memory};
    FOR_EACH (const effect_use, use, c->written.effects) {
        if (!use->left_out && use->name.text != NULL && use->kind.text != NULL) {
            text_add(&list, "%s %s\n", use->name.text, use->kind.text);
        }
    }
    return write_out(list.bytes, list.length);
}

/* The definitions of the file, which are right. */
static bool write_check(compilation *c)
{
    text list = {.memory = c->memory};
    describe_trials(&c->b, &list);
    return write_out(list.bytes, list.length);
}

/* The data of a picture of the mechanism besides the poses of its bodies. */
static bool write_shape(compilation *c)
{
    text cells = {.memory = c->memory};
    shape_cells(&c->b, &cells);
    return c->s->problem_count > 0 ? source_report(c->s) : write_out(cells.bytes, cells.length);
}

/* Bodies, joints and closures, for graphviz. */
static bool write_graph(compilation *c)
{
    text drawing = {.memory = c->memory};
    const name_list names = names_of_states(c->s, &c->b.mechanism);
    dot_write(&c->written, &names, &drawing);
    return write_out(drawing.bytes, drawing.length);
}

/* The mechanism for MuJoCo. */
static bool write_mjcf(compilation *c)
{
    text file = {.memory = c->memory};
    const char *fault = emit_mjcf(&c->g, &c->b.mechanism, &file);
    if (fault != NULL) {
        fprintf(stderr, "%s: error: %s\n", c->r->scene, fault);
        return false;
    }
    return write_out(file.bytes, file.length);
}

static bool write_linear(compilation *c)
{
    return linear_run(c->s, &c->g, &c->written, &c->p, &c->r->linear);
}

static bool write_sweep(compilation *c)
{
    return sweep_run(c->s, &c->g, &c->written, &c->p, &c->r->sweep);
}

/* Warnings of the end of a run. */
static bool write_ended(compilation *c)
{
    return ended_check(c->s, &c->g, &c->p, c->r->instead.ended);
}

/* The equations for a reader. */
static bool write_equations(compilation *c)
{
    text document = {.memory = c->memory};
    const naming names = naming_of(&c->p, c->memory, NULL);
    const size_t style = index_of_word(c->r->instead.equations, equations_styles, EQUATIONS_STYLES);
    describe_equations(&c->p, &c->g, &names, &c->written, (equations_style)style, &document);
    return c->r->directory == NULL ? write_out(document.bytes, document.length)
                                   : write_file(c->memory, c->r->directory, &document);
}

/* Header and source of the plant, with the files beside them; and its cost on standard output. */
static bool write_plant(compilation *c)
{
    arena *memory = c->memory;
    const request *r = c->r;
    const plant *p = &c->p;
    graph *g = &c->g;
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
    if (is_fmu && !emit_exchange(p, g, &names, c->exchanges, &files)) { /* the slopes of f and g */
        fprintf(stderr, "%s: error: the slopes of the equations contain a number beyond the number type\n", r->scene);
        return false;
    }
    if (is_fmu) {
        emit_fmu(p, g, &names, r->fmi_version, c->exchanges,
                 &files); /* the calls of the standard, and the description of the model */
    }
    if (r->is_standalone) {
        standalone_files(&files, &names, r->is_double, !is_fmu); /* the files of core that these include */
    }
    write_summary(p, g, &summary); /* operations of a derivative and of a step, bytes of state */
    stability_line(p, &summary);
    return write_files(&files) && write_out(summary.bytes, summary.length);
}

product product_of(const request *r)
{
    const products *i = &r->instead;
    return i->files != NULL       ? (product){STAGE_TEXT, write_paths, "--files", true}
           : i->check != NULL     ? (product){STAGE_MECHANISM, write_check, "--check", true}
           : i->effects != NULL   ? (product){STAGE_SCENE, write_effects, "--effects", true}
           : i->shape != NULL     ? (product){STAGE_BODIES, write_shape, "--shape", true}
           : i->dot != NULL       ? (product){STAGE_REQUEST, write_graph, "--dot", true}
           : i->mjcf != NULL      ? (product){STAGE_START, write_mjcf, "--mjcf", true}
           : i->linear != NULL    ? (product){STAGE_PLANT, write_linear, "--linear", false}
           : r->sweep.set != NULL ? (product){STAGE_PLANT, write_sweep, "--sweep", false}
           : i->ended != NULL     ? (product){STAGE_PLANT, write_ended, "--ended", true}
           : i->equations != NULL ? (product){STAGE_LADDER, write_equations, "--equations", false}
                                  : (product){STAGE_LADDER, write_plant, NULL, false};
}
