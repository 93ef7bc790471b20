#include "tools/isoc/sweep/sweep.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/base/dictionary.h"
#include "tools/isoc/base/numbers.h"
#include "tools/isoc/emit/code.h"
#include "tools/isoc/emit/write.h"

enum { MOST_RUNS = 1000000, MOST_PARTS = 256 };

/* The plan, while it is made. */
typedef struct plan {
    const plant *p;
    sweep_variables varied;
    sweep_columns columns;
    uint64_t points, draws, seed; /* of the grid, and runs at each of its points */
    text runs, variations;
    dictionary known; /* the variations by their options */
    int variation_count;
} plan;

/* The shortest decimal that reads back; of a number that was computed, of its first twelve digits. */
static const char *number_text(arena *memory, double number, bool is_round)
{
    return shortest_decimal(memory, is_round ? strtod(arena_format(memory, "%.12g", number), NULL) : number, true);
}

/* The number that isoc reads from these digits with the unit, as a literal of the plant's type; nan where that cannot
 * hold it. */
static const char *literal_of(arena *memory, const sweep_variable *v, const char *digits, bool is_double)
{
    const double number = strtod(digits, NULL) * v->si.numerator / v->si.denominator;
    return real_holds(number, is_double) ? code_decimal(memory, number, is_double) : "nan";
}

static bool is_built_in(const plan *schedule, const sweep_variable *v)
{
    return v->tunable < 0 || schedule->p->m->parameters.is_built_in[v->tunable];
}

/* Chooses the text of each variable in a run: one of the listed values, or a random one. */
static void choose(const plan *schedule, arena *memory, uint64_t run, const char **texts)
{
    uint64_t point = run / schedule->draws;
    for (size_t i = schedule->varied.count; i-- > 0;) {
        const sweep_variable *v = &schedule->varied.all[i];
        if (v->law == SWEEP_LISTED) {
            const sweep_value *is = &v->listed.all[point % v->listed.count];
            point /= v->listed.count;
            texts[i] = is->word != NULL ? is->word : number_text(memory, is->number, is->is_round);
        } else {
            texts[i] = number_text(memory, sweep_draw(schedule->seed, v->name, run, v->law, v->first, v->second), true);
        }
    }
}

static const char *joined(arena *memory, const char *list, const char *sign, const char *more)
{
    return list[0] == '\0' ? more : arena_format(memory, "%s%s%s", list, sign, more);
}

/* The options of isoc for a variation, separated by tabs. */
static const char *options_of(const plan *schedule, arena *memory, const char *const *texts)
{
    const char *options = "", *set = "", *vary = "";
    for (size_t i = 0; i < schedule->varied.count; i++) {
        const sweep_variable *v = &schedule->varied.all[i];
        if (v->sort == SWEEP_METHOD) {
            options = joined(memory, options, "\t", arena_format(memory, "--method\t%s", texts[i]));
        } else if (v->sort == SWEEP_STEP) {
            options = joined(memory, options, "\t", arena_format(memory, "--step\t%s s", texts[i]));
        } else if (is_built_in(schedule, v)) {
            set = joined(memory, set, "; ", arena_format(memory, "%s = %s %s", v->name, texts[i], v->unit_text));
        } else {
            vary = joined(memory, vary, "; ", v->name);
        }
    }
    options = set[0] == '\0' ? options : joined(memory, options, "\t", arena_format(memory, "--set\t%s", set));
    return vary[0] == '\0' ? options : joined(memory, options, "\t", arena_format(memory, "--vary\t%s", vary));
}

/* A line for each run: its variation, and of each variable the text, and the literal where the plant takes it at its
 * start. */
static void add_run(plan *schedule, arena *memory, uint64_t run)
{
    const char **texts = arena_take(memory, schedule->varied.count + 1, sizeof *texts);
    choose(schedule, memory, run, texts);
    const char *options = options_of(schedule, memory, texts);
    const int *known = dictionary_find(&schedule->known, options);
    const int variation = known != NULL ? *known : schedule->variation_count;
    if (known == NULL) {
        text_add(&schedule->variations, "%d%s%s\n", variation, options[0] == '\0' ? "" : "\t", options);
        dictionary_put(&schedule->known, options, schedule->variation_count++);
    }
    text_add(&schedule->runs, "%d", variation);
    for (size_t i = 0; i < schedule->varied.count; i++) {
        const sweep_variable *v = &schedule->varied.all[i];
        text_add(&schedule->runs, "\t%s", texts[i]);
        if (!is_built_in(schedule, v)) {
            text_add(&schedule->runs, "\t%s", literal_of(memory, v, texts[i], schedule->p->is_double));
        }
    }
    text_add(&schedule->runs, "\n");
}

/* The head of the plan, above the runs. */
static void add_head(const plan *schedule, uint64_t runs, text *to)
{
    const output_set *outputs = &schedule->p->outputs;
    text_add(to, "sweep 1\nruns %" PRIu64 "\nparts %" PRIu64 "\n", runs, runs < MOST_PARTS ? runs : MOST_PARTS);
    text_add(to, "plants %d\nvariables %zu\n", schedule->variation_count, schedule->varied.count);
    FOR_EACH (const sweep_variable, v, schedule->varied) {
        static const char *const sorts[] = {"method", "step", "number"};
        text_add(to, "%s\t%s\t%s\t%d\n", v->name, v->unit_text[0] == '\0' ? "1" : v->unit_text, sorts[v->sort],
                 is_built_in(schedule, v) ? -1 : v->tunable);
    }
    text_add(to, "columns %zu\n", schedule->columns.count);
    FOR_EACH (const sweep_column, c, schedule->columns) {
        text_add(to, "%s\t%s\t%s\t%d\n", c->title, c->unit, c->function, c->output);
    }
    text_add(to, "outputs %d\n", outputs->count);
    for (int i = 0; i < outputs->count; i++) {
        text_add(to, "%s%s", i == 0 ? "" : ",", outputs->names[i]);
    }
    text_add(to, "\n");
}

/* A whole number of an option. */
static bool read_whole(const char *typed, uint64_t least, uint64_t most, uint64_t *number)
{
    char *end = NULL;
    errno = 0;
    *number = strtoull(typed, &end, 10);
    return typed[0] >= '0' && typed[0] <= '9' && *end == '\0' && errno == 0 && *number >= least && *number <= most;
}

static bool complain_of(const char *what)
{
    fprintf(stderr, "isoc: error: %s\n", what);
    return false;
}

/* The number of runs, and their seed. */
static bool count_runs(plan *schedule, arena *memory, const sweep_request *r)
{
    bool is_random = false;
    schedule->points = schedule->draws = 1;
    schedule->seed = 1;
    FOR_EACH (const sweep_variable, v, schedule->varied) {
        is_random = is_random || v->law != SWEEP_LISTED;
        if (v->law == SWEEP_LISTED) {
            schedule->points = schedule->points > MOST_RUNS ? schedule->points : schedule->points * v->listed.count;
        }
    }
    if (is_random != (r->runs != NULL)) {
        return complain_of(is_random ? "the set has random values: --runs says how many, such as --runs 1000"
                                     : "--runs has no effect: nothing in the set is random");
    }
    if (r->runs != NULL && !read_whole(r->runs, 1, MOST_RUNS, &schedule->draws)) {
        return complain_of(arena_format(memory, "--runs %s is no number of runs; it could be 1000", r->runs));
    }
    if (r->seed != NULL && !is_random) {
        return complain_of("--seed has no effect: nothing in the set is random");
    }
    if (r->seed != NULL && !read_whole(r->seed, 0, UINT64_MAX, &schedule->seed)) {
        return complain_of(arena_format(memory, "--seed %s is no seed; it could be 1", r->seed));
    }
    if (schedule->points > MOST_RUNS || schedule->points * schedule->draws > MOST_RUNS) {
        return complain_of("a sweep has at most 1000000 runs");
    }
    return true;
}

void sweep_check_varied(source *s, const mechanism *m, const char *vary)
{
    char *names = arena_copy(s->memory, vary == NULL ? "" : vary, vary == NULL ? 0 : strlen(vary));
    for (char *called = strtok(names, "; "); called != NULL; called = strtok(NULL, "; ")) {
        const int i = sweep_tunable_called(m, called);
        if (i < 0 || m->parameters.is_built_in[i]) {
            source_problem(s, m->segments[0].at,
                           "in this variation a number of the plant is made of '%s', and in others it is not: they are "
                           "two sweeps",
                           called);
        }
    }
}

bool sweep_run(source *s, graph *g, const scene *written, const plant *p, const sweep_request *r)
{
    plan schedule = {.p = p, .known = {.memory = s->memory}};
    schedule.runs.memory = schedule.variations.memory = s->memory;
    schedule.varied = sweep_read_variables(s, g, written, p, source_add(s, "--set", r->set));
    schedule.columns = sweep_read_columns(s, p, source_add(s, "--of", r->columns));
    if (s->problem_count > 0) {
        return source_report(s);
    }
    if (!count_runs(&schedule, s->memory, r)) {
        return false;
    }
    const uint64_t runs = schedule.points * schedule.draws;
    for (uint64_t run = 0; run < runs; run++) {
        add_run(&schedule, s->memory, run);
    }
    text whole = {.memory = s->memory};
    add_head(&schedule, runs, &whole);
    text_add(&whole, "%s", schedule.runs.bytes);
    file_list files = {.memory = s->memory, .folder = r->folder};
    file_list_add(&files, "plan", &whole);
    file_list_add(&files, "variations", &schedule.variations);
    return write_files(&files);
}
