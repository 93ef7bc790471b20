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

bool request_fits(const request *r, const mechanism *m)
{
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

/* Reads --step, --method and --tolerance as statements of the scene, and reports their problems at once. */
static bool override_statements(arena *memory, const request *r, scene *s)
{
    const replacements *by = &r->in_place;
    if (by->step == NULL && by->method == NULL && by->tolerance == NULL) {
        return true;
    }
    const char *step = by->step == NULL ? "" : arena_format(memory, "step %s\n", by->step);
    const char *method = by->method == NULL ? step : arena_format(memory, "%smethod %s\n", step, by->method);
    const char *named = by->method != NULL ? by->method : s->method.text;
    const bool was_adams = s->method.text != NULL && strcmp(s->method.text, "adams") == 0;
    const bool is_adams = named != NULL && strcmp(named, "adams") == 0;
    const char *words = by->tolerance == NULL ? method
                                              : arena_format(memory, "%stolerance %s\n%s", method, by->tolerance,
                                                             is_adams ? "substeps 1000000\n" : "");
    source line = source_of_text(memory, "command line", words);
    const scene read = parse_scene(&line);
    graph g;
    graph_start(&g, memory, "");
    mechanism_method_and_step(&line, &g, &read, r->is_double);
    (void)source_report(&line);
    if (was_adams != is_adams) {
        s->options.substeps = NULL; /* a budget is no number of parts */
    }
    s->step = read.step == NULL ? s->step : read.step;
    s->method = read.method.text == NULL ? s->method : read.method;
    s->options.tolerance = read.options.tolerance == NULL ? s->options.tolerance : read.options.tolerance;
    s->options.substeps = read.options.substeps == NULL ? s->options.substeps : read.options.substeps;
    return line.problem_count == 0;
}

bool override_scene(arena *memory, const request *r, source *s, scene *written)
{
    if (!override_statements(memory, r, written)) {
        return false;
    }
    if (r->in_place.set != NULL) {
        scene_set(s, written, source_add(s, "--set", r->in_place.set));
    }
    if (r->in_place.without != NULL) {
        scene_leave_out(s, written, source_add(s, "--without", r->in_place.without));
    }
    for (size_t i = 0; i < written->inputs.count && r->in_place.inputs != NULL; i++) {
        written->inputs.all[i].smooth = strcmp(r->in_place.inputs, "smooth") == 0;
    }
    return true;
}
