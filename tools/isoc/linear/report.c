#include "tools/isoc/linear/linear.h"

#include <math.h>
#include <string.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/emit/write.h"

static labels labels_of_coordinates(const linear_model *l, arena *memory)
{
    labels result = {.count = l->c.count};
    result.names = arena_take(memory, (size_t)result.count + 1, sizeof *result.names);
    result.units = arena_take(memory, (size_t)result.count + 1, sizeof *result.units);
    for (int i = 0; i < result.count; i++) {
        result.names[i] = l->c.coordinates[l->c.chosen[i]].name;
        result.units[i] = l->c.coordinates[l->c.chosen[i]].unit;
    }
    return result;
}

/* One of A, B, C, D. */
typedef struct matrix_part {
    const char *name;
    const double *at;
    const labels *rows, *columns;
    bool is_rate;
} matrix_part;

/* --- tables --- */

/* In parentheses where it is a product or a quotient. */
static const char *whole_unit(arena *memory, const char *words)
{
    return strpbrk(words, "*/ ") == NULL ? words : arena_format(memory, "(%s)", words);
}

/* rad/s^2/N: of the rate of a speed by a force. */
static const char *unit_of_entry(arena *memory, const matrix_part *m, int i, int k)
{
    const char *words = m->rows->units[i];
    const char *row = strchr(words, ' ') == NULL ? words : whole_unit(memory, words);
    return arena_format(memory, "%s/%s", m->is_rate ? unit_of_rate(memory, row) : row,
                        whole_unit(memory, m->columns->units[k]));
}

static void add_table(text *to, arena *memory, const matrix_part *m)
{
    for (int i = 0; i < m->rows->count; i++) {
        for (int k = 0; k < m->columns->count; k++) {
            text_add(to, "%s\t%s\t%s\t%.17g\t%s\n", m->name, m->rows->names[i], m->columns->names[k],
                     m->at[i * m->columns->count + k] + 0.0, unit_of_entry(memory, m, i, k));
        }
    }
}

static void add_state_table(text *to, const linear_model *l)
{
    text_add(to, "state\tunit\tvalue\trate\tof\tmeaning\n");
    for (int i = 0; i < l->c.count; i++) {
        const coordinate *is = &l->c.coordinates[l->c.chosen[i]];
        text_add(to, "%s\t%s\t%.17g\t%.17g\t%s\t%s\n", is->name, is->unit, is->state < 0 ? 0.0 : l->at.x[is->state],
                 l->rates[i], is->whose, is->meaning);
    }
}

static void add_mode_table(text *to, arena *memory, const linear_model *l, const mode_list *modes)
{
    text_add(to, "re\tim\tunit\twords\tstate\tof\tby\n");
    FOR_EACH (const mode, eigenmode, *modes) {
        int first = 0;
        for (int k = 0; k < l->c.count; k++) {
            first = eigenmode->part[k] > eigenmode->part[first] ? k : first;
        }
        const coordinate *is = &l->c.coordinates[l->c.chosen[first]];
        text_add(to, "%.17g\t%.17g\t1/s\t%s\t%s\t%s\t%s\n", eigenmode->re, eigenmode->im, mode_words(memory, eigenmode),
                 is->name, is->whose, eigenmode->by == NULL ? "" : eigenmode->by);
    }
}

/* --- programs --- */

/* The signs of a language around lists. */
typedef struct language {
    const char *comment, *list, *list_end, *row, *row_end, *quote;
    bool is_python;
} language;

static void add_names(text *to, const language *in, const char *called, const char *const *all, int count)
{
    text_add(to, "%s = %s", called, in->is_python ? "[" : "{");
    for (int i = 0; i < count; i++) {
        text_add(to, "%s%s%s%s", i == 0 ? "" : ", ", in->quote, all[i], in->quote);
    }
    text_add(to, "%s\n", in->is_python ? "]" : "};");
}

static void add_matrix(text *to, const language *in, const matrix_part *m)
{
    const int rows = m->rows->count, columns = m->columns->count;
    if (rows == 0 || columns == 0) {
        if (in->is_python) {
            text_add(to, "%s = [[] for _ in range(%d)]\n", m->name, rows);
        } else {
            text_add(to, "%s = zeros(%d, %d);\n", m->name, rows, columns);
        }
        return;
    }
    text_add(to, "%s = %s\n", m->name, in->list);
    for (int i = 0; i < rows; i++) {
        text_add(to, "    %s", in->row);
        for (int k = 0; k < columns; k++) {
            text_add(to, "%s%.17g", k == 0 ? "" : ", ", m->at[i * columns + k] + 0.0);
        }
        text_add(to, "%s\n", in->row_end);
    }
    text_add(to, "%s\n", in->list_end);
}

static void add_numbers(text *to, const language *in, const char *called, const double *at, int count)
{
    text_add(to, "%s = [", called);
    for (int i = 0; i < count; i++) {
        text_add(to, "%s%.17g", i == 0 ? "" : ", ", at[i]);
    }
    text_add(to, "]%s\n", in->is_python ? "" : ";");
}

static void add_program(text *to, const linear_model *l, const language *in, const matrix_part *all, const char *head)
{
    static const char *const sides[] = {"state", "input", "output"};
    const labels *sets[] = {all[0].rows, all[1].columns, all[2].rows};
    arena *memory = to->memory;
    text_add(to, "%s %s: d' = A d + B v, w = C d + D v, in SI units; made by isoc\n", in->comment, head);
    for (int i = 0; i < 3; i++) {
        add_names(to, in, arena_format(memory, "%s_names", sides[i]), sets[i]->names, sets[i]->count);
        add_names(to, in, arena_format(memory, "%s_units", sides[i]), sets[i]->units, sets[i]->count);
    }
    for (int i = 0; i < 4; i++) {
        add_matrix(to, in, &all[i]);
    }
    double *at = arena_take(memory, (size_t)l->c.count + 1, sizeof *at);
    for (int i = 0; i < l->c.count; i++) {
        const int which = l->c.coordinates[l->c.chosen[i]].state;
        at[i] = which < 0 ? 0.0 : l->at.x[which];
    }
    text_add(to, "%s The point: d, v and w are deviations from it\n", in->comment);
    add_numbers(to, in, "state_point", at, l->c.count);
    add_numbers(to, in, "input_point", l->at.u, l->e->inputs);
    add_numbers(to, in, "output_point", l->outputs, l->e->outputs);
    add_numbers(to, in, "state_rates", l->rates, l->c.count);
}

/* --- the points for measurements on the plant --- */

static void add_line(text *to, const char *word, const double *at, int count)
{
    text_add(to, "%s %d", word, count);
    for (int i = 0; i < count; i++) {
        text_add(to, " %.17g", at[i]);
    }
    text_add(to, "\n");
}

static void add_labels(text *to, const char *word, const labels *list)
{
    text_add(to, "%s %d\n", word, list->count);
    for (int i = 0; i < list->count; i++) {
        text_add(to, "%s\t%s\n", list->names[i], list->units[i]);
    }
}

/* The point, the states by the coordinates and the other way, and the model. */
static void add_point(text *to, const linear_model *l, const matrix_part *all, const double *range)
{
    const chart *c = &l->c;
    const mechanism *m = l->e->p->m;
    add_line(to, "x", l->at.x, c->states);
    add_line(to, "u", l->at.u, held_count(m));
    add_line(to, "p", l->at.p, m->parameters.count);
    add_labels(to, "states", all[0].rows);
    add_labels(to, "inputs", all[1].columns);
    add_labels(to, "outputs", all[2].rows);
    add_line(to, "up", l->up, c->states * c->count);
    add_line(to, "down", l->down, c->states * c->count);
    for (int i = 0; i < 4; i++) {
        add_line(to, all[i].name, all[i].at, all[i].rows->count * all[i].columns->count);
    }
    add_line(to, "rates", l->rates, c->count);
    add_line(to, "modes", range, 3);
}

/* --- the summary --- */

static void add_left_out(text *to, const linear_model *l)
{
    const plant *p = l->e->p;
    const mechanism *m = p->m;
    bool *read = arena_take(to->memory, (size_t)(held_count(m) + l->e->states) + 1, sizeof *read);
    mark_leaves(&l->e->l.g, l->e->l.values, (size_t)l->e->roots, OP_INPUT, read);
    const char *names = "";
    for (int i = 0; i < m->effects.memory_count; i++) {
        if (read[m->inputs.count + i]) {
            names = arena_format(to->memory, "%s%s%s", names, names[0] == '\0' ? "" : ", ",
                                 m->effects.memories[i].about.name);
        }
    }
    if (names[0] != '\0') {
        text_add(to,
                 "left_out %s: sampled parts, which keep their values here; what acts through them is not in the "
                 "model\n",
                 names);
    }
    if (m->clocks.count > 0) {
        text_add(to, "left_out time: motions that follow it stand still here\n");
    }
    FOR_ALL (const kink, k, l->kinks, l->kink_count) {
        text_add(to, "kink %s by %s: its slope is %.4g below and %.4g above this point; the model has the mean\n",
                 k->target, k->by, k->below, k->above);
    }
}

static void add_tangent(text *to, const linear_model *l)
{
    const chart *c = &l->c;
    if (c->count == c->all) {
        return;
    }
    text_add(to, "independent");
    for (int i = 0; i < c->count; i++) {
        text_add(to, " %s", c->coordinates[c->chosen[i]].name);
    }
    text_add(to, " (the other %d coordinates follow from these by the closures)\n", c->all - c->count);
}

/* Whether nothing depends on the coordinate. */
static bool is_cyclic(const linear_model *l, int which)
{
    bool is = true;
    for (int i = 0; i < l->c.count; i++) {
        is = is && fabs(l->a[i * l->c.count + which]) <= 1e-12;
    }
    return is;
}

/* The coordinate with the largest rate, by the largest slope of that; of those that nothing depends on, or of the
 * others. -1: none has one. */
static int fastest(const linear_model *l, bool of_cyclic)
{
    const chart *c = &l->c;
    double most = 1e-7;
    int found = -1;
    for (int i = 0; i < c->count; i++) {
        double scale = 1.0;
        for (int k = 0; k < c->count; k++) {
            scale = fmax(scale, fabs(l->a[i * c->count + k]));
        }
        if (fabs(l->rates[i]) / scale > most && is_cyclic(l, i) == of_cyclic) {
            most = fabs(l->rates[i]) / scale;
            found = i;
        }
    }
    return found;
}

static void add_equilibrium(text *to, const linear_model *l)
{
    const int changes = fastest(l, false), goes_on = fastest(l, true), which = changes < 0 ? goes_on : changes;
    if (which < 0) {
        text_add(to, "equilibrium yes\n");
        return;
    }
    const coordinate *is = &l->c.coordinates[l->c.chosen[which]];
    text_add(to, "equilibrium %s %s of %s is %.4g %s%s\n", changes < 0 ? "steady: the rate of" : "no: the rate of",
             is->name, is->whose, l->rates[which], unit_of_rate(to->memory, is->unit),
             changes < 0 ? ", and nothing depends on where it is"
                         : "; the model is of small deviations from this motion, now");
}

/* The kind of the point, and its numbers where isoc found them. */
static void add_point_text(text *to, const linear_model *l, const linear_request *r)
{
    const mechanism *m = l->e->p->m;
    text_add(to, "point %s%s\n", r->trim == NULL ? "" : "an equilibrium, from ",
             r->state == NULL ? "the start" : "a state of the run");
    for (int i = 0; i < m->inputs.count && r->trim != NULL; i++) {
        text_add(to, "input %s %.6g %s\n", m->inputs.all[i].name, l->at.u[i] + 0.0, m->inputs.all[i].unit);
    }
    for (int i = 0; i < l->c.count && r->trim != NULL; i++) {
        const coordinate *is = &l->c.coordinates[l->c.chosen[i]];
        if (is->state >= 0 && fabs(l->at.x[is->state]) > 1e-12) {
            text_add(to, "state %s %.6g %s\n", is->name, l->at.x[is->state], is->unit);
        }
    }
}

/* The coordinates that make up most of a mode, at most three. */
static void add_parts(text *to, const linear_model *l, const mode *eigenmode)
{
    double last = 2.0;
    int before = -1, first = 0;
    for (int n = 0; n < 3; n++) {
        int next = -1;
        for (int k = 0; k < l->c.count; k++) {
            const bool is_less = eigenmode->part[k] < last || (eigenmode->part[k] <= last && k > before);
            next = is_less && (next < 0 || eigenmode->part[k] > eigenmode->part[next]) ? k : next;
        }
        if (next < 0 ||
            (n > 0 && (eigenmode->part[next] < 0.3 * eigenmode->part[first] || eigenmode->part[next] < 0.1))) {
            break;
        }
        const coordinate *is = &l->c.coordinates[l->c.chosen[next]];
        text_add(to, "%s%s of %s", n == 0 ? "" : ", ", is->name, is->whose);
        last = eigenmode->part[next];
        before = next;
        first = n == 0 ? next : first;
    }
}

static void add_modes(text *to, const linear_model *l, const mode_list *modes)
{
    FOR_EACH (const mode, eigenmode, *modes) {
        text_add(to, "mode %.6g", eigenmode->is_neutral ? 0.0 : eigenmode->re);
        if (eigenmode->im > 0.0) {
            text_add(to, " +- %.6g i", eigenmode->im);
        }
        text_add(to, " 1/s %s: ", mode_words(to->memory, eigenmode));
        add_parts(to, l, eigenmode);
        text_add(to, "%s%s\n", eigenmode->by == NULL ? "" : "; by ", eigenmode->by == NULL ? "" : eigenmode->by);
    }
}

/* The words for a whole plant. */
static void add_verdict(text *to, const linear_model *l, const mode_list *modes)
{
    const mode *first = modes->count > 0 ? &modes->all[0] : NULL;
    if (first == NULL || (!first->is_neutral && first->re < 0.0)) {
        text_add(to, "stable: every deviation decays\n");
    } else if (first->is_neutral) {
        text_add(to, "neutral: nothing grows, and something does not decay\n");
    } else {
        text_add(to, "unstable: %s: ", mode_words(to->memory, first));
        add_parts(to, l, first);
        text_add(to, "\n");
    }
}

/* The least and the largest size of an eigenvalue that is not zero, and the largest real part. */
static void find_range(const mode_list *modes, double *range)
{
    FOR_EACH (const mode, eigenmode, *modes) {
        const double size = modulus(eigenmode->re, eigenmode->im);
        if (!(eigenmode->is_neutral && !(eigenmode->im > 0.0))) {
            range[0] = range[0] > 0.0 ? fmin(range[0], size) : size;
            range[1] = fmax(range[1], size);
            range[2] = fmax(range[2], eigenmode->re);
        }
    }
}

bool linear_write(source *s, const graph *g, const plant *p, const linear_model *l, const linear_request *r)
{
    static const language octave = {"%", "[", "];", "", ";", "'", false},
                          python = {"#", "[", "]", "[", "],", "\"", true};
    arena *memory = s->memory;
    const labels states = labels_of_coordinates(l, memory), inputs = labels_of(p, memory, TRIM_INPUT),
                 outputs = labels_of(p, memory, TRIM_OUTPUT);
    const matrix_part all[] = {{"A", l->a, &states, &states, true},
                               {"B", l->b, &states, &inputs, true},
                               {"C", l->cy, &outputs, &states, false},
                               {"D", l->d, &outputs, &inputs, false}};
    const mode_list modes = modes_find(g, l);
    double range[3] = {0.0, 0.0, 0.0};
    file_list files = {.memory = memory, .folder = r->folder};
    text matrices = {.memory = memory}, rows = matrices, eigen = matrices, m = matrices, py = matrices, at = matrices,
         summary = matrices;
    find_range(&modes, range);
    text_add(&matrices, "matrix\trow\tcolumn\tvalue\tunit\n");
    for (int i = 0; i < 4; i++) {
        add_table(&matrices, memory, &all[i]);
    }
    add_state_table(&rows, l);
    add_mode_table(&eigen, memory, l, &modes);
    add_program(&m, l, &octave, all, p->m->name);
    text_add(&m, "%% sys = ss(A, B, C, D);\n");
    add_program(&py, l, &python, all, p->m->name);
    add_point(&at, l, all, range);
    file_list_add(&files, "matrices.tsv", &matrices);
    file_list_add(&files, "states.tsv", &rows);
    file_list_add(&files, "modes.tsv", &eigen);
    file_list_add(&files, "linear_model.m", &m);
    file_list_add(&files, "linear_model.py", &py);
    file_list_add(&files, "point.txt", &at);
    text_add(&summary, "scene %s\nstates %d\ninputs %d\noutputs %d\n", p->m->name, l->c.count, l->e->inputs,
             l->e->outputs);
    add_point_text(&summary, l, r);
    add_tangent(&summary, l);
    add_left_out(&summary, l);
    add_equilibrium(&summary, l);
    add_modes(&summary, l, &modes);
    add_verdict(&summary, l, &modes);
    return write_files(&files) && write_out(summary.bytes, summary.length);
}
