/* The document of the equations: lists of quantities, then the functions of plant.c, each with names of its own. */
#include "tools/isoc/export/equations.h"

#include "tools/isoc/emit/parts.h"

const char *const equations_styles[EQUATIONS_STYLES] = {"text", "latex"};

/* The pieces of a document, with the places for their words. */
static const struct {
    const char *begin, *part, *heading, *note, *rows, *row, *rows_end, *equation, *end;
} pieces[EQUATIONS_STYLES] = {
    [EQUATIONS_TEXT] = {.begin = "# Equations of %s, by isoc\n",
                        .part = "\n## %s\n",
                        .heading = "\n# %s\n",
                        .note = "# %s\n",
                        .rows = "",
                        .row = "#   %-24s %-10s %-14s %s\n",
                        .rows_end = "",
                        .equation = "%s = %s\n",
                        .end = ""},
    [EQUATIONS_LATEX] = {.begin = "\\documentclass{article}\n\\usepackage[T1]{fontenc}\n"
                                  "\\usepackage[margin=2cm]{geometry}\n\\usepackage{amsmath,longtable}\n"
                                  "\\setlength{\\parindent}{0pt}\\setlength{\\parskip}{4pt}\\raggedright\n"
                                  "\\begin{document}\n\\title{Equations of %s, by isoc}\\date{}\\maketitle\n",
                         .part = "\n\\section*{%s}\n",
                         .heading = "\n\\subsubsection*{%s}\n",
                         .note = "%s\\par\n",
                         .rows = "\\begin{longtable}[l]{lllp{9cm}}\n",
                         .row = "$%s$ & $%s$ & $%s{}$ & \\raggedright \\texttt{%s} \\tabularnewline\n",
                         .rows_end = "\\end{longtable}\n",
                         .equation = "$\\displaystyle %s = %s$\\par\n",
                         .end = "\\end{document}\n"},
};

/* The left side of an equation: of a name, and of a number of ticks. */
typedef enum left_side {
    SIDE_NAME,
    SIDE_RATE,
    SIDE_CORRECTED,
    SIDE_NEXT,
    SIDE_LATER,
    SIDE_SAMPLE,
    SIDE_SHARE,
    SIDES
} left_side;

static const char *const sides[SIDES][EQUATIONS_STYLES] = {
    [SIDE_NAME] = {"%s", "%s"},
    [SIDE_RATE] = {"der(%s)", "\\tfrac{\\mathrm{d}}{\\mathrm{d}t}%s"},
    [SIDE_CORRECTED] = {"corrected(%s)", "\\operatorname{corrected}(%s)"},
    [SIDE_NEXT] = {"next(%s)", "\\operatorname{next}(%s)"},
    [SIDE_LATER] = {"later(%s, %.0f)", "\\operatorname{later}(%s, %.0f)"},
    [SIDE_SHARE] = {"share(%s)", "\\operatorname{share}(%s)"},
    [SIDE_SAMPLE] = {"sample(%s, %.0f)", "\\operatorname{sample}(%s, %.0f)"},
};

static void note(const equations_document *to, const char *plain)
{
    text_add(to->out, pieces[to->style].note, spell_words(to, plain));
}

/* --- equations --- */

/* The left side has its name in plant.c. */
static void add_equation(const equations_document *to, assignments *all, left_side left, const char *symbol,
                         double ticks, node root)
{
    assign(all, arena_format(to->out->memory, sides[left][to->style], spell_name(to, symbol), ticks), NULL, root);
}

/* The declared quantities under their headings, then the results. */
static void write_part(const equations_document *to, const char *title, const char *about, const assignments *all)
{
    const code c = {.g = to->g,
                    .names = to->names->leaves,
                    .is_double = to->p->is_double,
                    .roots = all->roots,
                    .count = (size_t)all->count};
    const code_nodes nodes = code_in_nodes(&c);
    const char *const *spelled = spell_nodes(to, &nodes);
    const char *equation = pieces[to->style].equation;
    int section = -1;
    if (all->count == 0) {
        return;
    }
    text_add(to->out, pieces[to->style].part, spell_words(to, title));
    note(to, about);
    for (size_t i = 0; i < nodes.g->count; i++) {
        if (nodes.names[i] == NULL) {
            continue;
        }
        if (nodes.g->nodes[i].section != section) {
            section = nodes.g->nodes[i].section;
            text_add(to->out, pieces[to->style].heading, spell_words(to, nodes.g->sections[section]));
        }
        text_add(to->out, equation, spell_name(to, nodes.names[i]), spelled[i]);
    }
    text_add(to->out, pieces[to->style].heading, spell_words(to, "Results"));
    for (int i = 0; i < all->count; i++) {
        const node root = nodes.roots[i];
        const char *right = nodes.names[root] != NULL ? spell_name(to, nodes.names[root]) : spelled[root];
        text_add(to->out, equation, all->targets[i], right);
    }
}

static void write_inputs(const equations_document *to)
{
    const mechanism *m = to->p->m;
    assignments all = room_for(to->out->memory, m->inputs.count + m->clocks.count);
    for (int i = 0; i < m->inputs.count; i++) {
        if (m->inputs.driven[i]) {
            add_equation(to, &all, SIDE_NAME, to->names->leaves.inputs[i].symbol, 0.0, m->inputs.drives[i]);
        }
    }
    for (int i = 0; i < m->clocks.count; i++) {
        add_equation(to, &all, SIDE_NAME, to->names->leaves.states[m->clocks.first + i].symbol, 0.0,
                     m->inputs.drives[m->inputs.count + i]);
    }
    write_part(to, "Functions of time", "At the begin of tick k, within the limits of the inputs.", &all);
}

/* Each of the quantities is set to its root. */
static void write_each(const equations_document *to, const char *title, const char *about, left_side left,
                       const quantities *content, const node *roots)
{
    assignments all = room_for(to->out->memory, content->count);
    for (int i = 0; i < content->count; i++) {
        add_equation(to, &all, left, content->leaves[i].symbol, 0.0, roots[i]);
    }
    write_part(to, title, about, &all);
}

static void write_corrections(const equations_document *to)
{
    const settled *after = &to->p->after;
    assignments all = room_for(to->out->memory, after->count);
    for (int i = 0; i < after->count; i++) {
        const node result = after->equations[i], x = leaf(to->g, OP_STATE, after->states[i]);
        add_equation(to, &all, SIDE_CORRECTED, to->names->leaves.states[after->states[i]].symbol, 0.0,
                     after->adds ? add(to->g, x, result) : result);
    }
    write_part(to, "Corrections after a step", "Of the states that the method computed.", &all);
}

/* The function of each event, and what it sets. */
static void write_events(const equations_document *to)
{
    const mechanism *m = to->p->m;
    const event_plan *plan = &to->p->events;
    for (int i = 0; i < m->events.count; i++) {
        assignments all = room_for(to->out->memory, 1 + plan->set_count);
        add_equation(to, &all, SIDE_NAME, arena_format(to->out->memory, "event_%d", i + 1), 0.0,
                     plan->functions[2 * i]);
        for (int k = 0; k < plan->set_count; k++) {
            if (plan->owners[k] == i) {
                add_equation(to, &all, SIDE_CORRECTED, to->names->leaves.states[plan->states[k]].symbol, 0.0,
                             plan->values[k]);
            }
        }
        write_part(to, arena_format(to->out->memory, "Event %d", i + 1),
                   "Where its function falls below zero, these states are set.", &all);
    }
}

/* The left side of the formula of a memory, with its rate where that is slow; a sample has it anyhow. */
static const char *side_of_memory(const equations_document *to, const effect_quantity *q, const char *symbol)
{
    arena *memory = to->out->memory;
    const bool is_sample = q->kept == KEPT_SAMPLE, is_plain = !is_slow(q->rate) || (is_sample && q->rate.phase == 0.0);
    const left_side left = is_sample               ? SIDE_SAMPLE
                           : q->kept == KEPT_SHARE ? SIDE_SHARE
                           : is_late(q)            ? SIDE_LATER
                                                   : SIDE_NEXT;
    const char *whole =
        arena_format(memory, sides[left][to->style], spell_name(to, symbol), is_sample ? q->rate.every : q->ticks);
    return is_plain ? whole
                    : arena_format(memory, to->style == EQUATIONS_LATEX ? "%s\\text{ in %s}" : "%s in %s", whole,
                                   arena_format(memory, "rows %.0f + n %.0f", q->rate.phase, q->rate.every));
}

/* The speed, the effort and the limit of each hold. */
static void write_holds(const equations_document *to)
{
    const mechanism *m = to->p->m;
    const int n = m->events.hold_count;
    for (int i = 0; i < n; i++) {
        const held_speed *h = &m->events.holds[i];
        arena *memory = to->out->memory;
        assignments all = room_for(memory, 3);
        add_equation(to, &all, SIDE_NAME, arena_format(memory, "speed_of_%s", h->called), 0.0,
                     to->p->events.hold_numbers[i]);
        add_equation(to, &all, SIDE_NAME, arena_format(memory, "effort_of_%s", h->called), 0.0,
                     to->p->d->holds.effort[i]);
        add_equation(to, &all, SIDE_NAME, arena_format(memory, "limit_of_%s", h->called), 0.0, h->limit);
        write_part(to, arena_format(memory, "Hold %s", h->called),
                   "Its speed is zero while the effort is within the limit; else it slips.", &all);
    }
}

/* Each as a row sets it: samples before the memories of effects, these, samples after them, then later values. */
static void write_memories(const equations_document *to)
{
    static const char about[] = "From the states of a row. All next() are set at once; a sample is taken in rows whose "
                                "number is a multiple of its ticks; later() is what a memory is so many rows later; "
                                "share() is found at the begin of each step.";
    const mechanism *m = to->p->m;
    assignments all = room_for(to->out->memory, m->effects.memory_count);
    for (int i = 0; i < m->effects.memory_count; i++) {
        const effect_quantity *q = &m->effects.memories[i];
        assign(&all, side_of_memory(to, q, to->names->leaves.inputs[m->inputs.count + i].symbol), NULL, q->next);
    }
    write_part(to, "Memories", about, &all);
}

/* --- lists --- */

/* Quantities with their units, starts where they have one, and lines of the scene. */
static void write_rows(const equations_document *to, const char *title, const quantities *content, bool has_starts)
{
    if (content->count == 0) {
        return;
    }
    text_add(to->out, pieces[to->style].heading, title);
    text_add(to->out, "%s", pieces[to->style].rows);
    for (int i = 0; i < content->count; i++) {
        const variable *v = &content->all[i];
        const char *start = has_starts ? spell_number(to->out->memory, to->style, v->start, to->p->is_double) : "";
        text_add(to->out, pieces[to->style].row, spell_name(to, content->leaves[i].symbol), spell_unit(to, v->unit),
                 start, spell_words(to, v->quote == NULL ? "" : v->quote));
    }
    text_add(to->out, "%s", pieces[to->style].rows_end);
}

/* The numbers that are folded into the equations: gravity and constants, as lines of the scene. */
static void write_constants(const equations_document *to, const scene *written)
{
    const mechanism *m = to->p->m;
    text_add(to->out, pieces[to->style].heading, "What the numbers of the equations contain: constants, closures");
    if (written->gravity != NULL) {
        note(to, source_quote(m->source, written->gravity->at));
    }
    FOR_EACH (const quantity, q, written->parameters) {
        if (!q->tunable) {
            note(to, source_quote(m->source, q->name.at));
        }
    }
}

static void write_lists(const equations_document *to, const scene *written)
{
    const mechanism *m = to->p->m;
    const naming *names = to->names;
    write_constants(to, written);
    for (int i = 0; i < m->closure_count; i++) {
        note(to, source_quote(m->source, m->closures[i].at));
    }
    write_rows(to, "Tunables: symbol, unit, default", &names->p, true);
    FOR_ALL (const switching, c, m->parameters.changes, m->parameters.change_count) {
        note(to, arena_format(to->out->memory, "%s is %s from tick %.0f on", names->p.leaves[c->parameter].symbol,
                              spell_number(to->out->memory, EQUATIONS_TEXT, c->value, to->p->is_double), c->tick));
    }
    write_rows(to, "States: symbol, unit, start", &names->x, true);
    write_rows(to, "Inputs: symbol, unit", &names->u, false);
    write_rows(to, "Memories: symbol, unit", &names->memories, false);
    write_rows(to, "Outputs: symbol, unit", &names->y, false);
}

/* The signs of the equations besides quantities. */
static void write_meanings(const equations_document *to)
{
    text_add(to->out, pieces[to->style].heading, "Signs");
    note(to, arena_format(to->out->memory,
                          "k: the number of a tick of %g s. der(x): the derivative of x by time. Units "
                          "are those of SI, angles in rad.",
                          to->p->m->method.step));
    note(to, to->style == EQUATIONS_LATEX ? "A bar above a quantity: its negative, minus_... in plant.c."
                                          : "minus_...: the negative of a quantity.");
    for (operation op = 0; op < OPERATIONS; op++) {
        if (to->is_asked[op] && spell_meaning(op) != NULL) {
            note(to, spell_meaning(op));
        }
    }
    note(to, "Not said here: the method's own formulas, starts that are formulas, whole turns, limits and the guard, "
             "plants of a ladder without effects. Each part has names of its own, t1, t2, ... among them.");
}

void describe_equations(const plant *p, graph *g, const naming *names, const scene *written, equations_style style,
                        text *out)
{
    text sections = {.memory = out->memory};
    equations_document d = {p, g, names, style, arena_take(out->memory, OPERATIONS, sizeof(bool)), &sections};
    write_inputs(&d);
    write_each(&d, "Derivatives of the states", "M(q) q'' + bias(q, q') = effort, solved for q''.", SIDE_RATE,
               &names->x, p->derivatives);
    write_events(&d);
    write_holds(&d);
    write_corrections(&d);
    write_memories(&d);
    write_each(&d, "Outputs", "From the states at the end of a tick.", SIDE_NAME, &names->y, p->outputs.roots);
    d.out = out;
    text_add(out, pieces[style].begin, spell_words(&d, p->m->name));
    write_lists(&d, written);
    write_meanings(&d);
    text_add(out, "%s%s", sections.bytes, pieces[style].end);
}
