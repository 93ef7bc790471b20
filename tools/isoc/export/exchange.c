/* Model exchange: a plant whose equations are x' = f(x, u, p), y = g(x, u, p) throughout; and their change along the
 * states and inputs. */
#include <stdarg.h>
#include <string.h>

#include "tools/isoc/export/terminals.h"

/* Notes, or warns of, conditions that the equations do not meet, with the remedy. */
typedef struct refusal {
    source *s;
    bool is_error, any;
} refusal;

__attribute__((format(printf, 3, 4))) static void refuse(refusal *r, place at, const char *format, ...)
{
    va_list words;
    va_start(words, format);
    const char *why = arena_format_list(r->s->memory, format, words);
    va_end(words);
    if (r->is_error) {
        source_problem(r->s, at, "no model exchange: %s", why);
    } else {
        source_warn(r->s, at, "no model exchange, co-simulation alone: %s", why);
    }
    r->any = true;
}

static void check_memories(refusal *r, const mechanism *m)
{
    static const char *const kinds[] = {[KEPT_SAMPLE] = "this sample is taken at ticks",
                                        [KEPT_SHARE] = "this share is that of a step",
                                        [KEPT_PREVIOUS] = "this previous is a value of an earlier tick",
                                        [KEPT_DELAY] = "this delay is a value of an earlier tick"};
    FOR_ALL (const effect_quantity, e, m->effects.memories, m->effects.memory_count) {
        const char *what = e->kept == KEPT_NEXT
                               ? arena_format(r->s->memory, "the memory '%s' changes at ticks", e->about.name)
                               : kinds[e->kept];
        refuse(r, e->at, "%s; take a state with a rate, or leave out what has it", what);
    }
}

/* Why an output has a value at the end of a tick alone, with the remedy; NULL where it has one at any time. */
static const char *fault_of_output(arena *memory, const graph *g, const shown *o, const node *root)
{
    const bool is_of_step = uses_operation(g, root, 1, OP_LOCAL_ERROR) || uses_operation(g, root, 1, OP_RESIDUAL);
    return is_slow(o->rate) ? arena_format(memory, "is of every %.0fth tick; leave out 'every'", o->rate.every)
           : is_of_step     ? "is of a step of the method; leave it out"
           : uses_operation(g, root, 1, OP_TURNS) ? "counts turns at the end of each step; leave it out"
                                                  : NULL;
}

static void check_outputs(refusal *r, const plant *p, const graph *g)
{
    const shown *refused = NULL; /* of a vector once */
    for (int i = 0; i < p->outputs.count; i++) {
        const shown *o = p->outputs.shows[i];
        const char *fault = fault_of_output(r->s->memory, g, o, &p->outputs.roots[i]);
        if (fault != NULL && o != refused) {
            refuse(r, o->name.at, "the output '%s' %s", o->name.text, fault);
            refused = o;
        }
    }
}

/* A projection moves the states at the end of a step. */
static void check_closures(refusal *r, const scene *written, const plant *p)
{
    const mechanism *m = p->m;
    if (m->drift.projections > 0 && p->d->loops.phi.count > 0) {
        const name *kind = &written->stabilisation.kind;
        refuse(r, kind->text != NULL ? kind->at : m->closures[0].at,
               "the projection moves the states at the end of each step; take 'stabilisation %s', which is in the "
               "derivative",
               m->drift.is_redundant ? "lagrangian { omega ... }" : "baumgarte");
    }
}

static void check_events(refusal *r, const mechanism *m)
{
    if (has_events(m)) {
        refuse(r, place_of_events(m), "%s", "an event is found within a step of the method; leave out 'when'");
    }
}

bool exchange_fits(source *s, const scene *written, const graph *g, const plant *p, bool is_wanted)
{
    refusal r = {.s = s, .is_error = is_wanted};
    check_memories(&r, p->m);
    check_events(&r, p->m);
    check_outputs(&r, p, g);
    check_closures(&r, written, p);
    return !r.any;
}

/* The names of the inputs, then of the changes of states and inputs, which stand behind them in u. */
static const leaf_name *with_changes(const emission *e)
{
    const mechanism *m = e->p->m;
    const int states = state_count(m), inputs = m->inputs.count;
    leaf_name *all = arena_take(e->out->memory, (size_t)(states + 2 * inputs) + 1, sizeof *all);
    memcpy(all, e->names->leaves.inputs, (size_t)inputs * sizeof *all);
    for (int i = 0; i < states + inputs; i++) {
        const bool is_state = i < states;
        const leaf_name *base = is_state ? &e->names->leaves.states[i] : &e->names->leaves.inputs[i - states];
        all[inputs + i] = (leaf_name){form(e, "d_%s", base->symbol),
                                      form(e, "%d + %s", is_state ? inputs : inputs + states, base->place), NULL};
    }
    return all;
}

/* The graph of the changes of the derivatives and the outputs, changes[count]. */
static graph changes_of(const graph *g, const plant *p, node *changes, size_t count)
{
    const mechanism *m = p->m;
    const int states = state_count(m), inputs = m->inputs.count;
    graph copy = graph_copy(g);
    node *roots = arena_take(g->memory, count, sizeof *roots), *along = arena_take(g->memory, count, sizeof *along);
    node *pushed = arena_take(g->memory, (size_t)inputs + 1, sizeof *pushed);
    list_roots(&copy, p, p->derivatives, p->outputs.count, roots);
    graph equations = economise(&copy, roots, count, roots);
    graph_section(&equations, "Changes along the states and inputs");
    for (int i = 0; i < states; i++) {
        along[i] = leaf(&equations, OP_INPUT, inputs + i);
    }
    for (int i = 0; i < inputs; i++) {
        pushed[i] = leaf(&equations, OP_INPUT, inputs + states + i);
    }
    differentiate_along(&equations, roots, count, along, pushed, changes);
    graph result = economise(&equations, changes, count, changes);
    graph_free(&equations);
    graph_free(&copy);
    return result;
}

static void emit_slopes(emission *e)
{
    const plant *p = e->p;
    const int count = state_count(p->m) + p->outputs.count;
    node *changes = arena_take(e->out->memory, (size_t)count, sizeof *changes);
    graph slopes = changes_of(e->g, p, changes, (size_t)count);
    naming names = *e->names;
    names.leaves.inputs = with_changes(e);
    emission copy = *e;
    copy.g = &slopes;
    copy.names = &names;
    const code result = code_of(&copy, numbered(&copy, "d", count), changes, count);
    emit_function(&copy, "slopes", equation_parameters(&copy, "d", ""), &result);
    graph_free(&slopes);
}

bool emit_exchange(const plant *p, graph *g, const naming *names, bool exchanges, file_list *files)
{
    text head = {.memory = files->memory}, code_text = head;
    double out_of_range_value = 0.0;
    emission e = {
        .p = p, .g = g, .names = names, .out = &code_text, .suffix = "", .out_of_range_value = &out_of_range_value};
    if (exchanges) {
        emit_slopes(&e);
    }
    put(&e,
        "void $p_slopes(real *const d, const real *const x, const real *const u, const real *const p)\n{\n    %s;\n}\n",
        exchanges ? "slopes(d, x, u, p)" : "(void)d, (void)x, (void)u, (void)p");
    e.out = &head;
    put(&e, "/* The slopes of %s.scene for model exchange%s. Made by isoc. */\n#include \"fmu_model.h\"\n\n",
        p->m->name, exchanges ? "" : ", which this FMU has not");
    put(&e, "#include \"core/numbers/real.h\"\n#include \"core/numbers/sincos.h\"\n");
    emit_calls_included(&code_text, &head);
    put(&e, "\n%s", code_text.bytes);
    file_list_add(files, "fmu_slopes.c", &head);
    return out_of_range_value == 0.0;
}
