/* The compiler: each line is a pass. A pass notes the problems of the source, and goes on with the rest. */
#include "tools/isoc/request.h"

#include "tools/isoc/export/export.h"
#include "tools/isoc/scene/parser.h"
#include "tools/isoc/stability/stability.h"
#include "tools/isoc/tree/tree.h"

static void read_text(compilation *c)
{
    c->is_over = !source_read(c->s, c->memory, c->r->scene);
    c->s->is_silent = c->r->instead.ended != NULL; /* at the end of a run no warning is said again */
    if (!c->is_over) {
        c->written = parse_scene(
            c->s, c->joints); /* statements with their places, also those of repeats and of included files */
    }
}

static void make_scene(compilation *c)
{
    override_scene(c->r, c->s, &c->written);
    c->is_over = !counts_check(c->s, &c->written); /* a plant has at most so many states, inputs, ... */
}

static void make_bodies(compilation *c)
{
    builder *b = &c->b;
    graph_start(&c->g, c->memory, "Constants of the scene");
    *b = builder_of(c->s, &c->g, &c->written, c->r->is_double, c->whole == NULL ? NULL : c->whole->m);
    names_check(c->s, &c->written); /* no two things with one name */
    build_step(b);                  /* of a tick, in whole nanoseconds */
    build_method(b);                /* the recipe */
    build_policies(b);              /* of the loop, about late ticks */
    values_resolve(&b->values);     /* constants and tunables, each after those that it names */
    build_bodies(b);                /* masses and inertias, in parts, each in the axes of its body; gravity */
    connect_joints(b);              /* which body is the child of which */
    build_tree(b);                  /* segments from the ground on, with the bodies that they carry */
    build_frames(b);                /* on their bodies, which are placed */
}

static void make_mechanism(compilation *c)
{
    builder *b = &c->b;
    list_dofs(b);                      /* the degrees of freedom of all segments */
    build_applied_forces(b);           /* of inputs */
    build_springs(b);                  /* between two points */
    build_closures(b);                 /* on segments; clocks of motions are states behind the positions */
    count_effects(b);                  /* room for their states, behind the clocks, and their memories */
    regroup(b);                        /* masses and moments go to the parent where that changes no motion */
    find_time_inputs(b);               /* functions of time in formulas */
    build_inputs(b);                   /* those of the scene, */
    build_time_inputs(b);              /* then one for each of these functions */
    build_effects(b);                  /* operands are bound, lines evaluated: rates, nexts, efforts, forces */
    build_events(b);                   /* of effects and of the scene: conditions, and what they set */
    build_masses(b);                   /* that states of effects give */
    build_substeps(b);                 /* of effects with sub-steps of their own */
    build_outputs(b);                  /* the formula of each */
    finish_history_memories(b);        /* their formulas, which are all known now */
    drop_unread(b);                    /* memories and functions of time that nothing reads */
    check_shares(b);                   /* what shares of a step do not go with */
    build_delays(b);                   /* which of them are samples of continuous signals */
    check_inputs(b);                   /* whether each has a use */
    build_parameters(b);               /* tunables with their limits, then faults */
    build_changes(b);                  /* of tunables and faults, at times */
    states_check(c->s, &b->mechanism); /* no two states with one name */
    check_whole(b);                    /* statements that a scene must have */
}

static void check_request(compilation *c)
{
    c->is_over = !request_fits(c->r, c->s, &c->written, &c->b.mechanism);
}

static void make_start(compilation *c)
{
    assemble(c->s, &c->g, &c->b.mechanism);        /* numbers that satisfy the closures; constants may follow */
    point_queries_resolve(&c->g, &c->b.mechanism); /* of points in formulas: nodes of the states instead of leaves */
}

static void make_plant(compilation *c)
{
    c->p = plant_build(&c->g, &c->b.mechanism, c->r->is_double, c->r->wanted); /* derivative, outputs, factors */
    rows_build(c->s, &c->g, &c->p, c->whole); /* the assignments of a row, in order; starts of effects */
}

/* The checks of a plant, each where those before it hold. */
static void check_plant(compilation *c)
{
    static void (*const checks[])(source * s, const graph *g, const plant *p) = {
        pivots_check,    /* a joint moves no inertia: the mass matrix is singular */
        range_check,     /* a constant is beyond the number type */
        start_check,     /* the derivative is not finite in that type */
        stability_check, /* the Jacobian is not finite; warns where method and step do not hold the plant */
        pace_check,      /* warns of joints that turn too far in a step */
    };
    sweep_check_varied(c->s, c->p.m, c->r->vary); /* tunables that runs set */
    c->exchanges = c->r->fmi_version == 3 && exchange_fits(c->s, &c->written, &c->g, &c->p, c->r->exchange != NULL);
    for (size_t i = 0; i < COUNT_OF(checks) && c->s->problem_count == 0; i++) {
        checks[i](c->s, &c->g, &c->p);
    }
    if (c->s->problem_count == 0 && c->r->in_place.inputs == NULL) {
        samples_check(c->s, &c->g, &c->written, &c->p); /* warns where held inputs lower the order of the method */
    }
    if (c->s->problem_count == 0) {
        switching_check(c->s, &c->g, &c->p); /* warns of effects that jump within a step */
        meetings_check(c->s, &c->g, &c->p);  /* warns of events that follow each other within one, or do not happen */
    }
}

/* The plant of each drop of a ladder: the same passes, with a scene in which the effects that are dropped so far do
 * nothing. */
static void make_ladder(compilation *c)
{
    plant *p = &c->p;
    const policies *ladder = &p->m->policies;
    const char *suffix = "_without";
    p->reduced_plant_count = ladder->drop_count;
    p->reduced_plants = arena_take(c->memory, (size_t)ladder->drop_count + 1, sizeof *p->reduced_plants);
    scene written = c->written;
    for (int i = 0; i < ladder->drop_count; i++) {
        compilation *reduced = arena_take(c->memory, 1, sizeof *reduced);
        written.effects.all =
            list_copy(c->memory, written.effects.all, written.effects.count, sizeof *written.effects.all);
        for (int n = 0; n < (int)written.effects.count; n++) {
            written.effects.all[n].dropped |= is_within_use(&written, n, ladder->drops[i]);
        }
        *reduced = (compilation){.memory = c->memory, .r = c->r, .s = c->s, .written = written, .whole = p};
        make_bodies(reduced);
        make_mechanism(reduced);
        make_start(reduced);
        make_plant(reduced);
        suffix = arena_format(c->memory, "%s_%s", suffix, written.effects.all[ladder->drops[i]].symbol);
        p->reduced_plants[i] = (reduced_plant){&reduced->p, &reduced->g, suffix};
    }
}

/* The passes that a product needs; of --check with joints of this kind. */
static compilation *passed(arena *memory, const request *r, const char *joints)
{
    static void (*const stages[STAGES])(compilation * c) = {
        [STAGE_TEXT] = read_text,           [STAGE_SCENE] = make_scene,      [STAGE_BODIES] = make_bodies,
        [STAGE_MECHANISM] = make_mechanism, [STAGE_REQUEST] = check_request, [STAGE_START] = make_start,
        [STAGE_PLANT] = make_plant,         [STAGE_CHECKS] = check_plant,    [STAGE_LADDER] = make_ladder,
    };
    source *s = arena_take(memory, 1, sizeof *s);
    compilation *c = arena_take(memory, 1, sizeof *c);
    *s = (source){0};
    *c = (compilation){.memory = memory, .r = r, .s = s, .joints = joints};
    for (int i = 0; i <= (int)product_of(r).needs && !c->is_over; i++) {
        stages[i](c);
        c->is_over = c->is_over || (i >= STAGE_REQUEST && s->problem_count > 0); /* up to there all problems are told */
    }
    return c;
}

bool compile(arena *memory, const request *r)
{
    const product wanted = product_of(r);
    const bool is_check = r->instead.check != NULL;
    compilation *c = passed(memory, r, is_check ? "revolute" : NULL);
    if (is_check && c->s->problem_count > 0) { /* it may be for joints that slide */
        compilation *other = passed(memory, r, "prismatic");
        c = other->s->problem_count < c->s->problem_count ? other : c;
    }
    const bool is_right = !c->is_over && (c->s->problem_count == 0 || wanted.needs == STAGE_TEXT);
    return is_right ? wanted.write(c) : source_report(c->s);
}
