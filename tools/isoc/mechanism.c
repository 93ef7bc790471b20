#include "tools/isoc/mechanism.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "tools/isoc/inertia.h"
#include "tools/isoc/names.h"

static const dimension plain = {0, 0, 0, 0}, kilogram = {1, 0, 0, 0}, metre = {0, 1, 0, 0}, second = {0, 0, 1, 0},
                       radian = {0, 0, 0, 1}, newton = {1, 1, -2, 0}, newton_metre = {1, 2, -2, 0},
                       moment_of_inertia = {1, 2, 0, 0}, acceleration = {0, 1, -2, 0};

static const double largest_angle = 1e4; /* rad: the domain of core/sincos.h */

/* What a body brings to its link. */
typedef struct solid {
    node mass;
    vector com;
    tensor inertia; /* about the centre of mass */
    int joint;      /* whose child it is, or -1 */
} solid;

typedef struct builder {
    source *s;
    graph *g;
    const scene *written;
    values values;
    solid *solids;
    int *parents, *children; /* of the joints: bodies; -2 the ground, -1 unknown */
    mechanism made;
} builder;

static vector vector_value(builder *b, const formula *f, dimension of, const char *what)
{
    vector r = vector_zero(b->g);
    if (f != NULL) {
        const value v = value_of(&b->values, f, of, 3, what);
        for (int i = 0; i < 3 && v.count == 3; i++) {
            r.at[i] = v.parts[i];
        }
    }
    return r;
}

static node scalar_value(builder *b, const formula *f, dimension of, const char *what)
{
    node r = constant(b->g, 0.0);
    if (f != NULL) {
        const value v = value_of(&b->values, f, of, 1, what);
        r = v.count == 1 ? v.parts[0] : r;
    }
    return r;
}

/* --- bodies --- */

static tensor inertia_value(builder *b, const body *written)
{
    const node zero = constant(b->g, 0.0);
    tensor t = tensor_zero(b->g);
    if (written->inertia == NULL) {
        return t;
    }
    const value v = value_of(&b->values, written->inertia, moment_of_inertia, 0, "an inertia");
    if (v.count == 0) {
        return t;
    }
    const bool full = v.count == 6;
    t = (tensor){v.parts[0],
                 v.parts[1],
                 v.parts[2],
                 full ? v.parts[3] : zero,
                 full ? v.parts[4] : zero,
                 full ? v.parts[5] : zero};
    const node parts[6] = {t.xx, t.yy, t.zz, t.xy, t.xz, t.yz};
    double numbers[6];
    for (int i = 0; i < 6; i++) {
        numbers[i] = value_now(&b->values, parts[i]);
    }
    const char *fault = inertia_fault(numbers);
    if (fault != NULL) {
        source_problem(b->s, written->inertia->at, "the inertia of '%s' %s", written->name.text, fault);
    }
    return t;
}

static void build_bodies(builder *b)
{
    for (size_t i = 0; i < b->written->body_count; i++) {
        const body *written = &b->written->bodies[i];
        solid *made = &b->solids[i];
        made->joint = -1;
        if (written->mass == NULL && !written->broken) {
            source_problem(b->s, written->name.at, "the body '%s' has no mass: mass 1 kg", written->name.text);
        }
        const size_t problems = b->s->problem_count;
        made->mass = scalar_value(b, written->mass, kilogram, "a mass");
        if (written->mass != NULL && b->s->problem_count == problems && !(value_now(&b->values, made->mass) > 0.0)) {
            source_problem(b->s, written->mass->at, "a mass is larger than zero");
        }
        made->com = vector_value(b, written->com, metre, "a centre of mass");
        made->inertia = inertia_value(b, written);
    }
}

/* --- joints, one by one --- */

static void refuse(builder *b, const formula *f, const char *property, const char *why)
{
    if (f != NULL) {
        source_problem(b->s, f->at, "%s %s", property, why);
    }
}

/* What a kind of joint cannot have. */
static void check_properties(builder *b, const joint *j)
{
    if (j->kind == JOINT_FIXED) {
        static const char why[] = "on a fixed joint, which does not move";
        refuse(b, j->axis, "an axis", why);
        refuse(b, j->start, "a start", why);
        refuse(b, j->speed, "a speed", why);
        refuse(b, j->damping, "damping", why);
        refuse(b, j->spring, "a spring", why);
        if (j->drive.text != NULL) {
            source_problem(b->s, j->drive.at, "a drive %s", why);
        }
    } else if (j->axis == NULL && !j->broken) {
        source_problem(b->s, j->name.at, "the joint '%s' has no axis: axis z", j->name.text);
    }
    if (j->continuous && j->kind != JOINT_REVOLUTE) {
        source_problem(b->s, j->continuous_at, "only a revolute joint is continuous");
    } else if (j->continuous) {
        refuse(b, j->spring, "a spring", "on a continuous joint, whose angle starts anew each turn");
    }
}

static int resolve_end(builder *b, const joint *j, const placement *end, const char *which)
{
    if (end->body.text == NULL) {
        if (!j->broken) {
            source_problem(b->s, j->name.at, "the joint '%s' has no %s", j->name.text, which);
        }
        return -1;
    }
    return find_body(b->s, b->written, end->body);
}

/* Which bodies a joint connects; a body is the child of one joint. */
static void connect(builder *b, size_t i)
{
    const joint *j = &b->written->joints[i];
    b->parents[i] = resolve_end(b, j, &j->parent, "parent");
    const int child = b->children[i] = resolve_end(b, j, &j->child, "child");
    if (child == -2) {
        source_problem(b->s, j->child.body.at, "the ground is nobody's child: swap parent and child");
        b->children[i] = -1;
    } else if (child >= 0 && child == b->parents[i]) {
        source_problem(b->s, j->child.body.at, "a joint of '%s' with itself", j->child.body.text);
        b->children[i] = -1;
    } else if (child >= 0 && b->solids[child].joint >= 0) {
        const name *first = &b->written->joints[b->solids[child].joint].name;
        source_problem(b->s, j->child.body.at, "'%s' is the child of joint '%s' in line %zu already: a loop",
                       j->child.body.text, first->text, source_line(b->s, first->at));
        b->children[i] = -1;
    } else if (child >= 0) {
        b->solids[child].joint = (int)i;
    }
}

/* The unit vector of an axis; false if there is none. */
static bool unit_axis(builder *b, const formula *f, double axis[3])
{
    const value v = value_of(&b->values, f, plain, 3, "an axis");
    if (v.count == 0) {
        return false;
    }
    double square = 0.0;
    for (int i = 0; i < 3; i++) {
        if (!is_constant(b->g, v.parts[i])) {
            source_problem(b->s, f->at, "an axis cannot depend on a tunable parameter");
            return false;
        }
        axis[i] = constant_value(b->g, v.parts[i]);
        square += axis[i] * axis[i];
    }
    if (!(square > 0.0) || !isfinite(square)) {
        source_problem(b->s, f->at, "the axis has no direction: its length is %s", square > 0.0 ? "infinite" : "zero");
        return false;
    }
    const double length = sqrt(square);
    for (int i = 0; i < 3; i++) {
        axis[i] /= length;
    }
    return true;
}

/* The turn by an angle about a unit axis (Rodrigues 1840): c 1 + s [a]x + (1 - c) a a'. */
static matrix rodrigues(graph *g, const double a[3], double angle)
{
    const double s = constant_value(g, sine(g, constant(g, angle)));
    const double c = constant_value(g, cosine(g, constant(g, angle)));
    matrix r;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double cross = i == j ? 0.0 : (j == (i + 1) % 3 ? -1.0 : 1.0) * a[3 - i - j];
            r.at[i][j] = constant(g, (i == j ? c : 0.0) + s * cross + (1.0 - c) * a[i] * a[j]);
        }
    }
    return matrix_snap(g, r);
}

/* The joint's frame on a body: R = R1 R2 ..., and its origin. */
static void place_joint(builder *b, const placement *p, matrix *turn_made, vector *origin)
{
    *origin = vector_value(b, p->position, metre, "a position");
    *turn_made = matrix_identity(b->g);
    for (size_t i = 0; i < p->turn_count; i++) {
        double axis[3];
        if (p->turns[i].angle == NULL || p->turns[i].axis == NULL || !unit_axis(b, p->turns[i].axis, axis)) {
            continue;
        }
        double angle = value_constant(&b->values, p->turns[i].angle, radian, "an angle", 0.0);
        if (fabs(angle) > largest_angle) {
            source_problem(b->s, p->turns[i].angle->at, "an angle beyond %g rad", largest_angle);
            angle = 0.0;
        }
        *turn_made = matrix_snap(b->g, matrix_product(b->g, *turn_made, rodrigues(b->g, axis, angle)));
    }
}

/* Turns the frame so that the axis is one of its own: *k and *sign say which. The identity for x, y, z, -x, -y, -z. */
static matrix align(graph *g, const double a[3], int *k, double *sign)
{
    for (int i = 0; i < 3; i++) {
        if (fabs(a[i]) == 1.0) {
            *k = i;
            *sign = a[i];
            return matrix_identity(g);
        }
    }
    /* z along the axis, x across it and across the coordinate axis that is farthest from it. */
    int far = 0;
    for (int i = 1; i < 3; i++) {
        far = fabs(a[i]) < fabs(a[far]) ? i : far;
    }
    const int i = (far + 1) % 3, j = (far + 2) % 3;
    const double length = sqrt(a[i] * a[i] + a[j] * a[j]);
    double x[3] = {0.0}, y[3];
    x[i] = a[j] / length;
    x[j] = -a[i] / length;
    for (int n = 0; n < 3; n++) {
        y[n] = a[(n + 1) % 3] * x[(n + 2) % 3] - a[(n + 2) % 3] * x[(n + 1) % 3];
    }
    matrix r;
    for (int row = 0; row < 3; row++) {
        r.at[row][0] = constant(g, x[row]);
        r.at[row][1] = constant(g, y[row]);
        r.at[row][2] = constant(g, a[row]);
    }
    *k = 2;
    *sign = 1.0;
    return r;
}

static int find_drive(builder *b, const joint *j)
{
    return j->drive.text == NULL ? -1 : find_input(b->s, b->written, j->drive);
}

/* Coordinate, start and effects of a moving joint. */
static void build_coordinate(builder *b, const joint *j, link *made)
{
    const bool turns = j->kind == JOINT_REVOLUTE;
    const dimension coordinate = turns ? radian : metre, effort = turns ? newton_metre : newton;
    dimension speed = coordinate, stiffness = effort, resistance = effort;
    dimension_times(&speed, second, -1);
    dimension_times(&stiffness, coordinate, -1);
    dimension_times(&resistance, speed, -1);

    made->start = value_constant(&b->values, j->start, coordinate, "the start of this joint", 0.0);
    if (turns && fabs(made->start) > (j->continuous ? 3.14159265358979323846 : largest_angle)) {
        source_problem(b->s, j->start->at, "the start is beyond %s", j->continuous ? "180 deg" : "10000 rad");
    }
    made->speed = value_constant(&b->values, j->speed, speed, "the speed of this joint", 0.0);
    made->damping = scalar_value(b, j->damping, resistance, "the damping of this joint");
    made->spring = scalar_value(b, j->spring, stiffness, "the spring of this joint");
    made->rest = scalar_value(b, j->rest, coordinate, "the rest of this spring");
    made->drive = find_drive(b, j);
    if (value_now(&b->values, made->damping) < 0.0) {
        source_problem(b->s, j->damping->at, "damping is not negative: it takes energy away");
    }
}

/* --- the tree --- */

/* Adds a body to its link, or to the ground, as it stands there. */
static void weld(builder *b, const solid *part, const body_frame *frame)
{
    graph *g = b->g;
    const vector com = vector_add(g, matrix_apply(g, frame->turn, part->com), frame->offset);
    const vector moment = vector_scale(g, part->mass, com);
    if (frame->link == GROUND) {
        b->made.ground_mass = add(g, b->made.ground_mass, part->mass);
        b->made.ground_moment = vector_add(g, b->made.ground_moment, moment);
        return;
    }
    link *l = &b->made.links[frame->link];
    const tensor turned = tensor_rotate(g, frame->turn, part->inertia);
    l->inertia = tensor_add(g, l->inertia, tensor_shift(g, turned, part->mass, vector_zero(g), com));
    l->first_moment = vector_add(g, l->first_moment, moment);
    l->mass = add(g, l->mass, part->mass);
}

/* Hangs the child of a joint on its parent, whose frame is known. */
static void hang(builder *b, size_t i)
{
    graph *g = b->g;
    const joint *j = &b->written->joints[i];
    const body_frame ground = {GROUND, matrix_identity(g), vector_zero(g), true};
    const body_frame parent = b->parents[i] == -2 ? ground : b->made.frames[b->parents[i]];
    body_frame *child = &b->made.frames[b->children[i]];

    matrix on_parent, on_child, aligned = matrix_identity(g);
    vector at_parent, at_child;
    place_joint(b, &j->parent, &on_parent, &at_parent);
    place_joint(b, &j->child, &on_child, &at_child);

    link made = {.name = j->name.text,
                 .at = j->name.at,
                 .parent = parent.link,
                 .kind = j->kind,
                 .continuous = j->continuous,
                 .sign = 1.0};
    double axis[3];
    if (j->kind != JOINT_FIXED && j->axis != NULL && unit_axis(b, j->axis, axis)) {
        aligned = align(g, axis, &made.axis, &made.sign);
    }
    /* The joint's frame, aligned with its axis, in the parent's link; and the child's body in it. */
    const matrix to_link = matrix_product(g, on_parent, aligned);
    made.turn = matrix_snap(g, matrix_product(g, parent.turn, to_link));
    made.offset = vector_add(g, matrix_apply(g, parent.turn, at_parent), parent.offset);
    const matrix from_child = matrix_transpose(matrix_product(g, on_child, aligned));
    const vector child_origin = matrix_apply(g, from_child, vector_sub(g, vector_zero(g), at_child));

    if (j->kind == JOINT_FIXED) {
        *child = (body_frame){parent.link, matrix_snap(g, matrix_product(g, made.turn, from_child)),
                              vector_add(g, matrix_apply(g, made.turn, child_origin), made.offset), true};
    } else {
        made.mass = constant(g, 0.0);
        made.first_moment = vector_zero(g);
        made.inertia = tensor_zero(g);
        build_coordinate(b, j, &made);
        *child = (body_frame){b->made.link_count, matrix_snap(g, from_child), child_origin, true};
        b->made.links[b->made.link_count++] = made;
    }
    weld(b, &b->solids[b->children[i]], child);
}

/* Hangs joints on what is placed, the first declared first, until none is left that can be. */
static void build_tree(builder *b)
{
    const size_t joints = b->written->joint_count;
    bool *hung = arena_take(b->s->memory, joints + 1, sizeof *hung);
    for (bool going = true; going;) {
        going = false;
        for (size_t i = 0; i < joints && !going; i++) {
            const int parent = b->parents[i];
            const bool placed = parent == -2 || (parent >= 0 && b->made.frames[parent].placed);
            if (!hung[i] && placed && b->children[i] >= 0) {
                hang(b, i);
                hung[i] = going = true;
            }
        }
    }
    /* What is left hangs on itself or on something unknown. */
    for (size_t i = 0; i < joints; i++) {
        int above = (int)i;
        size_t steps = 0;
        while (above >= 0 && b->parents[above] >= 0 && steps++ <= joints) {
            above = b->solids[b->parents[above]].joint;
        }
        if (!hung[i] && b->children[i] >= 0 && steps > joints) {
            source_problem(b->s, b->written->joints[i].name.at,
                           "the joint '%s' is part of a loop that no joint ties to the ground",
                           b->written->joints[i].name.text);
        }
    }
    bool known = !b->written->broken;
    for (size_t i = 0; i < joints; i++) {
        known = known && b->children[i] >= 0 && !b->written->joints[i].broken;
    }
    for (size_t i = 0; i < b->written->body_count && known; i++) {
        if (b->solids[i].joint < 0) {
            source_problem(b->s, b->written->bodies[i].name.at,
                           "the body '%s' is no joint's child: it hangs on nothing", b->written->bodies[i].name.text);
        }
    }
}

/* --- base parameters --- */

/* Adds mass, first moment and inertia about the origin of a link's frame to what the link hangs on. */
static void move_to_parent(builder *b, const link *from, node mass, vector ms, tensor inertia)
{
    graph *g = b->g;
    const vector turned = matrix_apply(g, from->turn, ms);
    const vector moment = vector_add(g, turned, vector_scale(g, mass, from->offset));
    if (from->parent == GROUND) {
        b->made.ground_mass = add(g, b->made.ground_mass, mass);
        b->made.ground_moment = vector_add(g, b->made.ground_moment, moment);
        return;
    }
    link *to = &b->made.links[from->parent];
    const tensor shifted = tensor_shift(g, tensor_rotate(g, from->turn, inertia), mass, turned, from->offset);
    to->inertia = tensor_add(g, to->inertia, shifted);
    to->first_moment = vector_add(g, to->first_moment, moment);
    to->mass = add(g, to->mass, mass);
}

/* What a joint's motion does not change is as well a part of the parent (Gautier and Khalil 1990, "Direct calculation of
 * minimum set of inertial parameters of serial robots", IEEE Trans. Robotics Automation 6(3)): about a revolute axis
 * the mass, the first moment along the axis and equal moments across it; of a prismatic joint the whole inertia. The
 * motion stays the same to the last term, and most of each link's parameters are zero. */
static void regroup(builder *b)
{
    graph *g = b->g;
    const node zero = constant(g, 0.0);
    for (int i = b->made.link_count - 1; i >= 0; i--) {
        link *l = &b->made.links[i];
        if (l->kind == JOINT_PRISMATIC) {
            move_to_parent(b, l, zero, vector_zero(g), l->inertia);
            l->inertia = tensor_zero(g);
            continue;
        }
        node *const diagonal[3] = {&l->inertia.xx, &l->inertia.yy, &l->inertia.zz};
        node *const one = diagonal[(l->axis + 1) % 3], *const other = diagonal[(l->axis + 2) % 3];
        const node across = *other;
        tensor ring = {across, across, across, zero, zero, zero};
        node *const of_ring[3] = {&ring.xx, &ring.yy, &ring.zz};
        *of_ring[l->axis] = zero;
        vector along = vector_zero(g);
        along.at[l->axis] = l->first_moment.at[l->axis];

        move_to_parent(b, l, l->mass, along, ring);
        *one = sub(g, *one, across);
        *other = zero;
        l->first_moment.at[l->axis] = zero;
        l->mass = zero;
    }
}

/* --- inputs and outputs --- */

static void build_inputs(builder *b)
{
    mechanism *made = &b->made;
    made->input_count = (int)b->written->input_count;
    made->input_names = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->input_names);
    made->jumps = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->jumps);
    made->drives = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->drives);
    b->values.time_allowed = true;
    graph_section(b->g, "Inputs as functions of time");
    for (int i = 0; i < made->input_count; i++) {
        const quantity *q = &b->written->inputs[i];
        bool force = false, torque = false;
        for (size_t j = 0; j < b->written->joint_count; j++) {
            const joint *user = &b->written->joints[j];
            if (user->drive.text != NULL && q->name.text != NULL && strcmp(user->drive.text, q->name.text) == 0) {
                force = force || user->kind == JOINT_PRISMATIC;
                torque = torque || user->kind == JOINT_REVOLUTE;
            }
        }
        if (q->name.text == NULL || (!force && !torque && b->written->broken)) {
            continue;
        }
        if (!force && !torque) {
            source_problem(b->s, q->name.at, "the input '%s' drives no joint: write 'drive %s' in one", q->name.text,
                           q->name.text);
        } else if (force && torque) {
            source_problem(b->s, q->name.at, "the input '%s' drives a revolute and a prismatic joint", q->name.text);
        }
        made->input_names[i] = q->name.text;
        const dimension effort = torque ? newton_metre : newton;
        const char *what = torque ? "a torque" : "a force";
        made->drives[i] = scalar_value(b, force || torque ? q->value : NULL, effort, what);
        made->jumps[i] = value_constant(&b->values, force || torque ? q->jump : NULL, effort, what, 0.0);
        if (q->jump != NULL && !(made->jumps[i] > 0.0)) {
            source_problem(b->s, q->jump->at, "a jump is larger than zero");
        }
    }
    b->values.time_allowed = false;
}

static void check_joint_output(builder *b, const output *o, const joint *j)
{
    if (j->kind == JOINT_FIXED) {
        source_problem(b->s, o->of.at, "the joint '%s' is fixed: it has no coordinate", o->of.text);
    } else if (o->kind == OUTPUT_VELOCITY) {
        source_problem(b->s, o->kind_at, "a joint has a speed; a velocity is a body's");
    } else if (o->kind == OUTPUT_TURNS && !j->continuous) {
        source_problem(b->s, o->kind_at, "only a continuous joint counts its turns");
    }
    refuse(b, o->point, "a point", "of a joint: only a body has points");
    if (o->along >= 0) {
        source_problem(b->s, o->along_at, "'along' with a joint: only a body's position and velocity have components");
    }
}

static int link_of_joint(const mechanism *made, const char *joint_name)
{
    for (int i = 0; i < made->link_count; i++) {
        if (strcmp(made->links[i].name, joint_name) == 0) {
            return i;
        }
    }
    return -1;
}

static void build_outputs(builder *b)
{
    const scene *written = b->written;
    mechanism *made = &b->made;
    made->outputs = written->outputs;
    made->output_count = written->output_count;
    made->points = arena_take(b->s->memory, written->output_count + 1, sizeof *made->points);
    made->output_link = arena_take(b->s->memory, written->output_count + 1, sizeof *made->output_link);
    made->output_body = arena_take(b->s->memory, written->output_count + 1, sizeof *made->output_body);
    for (size_t i = 0; i < written->output_count; i++) {
        const output *o = &written->outputs[i];
        made->output_link[i] = made->output_body[i] = -1;
        made->points[i] = vector_value(b, o->point, metre, "a point");
        bool is_joint = false;
        const int of =
            o->kind == OUTPUT_ENERGY || o->of.text == NULL ? -1 : find_joint_or_body(b->s, written, o->of, &is_joint);
        if (of >= 0 && is_joint) {
            check_joint_output(b, o, &written->joints[of]);
            made->output_link[i] = link_of_joint(made, written->joints[of].name.text);
        } else if (of >= 0) {
            made->output_body[i] = of;
            if (o->kind != OUTPUT_POSITION && o->kind != OUTPUT_VELOCITY) {
                source_problem(b->s, o->kind_at, "a body has a position and a velocity; this is a joint's");
            }
        }
    }
}

static void build_parameters(builder *b)
{
    const scene *written = b->written;
    mechanism *made = &b->made;
    made->parameter_names = arena_take(b->s->memory, written->parameter_count + 1, sizeof *made->parameter_names);
    for (size_t i = 0; i < written->parameter_count; i++) {
        if (written->parameters[i].tunable) {
            made->parameter_names[made->parameter_count++] = written->parameters[i].name.text;
        }
    }
    made->defaults = b->values.defaults;
}

/* --- method and step --- */

const char *const method_names[ISO_METHODS + 1] = {
    [ISO_EULER] = "euler",
    [ISO_HEUN] = "heun",
    [ISO_RK4] = "rk4",
    [ISO_AB4] = "ab4",
    [ISO_SEMI_IMPLICIT] = "semi_implicit",
    [ISO_ABM4] = "abm4",
    [ISO_ABM4_PEC] = "abm4_pec",
    [ISO_ABM4_PECECE] = "abm4_pecece",
    [ISO_BDF4] = "bdf4",
    [ISO_ROSENBROCK] = "rosenbrock",
    [ISO_ADAMS] = "adams",
};

static bool is_yes(builder *b, name word)
{
    const bool yes = word.text != NULL && strcmp(word.text, "yes") == 0;
    if (word.text != NULL && !yes && strcmp(word.text, "no") != 0) {
        source_problem(b->s, word.at, "expected yes or no; found '%s'", word.text);
    }
    return yes;
}

static unsigned find_method(builder *b, name word)
{
    if (word.text == NULL) {
        return ISO_RK4;
    }
    for (unsigned i = 0; i <= ISO_METHODS; i++) {
        if (strcmp(word.text, method_names[i]) == 0) {
            return i;
        }
    }
    const char *list = "";
    for (unsigned i = 0; i <= ISO_METHODS; i++) {
        list = arena_format(b->s->memory, "%s%s%s", list, i == 0 ? "" : ", ", method_names[i]);
    }
    source_problem(b->s, word.at, "no method is called '%s'%s; there are %s", word.text,
                   source_suggestion(b->s, word.text, method_names, ISO_METHODS + 1), list);
    return ISO_RK4;
}

/* What adams may do in a tick: a tolerance, and a budget of sub-steps. */
static void build_adams(builder *b)
{
    const scene *written = b->written;
    b->made.tolerance = value_constant(&b->values, written->tolerance, plain, "a tolerance", 1e-6);
    b->made.substeps =
        value_constant(&b->values, written->substeps, plain, "the number of sub-steps", ISO_ADAMS_BUDGET);
    if (!(b->made.tolerance > 0.0)) {
        source_problem(b->s, written->tolerance->at, "a tolerance is larger than zero");
    }
    if (!(b->made.substeps >= 1.0 && b->made.substeps <= 1e6) || b->made.substeps != floor(b->made.substeps)) {
        source_problem(b->s, written->substeps->at, "sub-steps are a whole number from 1 to 1000000");
    }
}

/* The method with its options: an output of the local error asks for the check as `checked yes` does. */
static void build_method(builder *b)
{
    const scene *written = b->written;
    unsigned recipe = find_method(b, written->method);
    recipe |= is_yes(b, written->compensated) ? ISO_COMPENSATED : 0U;
    recipe |= is_yes(b, written->checked) ? ISO_CHECKED : 0U;
    for (size_t i = 0; i < written->output_count; i++) {
        const output *o = &written->outputs[i];
        recipe |= o->kind == OUTPUT_LOCAL_ERROR ? ISO_CHECKED : 0U;
        if (o->kind == OUTPUT_RESIDUAL && !ISO_IS(recipe, ISO_BDF4)) {
            source_problem(b->s, o->kind_at, "only bdf4 has a residual, of its Newton iteration");
        }
    }
    if (written->iterations != NULL) {
        const double count = value_constant(&b->values, written->iterations, plain, "the number of iterations", 2.0);
        if (!(count >= 1.0 && count <= 10.0) || count != floor(count)) {
            source_problem(b->s, written->iterations->at, "iterations are a whole number from 1 to 10");
        } else {
            recipe |= ISO_ITERATIONS((unsigned)count);
        }
    }
    b->made.recipe = recipe;
    build_adams(b);
}

static void build_step(builder *b)
{
    const formula *f = b->written->step;
    b->made.step = value_constant(&b->values, f, second, "the step", 1e-3);
    if (f != NULL && !(b->made.step >= 1e-6 && b->made.step <= 1.0)) {
        source_problem(b->s, f->at, "a step is between 1 us and 1 s");
        b->made.step = 1e-3;
    }
    b->values.step = b->made.step;
}

void mechanism_method_and_step(source *s, graph *g, const scene *written)
{
    builder b = {.s = s, .g = g, .written = written};
    values_start(&b.values, s, g, written);
    build_step(&b);
    build_method(&b);
}

mechanism mechanism_build(source *s, graph *g, const scene *written)
{
    builder b = {.s = s, .g = g, .written = written};
    b.solids = arena_take(s->memory, written->body_count + 1, sizeof *b.solids);
    b.parents = arena_take(s->memory, written->joint_count + 1, sizeof *b.parents);
    b.children = arena_take(s->memory, written->joint_count + 1, sizeof *b.children);
    b.made = (mechanism){.name = written->name, .ground_mass = constant(g, 0.0), .ground_moment = vector_zero(g)};
    b.made.links = arena_take(s->memory, written->joint_count + 1, sizeof *b.made.links);
    b.made.frames = arena_take(s->memory, written->body_count + 1, sizeof *b.made.frames);
    values_start(&b.values, s, g, written);

    names_check(s, written);
    build_step(&b);
    build_method(&b);
    values_resolve(&b.values);
    b.made.gravity = vector_value(&b, written->gravity, acceleration, "gravity");
    build_bodies(&b);
    for (size_t i = 0; i < written->joint_count; i++) {
        check_properties(&b, &written->joints[i]);
        connect(&b, i);
    }
    build_tree(&b);
    regroup(&b);
    build_inputs(&b);
    build_outputs(&b);
    build_parameters(&b);

    if (written->broken) {
        return b.made;
    }
    bool moves = false;
    for (size_t i = 0; i < written->joint_count; i++) {
        moves = moves || written->joints[i].kind != JOINT_FIXED;
    }
    if (written->step == NULL) {
        source_problem(s, s->length, "the scene has no step: step 1 ms");
    }
    if (!moves) {
        source_problem(s, s->length, "nothing moves: the scene has no body on a revolute or prismatic joint");
    }
    if (written->output_count == 0) {
        source_problem(s, s->length, "the scene has no output: output angle = position of a joint");
    }
    return b.made;
}
