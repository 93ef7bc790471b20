#include "tools/isoc/scene/parser.h"

#include <string.h>

/* A body or a frame, with the forces that inputs put on it. */
static void draw_node(const scene *written, name called, const char *shape, text *out)
{
    text_add(out, "    \"%s\" [%slabel=\"%s", called.text, shape, called.text);
    FOR_EACH (const body_force, f, written->forces) {
        if (name_is(f->at.body, called.text)) {
            text_add(out, "\\nforce %s: %s", f->name.text, f->drive.text);
        }
    }
    text_add(out, "\"];\n");
}

/* The ground, bodies, and frames on their parents. */
static void draw_bodies(const scene *written, text *out)
{
    text_add(out, "    \"ground\" [shape=plain];\n");
    for (size_t i = 0; i < written->bodies.count; i++) {
        draw_node(written, written->bodies.all[i].name, "", out);
    }
    FOR_EACH (const named_frame, f, written->frames) {
        draw_node(written, f->name, "shape=ellipse, ", out);
        text_add(out, "    \"%s\" -> \"%s\" [style=dotted, arrowhead=none];\n", f->on.body.text, f->name.text);
    }
}

/* The states of the joint, closure or effect that is declared there, three in a line. */
static void draw_states(const name_list *states, place at, text *out)
{
    int drawn = 0;
    FOR_EACH (const name, called, *states) {
        if (called->at == at) {
            text_add(out, "%s%s", drawn == 0 ? "\\nstates: " : drawn % 3 == 0 ? ",\\n" : ", ", called->text);
            drawn++;
        }
    }
}

/* A joint leads from the parent to the child. */
static void draw_joint(const joint *j, const name_list *states, text *out)
{
    text_add(out, "    \"%s\" -> \"%s\" [label=\"%s\\n%s%s", j->parent.body.text, j->child.body.text, j->name.text,
             joint_rows[j->kind].word, j->continuous ? ", continuous" : "");
    draw_states(states, j->name.at, out);
    if (j->damping != NULL || j->spin_damping != NULL) {
        text_add(out, "\\ndamping");
    }
    if (j->spring != NULL) {
        text_add(out, "\\nspring");
    }
    if (j->drive.text != NULL) {
        text_add(out, "\\ndrive: %s", j->drive.text);
    }
    text_add(out, "\"];\n");
}

/* The joint of this name, or that has a part of this name: JOINT_PART. */
static const joint *joint_of(const scene *written, name n)
{
    const joint *whole = NULL, *of_part = NULL;
    FOR_EACH (const joint, j, written->joints) {
        const size_t length = strlen(j->name.text);
        if (name_is(j->name, n.text)) {
            whole = j;
        } else if (strncmp(j->name.text, n.text, length) == 0 && n.text[length] == '_') {
            of_part = j;
        }
    }
    return whole != NULL ? whole : of_part;
}

/* A closure connects two bodies. One between joints connects the bodies that these move: a gear two children, a motion
 * a child and its parent. */
static void draw_closure(const scene *written, const closure_statement *c, const name_list *states, text *out)
{
    const char *from = c->parent.body.text, *to = c->child.body.text;
    if (acts_along_joints(c->kind)) {
        const joint *first = joint_of(written, c->first);
        to = first->child.body.text;
        from = c->kind == CLOSE_GEAR ? joint_of(written, c->second)->child.body.text : first->parent.body.text;
    }
    text_add(out, "    \"%s\" -> \"%s\" [style=dashed, arrowhead=none, constraint=false, label=\"%s\\n%s", from, to,
             c->name.text, closure_rows[c->kind].word);
    draw_states(states, c->name.at, out);
    text_add(out, "\"];\n");
}

/* A spring leads from one end to the other. */
static void draw_spring(const spring_statement *s, text *out)
{
    text_add(out, "    \"%s\" -> \"%s\" [arrowhead=none, constraint=false, label=\"%s\\nspring%s\"];\n",
             s->first.body.text, s->second.body.text, s->name.text, s->damping != NULL ? ", damping" : "");
}

void dot_write(const scene *written, const name_list *states, text *out)
{
    text_add(out, "digraph \"%s\" {\n    nodesep=0.7;\n    node [shape=box, fontname=\"sans-serif\"];\n",
             written->name);
    text_add(out, "    edge [fontname=\"sans-serif\", fontsize=10];\n");
    draw_bodies(written, out);
    for (size_t i = 0; i < written->joints.count; i++) {
        draw_joint(&written->joints.all[i], states, out);
    }
    for (size_t i = 0; i < written->closures.count; i++) {
        draw_closure(written, &written->closures.all[i], states, out);
    }
    for (size_t i = 0; i < written->springs.count; i++) {
        draw_spring(&written->springs.all[i], out);
    }
    text_add(out, "}\n");
}
