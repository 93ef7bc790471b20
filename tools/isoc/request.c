#include "tools/isoc/request.h"

#include <stdio.h>
#include <string.h>

#include "tools/isoc/scene/parser.h"

bool complain(const char *message, const char *argument)
{
    fprintf(stderr, "isoc: error: %s%s%s\nisoc --help lists the options\n", message, argument == NULL ? "" : " ",
            argument == NULL ? "" : argument);
    return false;
}

/* A plant that firmware or another program steps has no loop of core, of which policies are. */
static void check_policies(const request *r, source *s, const scene *written)
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

/* Products that know no events. */
static void check_events(const request *r, source *s, const mechanism *m)
{
    const char *what = r->instead.linear != NULL ? "a linear model"
                       : r->instead.mjcf != NULL ? "a model for MuJoCo"
                                                 : NULL;
    if (what != NULL && m->events.count > 0) {
        source_problem(s, m->events.all[0].at, "%s has no events: leave out 'when'", what);
    }
}

bool request_fits(const request *r, source *s, const scene *written, const mechanism *m)
{
    check_policies(r, s, written);
    check_events(r, s, m);
    if (s->problem_count > 0) {
        return false;
    }
    if (r->in_place.tolerance != NULL && !ISO_IS(m->method.recipe, ISO_ADAMS)) {
        return complain("--tolerance is of adams; it has no effect on", method_names[ISO_METHOD_OF(m->method.recipe)]);
    }
    if (r->lanes != NULL && ISO_IS(m->method.recipe, ISO_ADAMS)) {
        return complain(
            "--lanes: the steps of each plant with adams are its own, so that plants have none in common; take "
            "another method than",
            "adams");
    }
    if (r->instead.dot == NULL && r->wanted.formulation != FORMULATIONS &&
        !formulation_fits(m, r->wanted.formulation)) {
        return complain(m->closure_count > 0 ? "closed loops have no such formulation:"
                                             : "a tree has no such formulation:",
                        r->scene);
    }
    return true;
}

/* A tolerance comes with a budget of sub-steps that no tick exhausts. */
static formula *budget_without_end(arena *memory)
{
    formula *f = arena_take(memory, 1, sizeof *f);
    *f = (formula){.kind = FORMULA_NUMBER, .number = 1e6, .unit = unit_one};
    return f;
}

/* Whether the method of the scene takes `substeps` for a budget; for others it is a number of parts. */
static bool has_budget(const scene *written)
{
    return name_is(written->method, "adams");
}

/* The formula of an option, where it can be read; else that of the scene. */
static formula *replaced(source *s, scene *written, const char *option, const char *words, formula *own)
{
    formula *read = words == NULL ? NULL : scene_formula(s, written, source_add(s, option, words));
    return read == NULL ? own : read;
}

void override_scene(const request *r, source *s, scene *written)
{
    const replacements *by = &r->in_place;
    const bool had_budget = has_budget(written);
    written->step = replaced(s, written, "--step", by->step, written->step);
    written->method = by->method == NULL ? written->method : scene_word(s, source_add(s, "--method", by->method));
    if (had_budget != has_budget(written)) {
        written->options.substeps = NULL;
    }
    written->options.tolerance = replaced(s, written, "--tolerance", by->tolerance, written->options.tolerance);
    if (by->tolerance != NULL && has_budget(written)) {
        written->options.substeps = budget_without_end(s->memory);
    }
    if (by->set != NULL) {
        scene_set(s, written, source_add(s, "--set", by->set));
    }
    if (by->without != NULL) {
        scene_leave_out(s, written, source_add(s, "--without", by->without));
    }
    for (size_t i = 0; i < written->inputs.count && by->inputs != NULL; i++) {
        written->inputs.all[i].smooth = strcmp(by->inputs, "smooth") == 0;
    }
}
