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
static void refuse_policies(const request *r, source *s, const policy_statement *written)
{
    const struct {
        bool is_there;
        place at;
        const char *words;
    } statements[] = {
        {written->overrun != OVERRUN_COUNT, written->overrun_at, "overrun"},
        {written->grace != NULL, written->grace == NULL ? 0 : written->grace->at, "grace"},
        {written->delayed, written->publish_at, "publish next_tick"},
        {written->histogram, written->histogram_at, "histogram"},
    };
    const bool is_firmware = r->name != NULL || r->is_standalone;
    const char *why = is_firmware ? "--name or --standalone a plant has none, and the firmware that calls "
                                    "iso_plant_tick times its ticks"
                                  : "--lanes plants have none, and the program that calls iso_lanes_tick times their "
                                    "ticks";
    for (size_t i = 0; i < COUNT_OF(statements) && (is_firmware || r->lanes != NULL); i++) {
        if (statements[i].is_there) {
            source_problem(s, statements[i].at, "%s is for the loop of `isochron run`; with %s: leave it out",
                           statements[i].words, why);
        }
    }
}

/* Products that know no events. */
static void check_events(const request *r, source *s, const mechanism *m)
{
    const char *what = r->instead.linear != NULL ? "a linear model"
                       : r->instead.mjcf != NULL ? "a model for MuJoCo"
                                                 : NULL;
    if (what != NULL && has_events(m)) {
        source_problem(s, place_of_events(m), "%s has no events: leave out 'when'", what);
    }
}

bool request_fits(const request *r, source *s, const scene *written, const mechanism *m)
{
    refuse_policies(r, s, &written->policies);
    check_events(r, s, m);
    if (s->problem_count > 0) {
        return false;
    }
    if (r->in_place.tolerance != NULL && !ISO_IS(m->method.recipe, ISO_ADAMS)) {
        return complain("--tolerance is for adams; it has no effect on", method_names[ISO_METHOD_OF(m->method.recipe)]);
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

/* The formula of an option, where it can be read; else that of the scene. */
static formula *replaced(source *s, scene *written, const char *option, const char *words, formula *own)
{
    formula *read = words == NULL ? NULL : scene_formula(s, written, source_add(s, option, words));
    return read == NULL ? own : read;
}

void override_scene(const request *r, source *s, scene *written)
{
    const replacements *by = &r->in_place;
    const bool was_adams = name_is(written->method, "adams");
    written->step = replaced(s, written, "--step", by->step, written->step);
    if (by->method != NULL) {
        const script *word = source_add(s, "--method", by->method);
        written->method = (name){word->text, source_passage(s, word, 0, word->length, NULL)};
    }
    const bool is_adams = name_is(written->method, "adams");
    if (was_adams != is_adams) {
        written->options.substeps = NULL; /* a budget is no number of parts */
    }
    written->options.tolerance = replaced(s, written, "--tolerance", by->tolerance, written->options.tolerance);
    if (by->tolerance != NULL && is_adams) {
        written->options.substeps = replaced(s, written, "--tolerance", "1000000", NULL); /* a budget without end */
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
