#include "tools/isoc/emit/naming.h"

#include <ctype.h>
#include <string.h>

const char *capitals_of(arena *memory, const char *word)
{
    char *copy = arena_copy(memory, word, strlen(word));
    for (char *c = copy; *c != '\0'; c++) {
        *c = (char)toupper((unsigned char)*c);
    }
    return copy;
}

/* CART_X_RAIL */
static const char *place_of(const naming *n, arena *memory, char array, const char *word)
{
    return arena_format(memory, "%s_%c_%s", n->capitals, array, capitals_of(memory, word));
}

static leaf_name leaf_named(const naming *n, arena *memory, char array, const char *symbol, const variable *v)
{
    return (leaf_name){symbol, place_of(n, memory, array, v->name), v->quote};
}

/* u_PUSH, p_MASS */
static const leaf_name *leaves_of(const naming *n, arena *memory, char array, const variable *all, int count)
{
    leaf_name *result = arena_take(memory, (size_t)count + 1, sizeof *result);
    for (int i = 0; i < count; i++) {
        const char *symbol = arena_format(memory, "%c_%s", tolower((unsigned char)array), all[i].name);
        result[i] = leaf_named(n, memory, array, symbol, &all[i]);
    }
    return result;
}

static const leaf_name *states_of(const naming *n, arena *memory, int count)
{
    leaf_name *result = arena_take(memory, (size_t)count + 1, sizeof *result);
    for (int i = 0; i < count; i++) {
        result[i] = leaf_named(n, memory, 'X', n->states[i].symbol, &n->states[i].about);
    }
    return result;
}

/* Quantities that are constant within a step: inputs, then memories. */
static const leaf_name *held_of(const naming *n, arena *memory, const mechanism *m)
{
    variable *all = arena_take(memory, (size_t)held_count(m) + 1, sizeof *all);
    for (int i = 0; i < m->inputs.count; i++) {
        all[i] = m->inputs.all[i];
    }
    for (int i = 0; i < m->effects.memory_count; i++) {
        all[m->inputs.count + i] = m->effects.memories[i].about;
    }
    return leaves_of(n, memory, 'U', all, held_count(m));
}

naming naming_of(const plant *p, arena *memory, const char *prefix)
{
    const mechanism *m = p->m;
    naming result = {.prefix = prefix == NULL ? "plant" : prefix, .is_program = prefix == NULL};
    result.capitals = capitals_of(memory, result.prefix);
    result.states = mechanism_states(m, memory);
    result.leaves.states = states_of(&result, memory, state_count(m));
    result.leaves.inputs = held_of(&result, memory, m);
    result.leaves.parameters = leaves_of(&result, memory, 'P', m->parameters.all, m->parameters.count);
    const char **outputs = arena_take(memory, (size_t)p->outputs.count + 1, sizeof *outputs);
    const char **quotes = arena_take(memory, (size_t)p->outputs.count + 1, sizeof *quotes);
    for (int i = 0; i < p->outputs.count; i++) {
        outputs[i] = place_of(&result, memory, 'Y', p->outputs.names[i]);
        quotes[i] = source_quote(m->source, p->outputs.shows[i]->name.at);
    }
    result.outputs = outputs;
    result.output_quotes = quotes;
    return result;
}
