/* The shape of a mechanism as lines of cells: the data of a picture besides the poses of its bodies. */
#include <string.h>

#include "tools/isoc/mechanism/builder.h"
#include "tools/isoc/scene/parser.h"

static void number_cell(text *out, double number)
{
    text_add(out, "\t%.9g", number + 0.0);
}

static void node_cells(builder *b, text *out, const node *nodes, int count)
{
    for (int i = 0; i < count; i++) {
        number_cell(out, value_now(&b->values, nodes[i]));
    }
}

/* A point, and axes as columns. */
static void frame_cells(builder *b, text *out, const vector *origin, const matrix *turned)
{
    node_cells(b, out, origin->at, 3);
    for (int i = 0; i < 3; i++) {
        node_cells(b, out, turned->at[i], 3);
    }
}

/* Mass, centre of mass, and the inertia about it. */
static void write_lump(builder *b, text *out, size_t owner, const lump *part)
{
    const node all[7] = {part->mass,       part->inertia.xx, part->inertia.yy, part->inertia.zz,
                         part->inertia.xy, part->inertia.xz, part->inertia.yz};
    text_add(out, "lump\t%zu", owner);
    node_cells(b, out, part->com.at, 3);
    node_cells(b, out, all, 7);
    text_add(out, "\n");
}

static void write_solid(builder *b, text *out, size_t owner, const solid *written)
{
    matrix turned;
    vector origin;
    place_joint(b, &written->at, &turned, &origin);
    text_add(out, "solid\t%zu\t%s", owner, written->kind->word);
    frame_cells(b, out, &origin, &turned);
    const value size = value_of(&b->values, written->size, metre, written->kind->numbers, "a size");
    node_cells(b, out, size.parts, size.count);
    text_add(out, "\n");
}

static void write_bodies(builder *b, text *out)
{
    for (size_t i = 0; i < b->written->bodies.count; i++) {
        const body *written = &b->written->bodies.all[i];
        text_add(out, "body\t%s\n", written->name.text);
        for (size_t n = 0; n < b->weights[i].lump_count; n++) {
            if (written->solids.count > 0 && written->solids.all[n].kind->numbers > 0) {
                write_solid(b, out, i, &written->solids.all[n]);
            } else {
                write_lump(b, out, i, &b->weights[i].lumps[n]);
            }
        }
    }
}

/* A place: the body, -1 for the ground, the point, and the axes as columns. */
static void place_cells(builder *b, text *out, const placement *p)
{
    matrix turned;
    vector origin;
    const int on = stand_on(b, p, &turned, &origin);
    text_add(out, "\t%d", on == -2 ? -1 : on);
    frame_cells(b, out, &origin, &turned);
}

static void axis_cells(builder *b, text *out, const formula *f)
{
    double axis[3] = {0.0, 0.0, 0.0};
    if (f != NULL) {
        (void)unit_axis(b, f, axis);
    }
    for (int i = 0; i < 3; i++) {
        number_cell(out, axis[i]);
    }
}

/* Joints, and closures between bodies: both are a connection of two places, about or along an axis of both. */
static void write_connections(builder *b, text *out)
{
    FOR_EACH (const joint, j, b->written->joints) {
        text_add(out, "joint\t%s\t%s", j->name.text, joint_rows[j->kind].word);
        place_cells(b, out, &j->parent);
        place_cells(b, out, &j->child);
        axis_cells(b, out, j->axis);
        text_add(out, "\t%d\n", j->spring != NULL);
    }
    FOR_EACH (const closure_statement, c, b->written->closures) {
        if (acts_along_joints(c->kind)) {
            continue;
        }
        text_add(out, "closure\t%s\t%s", c->name.text, closure_rows[c->kind].word);
        place_cells(b, out, &c->parent);
        place_cells(b, out, &c->child);
        axis_cells(b, out, c->axis);
        number_cell(out,
                    c->radius == NULL ? 0.0 : value_now(&b->values, scalar_value(b, c->radius, metre, "a radius")));
        axis_cells(b, out, c->wheel);
        text_add(out, "\n");
    }
}

static void write_forces(builder *b, text *out)
{
    FOR_EACH (const spring_statement, s, b->written->springs) {
        text_add(out, "spring\t%s", s->name.text);
        place_cells(b, out, &s->first);
        place_cells(b, out, &s->second);
        text_add(out, "\n");
    }
    FOR_EACH (const body_force, f, b->written->forces) {
        text_add(out, "force\t%s\t%s", f->name.text, f->drive.text);
        place_cells(b, out, &f->at);
        axis_cells(b, out, f->axis);
        number_cell(out, value_now(&b->values, scalar_value(b, f->moment, metre, "a moment for each newton")));
        text_add(out, "\n");
    }
}

/* The radius that an effect is given, as a ball has it on the ground; 0 of one without. */
static double radius_of(builder *b, const effect_use *use, const effect_kind *kind)
{
    const quantity *argument = operand_called(use, "radius");
    FOR_ALL (const effect_line, line, kind->lines, kind->line_count) {
        if (line->kind == EFFECT_VALUE && argument != NULL && strcmp(line->name.text, "radius") == 0) {
            return value_now(&b->values, scalar_value(b, argument->value, metre, "a radius"));
        }
    }
    return 0.0;
}

/* The points of bodies that effects act at: one line for each effect that has some, with its radius. */
static void write_effects(builder *b, text *out)
{
    FOR_EACH (const effect_use, use, b->written->effects) {
        const effect_kind *kind = find_effect_kind(b->written, use->kind);
        bool any = false;
        for (size_t i = 0; kind != NULL && !use->left_out && i < kind->line_count; i++) {
            const quantity *argument =
                kind->lines[i].kind == EFFECT_BODY ? operand_in_scene(b->written, use, kind->lines[i].name.text) : NULL;
            if (argument == NULL || argument->value->kind != FORMULA_NAME) {
                continue;
            }
            if (!any) {
                text_add(out, "effect\t%s\t%s", use->name.text, kind->name.text);
                number_cell(out, radius_of(b, use, kind));
            }
            any = true;
            place_cells(
                b, out,
                &(placement){.body = {argument->value->name, argument->value->at}, .position = argument->point});
        }
        text_add(out, any ? "\n" : "");
    }
}

/* The outputs that are places of points, of which a picture can have the way. */
static void write_points(builder *b, text *out)
{
    FOR_EACH (const output, o, b->written->outputs) {
        const formula *f = o->formula;
        if (f == NULL || f->kind != FORMULA_OF || strcmp(f->name, "position") != 0 || f->along.text != NULL ||
            f->count == 0 || f->parts[0] == NULL || f->parts[0]->kind != FORMULA_NAME ||
            (INDEX_OF(b->written->bodies, f->parts[0]->name) < 0 &&
             INDEX_OF(b->written->frames, f->parts[0]->name) < 0)) {
            continue;
        }
        text_add(out, "point\t%s", o->name.text);
        place_cells(
            b, out,
            &(placement){.body = {f->parts[0]->name, f->parts[0]->at}, .position = f->count > 1 ? f->parts[1] : NULL});
        text_add(out, "\n");
    }
}

void shape_cells(builder *b, text *out)
{
    text_add(out, "scene\t%s\ngravity", b->written->name);
    node_cells(b, out, b->mechanism.forces.gravity.at, 3);
    text_add(out, "\nstep\t%.9g\nmethod\t%s\n", b->mechanism.method.step,
             method_names[ISO_METHOD_OF(b->mechanism.method.recipe)]);
    write_bodies(b, out);
    write_connections(b, out);
    write_forces(b, out);
    write_effects(b, out);
    write_points(b, out);
}
