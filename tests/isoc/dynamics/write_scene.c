/* Writes the scenes of generated mechanisms, FOLDER/tree_1.scene and FOLDER/loop_1.scene to those of the last seed.
 * Each shows force and moment of every joint, then of every closure, then the effort of every coupling, then power and
 * balance: write_scene FOLDER SEEDS. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/isoc/dynamics/generate.h"
#include "tests/isoc/dynamics/wide3.h"

#define PI 3.14159265358979323846264338327950288L

static const char *const kind_words[] = {"fixed",     "revolute", "prismatic", "universal", "cylindrical", "planar",
                                         "spherical", "free",     "line",      "distance",  "rolling"};

static void write_vector(FILE *const to, const wide v[3], const char *const unit)
{
    fprintf(to, " (%.17Lg, %.17Lg, %.17Lg) %s", v[0], v[1], v[2], unit);
}

static void write_placement(FILE *const to, const char *const side, const int body, const placement *const p)
{
    if (body == GROUND) {
        fprintf(to, " %s ground at", side);
    } else {
        fprintf(to, " %s b%d at", side, body);
    }
    write_vector(to, p->at, "m");
    fprintf(to, " rotate %.17Lg deg about", p->degrees);
    write_vector(to, p->axis, ";");
}

/* The numbers of coordinates or speeds that slide, as a vector: of a planar joint along the two axes that follow the
 * normal.
 */
static void write_slides(FILE *const to, const tree_joint *const joint, const wide *const numbers,
                         const char *const unit)
{
    wide v[3] = {numbers[0], 0.0L, 0.0L};
    if (joint->kind == FREE) {
        memcpy(v, numbers, sizeof v);
    } else if (joint->kind == PLANAR) {
        const int normal = joint->axis[0] != 0.0L ? 0 : joint->axis[1] != 0.0L ? 1 : 2;
        v[normal] = 0.0L;
        v[(normal + 1) % 3] = numbers[0];
        v[(normal + 2) % 3] = numbers[1];
    }
    if (joint->kind == CYLINDRICAL) {
        fprintf(to, " %.17Lg %s", numbers[0], unit);
    } else {
        write_vector(to, v, unit);
    }
}

static void write_start(FILE *const to, const tree_joint *const joint, const wide *const q, const wide *const v)
{
    const joint_kind kind = joint->kind;
    const int sliding = coordinate_slides(kind, 2)   ? 3
                        : coordinate_slides(kind, 1) ? 2
                        : coordinate_slides(kind, 0) ? 1
                                                     : 0;
    const int turning = joint_speeds(kind) - sliding;
    if (has_one_coordinate(kind)) {
        const char *const of = kind == REVOLUTE ? "rad" : "m";
        fprintf(to, " start %.17Lg %s; speed %.17Lg %s/s;", q[0], of, v[0], of);
        return;
    }
    fprintf(to, " start");
    if (sliding > 0) {
        fprintf(to, " at");
        write_slides(to, joint, q, "m");
    }
    if (turning == 3) {
        const wide *const turn = q + sliding;
        fprintf(to, " quaternion (%.17Lg, %.17Lg, %.17Lg, %.17Lg)", turn[0], turn[1], turn[2], turn[3]);
    }
    for (int k = 0; k < turning && turning < 3; k++) {
        fprintf(to, " rotate %.17Lg rad", q[sliding + k]);
    }
    if (sliding > 0) {
        fprintf(to, "; speed");
        write_slides(to, joint, v, "m/s");
    }
    const wide *const spin = v + sliding;
    if (turning == 3) {
        fprintf(to, "; spin");
        write_vector(to, spin, "rad/s;");
    } else if (turning == 2) {
        fprintf(to, "; spin (%.17Lg, %.17Lg) rad/s;", spin[0], spin[1]);
    } else {
        fprintf(to, "; spin %.17Lg rad/s;", spin[0]);
    }
}

static void write_joint(FILE *const to, const generated *const made, const int j)
{
    const tree_joint *const joint = &made->mechanism.joint[j];
    const bool turns = joint->kind == REVOLUTE;
    fprintf(to, "joint j%d %s {", j, kind_words[joint->kind]);
    write_placement(to, "parent", joint->parent, &joint->on_parent);
    write_placement(to, "child", j, &joint->on_child);
    if (joint->kind != FIXED && joint->kind != SPHERICAL && joint->kind != FREE) {
        fprintf(to, " axis");
        write_vector(to, joint->axis, ";");
    }
    if (joint->kind == UNIVERSAL) {
        fprintf(to, " second");
        write_vector(to, joint->second, ";");
    }
    if (joint->kind != FIXED) {
        write_start(to, joint, made->start.q[j], made->start.v[j]);
    }
    if (joint->damping > 0.0L && joint->kind != SPHERICAL && joint->kind != UNIVERSAL) {
        fprintf(to, " damping %.17Lg %s;", joint->damping, turns ? "N*m*s/rad" : "N*s/m");
    }
    if (joint->spin_damping > 0.0L) {
        fprintf(to, " spin_damping %.17Lg N*m*s/rad;", joint->spin_damping);
    }
    if (joint->stiffness > 0.0L) {
        fprintf(to, " spring %.17Lg %s rest %.17Lg %s;", joint->stiffness, turns ? "N*m/rad" : "N/m", joint->rest,
                turns ? "rad" : "m");
    }
    fprintf(to, "%s }\n", joint->input > 0 ? " drive u2;" : "");
}

static void write_closure(FILE *const to, const generated *const made, const int n)
{
    const loop_closure *const c = &made->mechanism.closure[n];
    fprintf(to, "close c%d %s {", n, kind_words[c->kind]);
    write_placement(to, "parent", c->parent, &c->on_parent);
    write_placement(to, "child", c->child, &c->on_child);
    if (c->kind == REVOLUTE || c->kind == PRISMATIC || c->kind == LINE || c->kind == ROLLING) {
        fprintf(to, " axis");
        write_vector(to, c->axis, ";");
    }
    if (c->kind == DISTANCE && n == 0 && made->has_reach) {
        fprintf(to, " length reach;");
    } else if (c->kind == DISTANCE || c->kind == ROLLING) {
        fprintf(to, " %s %.17Lg m;", c->kind == DISTANCE ? "length" : "radius", c->length);
    }
    if (dot(c->wheel, c->wheel) > 0.0L) {
        fprintf(to, " wheel");
        write_vector(to, c->wheel, ";");
    }
    fprintf(to, " }\n");
}

static void write_coupling(FILE *const to, const mechanism *const m, const int n)
{
    const coupling *const c = &m->coupling[n];
    const bool turns = m->joint[c->first].kind == REVOLUTE;
    if (c->second == GROUND) {
        fprintf(to, "close k%d motion { first j%d; motion %.17Lg %s * sin(%.17Lg Hz, %.17Lg rad) }\n", n, c->first,
                c->swing, turns ? "rad" : "m", c->omega / (2.0L * PI), c->phase);
        return;
    }
    const bool other = m->joint[c->second].kind == REVOLUTE;
    fprintf(to, "close k%d gear { first j%d; second j%d; ratio %.17Lg%s }\n", n, c->first, c->second, c->ratio,
            turns == other ? ""
            : turns        ? " rad/m"
                           : " m/rad");
}

static void write_head(FILE *const to, const generated *const made)
{
    const mechanism *const m = &made->mechanism;
    fprintf(to, "gravity");
    write_vector(to, m->gravity, "m/s^2");
    fprintf(to, "\nstep 1 ms\ninput u1\n%s", made->inputs > 1 ? "input u2\n" : "");
    if (made->has_load) {
        fprintf(to, "tunable load = %.17Lg kg\n", m->body[m->bodies - 1].mass);
    }
    if (made->has_reach) {
        fprintf(to, "tunable reach = %.17Lg m\n", m->closure[0].length);
    }
    if (made->stabilisation != NULL) {
        fprintf(to, "stabilisation %s\n", made->stabilisation);
    }
}

static void write_body(FILE *const to, const generated *const made, const int i)
{
    const rigid_body *const b = &made->mechanism.body[i];
    if (i == made->mechanism.bodies - 1 && made->has_load) {
        fprintf(to, "body b%d { mass load; com", i);
    } else {
        fprintf(to, "body b%d { mass %.17Lg kg; com", i, b->mass);
    }
    write_vector(to, b->com, "m");
    fprintf(to, "; inertia (%.17Lg, %.17Lg, %.17Lg; %.17Lg, %.17Lg, %.17Lg) kg*m^2 }\n", b->inertia[0], b->inertia[1],
            b->inertia[2], b->inertia[3], b->inertia[4], b->inertia[5]);
}

static void write_force(FILE *const to, const applied_force *const force)
{
    fprintf(to, "force push { body b%d at", force->body);
    write_vector(to, force->at, "m; axis");
    write_vector(to, force->axis, ";");
    fprintf(to, " drive u1; moment %.17Lg m }\n", force->lever);
}

static void write_outputs(FILE *const to, const mechanism *const m)
{
    for (int j = 0; j < m->bodies; j++) {
        fprintf(to, "output force_%d = force of j%d\noutput moment_%d = moment of j%d\n", j, j, j, j);
    }
    for (int n = 0; n < m->closures; n++) {
        fprintf(to, "output closing_force_%d = force of c%d\noutput closing_moment_%d = moment of c%d\n", n, n, n, n);
    }
    for (int n = 0; n < m->couplings; n++) {
        fprintf(to, "output effort_%d = effort of k%d\n", n, n);
    }
    fprintf(to, "output power = power\noutput balance = balance\n");
}

static void write_scene(const generated *const made, FILE *const to)
{
    const mechanism *const m = &made->mechanism;
    write_head(to, made);
    for (int i = 0; i < m->bodies; i++) {
        write_body(to, made, i);
    }
    for (int j = 0; j < m->bodies; j++) {
        write_joint(to, made, j);
    }
    for (int n = 0; n < m->closures; n++) {
        write_closure(to, made, n);
    }
    for (int n = 0; n < m->couplings; n++) {
        write_coupling(to, m, n);
    }
    write_force(to, &m->applied_force[0]);
    write_outputs(to, m);
}

/* False if there is no such mechanism, or no such file. */
static bool write_file(const char *const folder, const bool is_loop, const int seed)
{
    static generated made;
    static char path[1024];
    const char *const kind = is_loop ? "loop" : "tree";
    snprintf(path, sizeof path, "%s/%s_%d.scene", folder, kind, seed);
    FILE *const to = generate(is_loop, seed, &made) ? fopen(path, "w") : NULL;
    if (to == NULL) {
        return false;
    }
    fprintf(to, "# A random %s, of seed %d.\n", kind, seed);
    write_scene(&made, to);
    return fclose(to) == 0;
}

int main(const int count, char **const arguments)
{
    const int seeds = count == 3 ? atoi(arguments[2]) : 0;
    for (int seed = 1; seed <= seeds; seed++) {
        if (!write_file(arguments[1], false, seed) || !write_file(arguments[1], true, seed)) {
            fprintf(stderr, "write_scene FOLDER SEEDS: no scene of seed %d\n", seed);
            return EXIT_FAILURE;
        }
    }
    return seeds > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
