#include "tools/isoc/emit/emit.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

const char *capitals_of(arena *memory, const char *word)
{
    char *copy = arena_copy(memory, word, strlen(word));
    for (char *c = copy; *c != '\0'; c++) {
        *c = (char)toupper((unsigned char)*c);
    }
    return copy;
}

/* CART_X_RAIL; in the equations q_rail of a state, else u_push and p_mass. */
static quantities quantities_of(const naming *n, arena *memory, char array, const variable *all, int count)
{
    leaf_name *leaves = arena_take(memory, (size_t)count + 1, sizeof *leaves);
    for (int i = 0; i < count; i++) {
        const char *symbol = array == 'X' ? n->states[i].symbol
                                          : arena_format(memory, "%c_%s", tolower((unsigned char)array), all[i].name);
        const char *index = arena_format(memory, "%s_%c_%s", n->capitals, array, capitals_of(memory, all[i].name));
        leaves[i] = (leaf_name){symbol, index, all[i].quote};
    }
    return (quantities){leaves, all, count};
}

static const variable *about_states(const naming *n, arena *memory, int count)
{
    variable *all = arena_take(memory, (size_t)count + 1, sizeof *all);
    for (int i = 0; i < count; i++) {
        all[i] = n->states[i].about;
    }
    return all;
}

/* Quantities that are constant within a step: inputs, then memories. */
static const variable *about_held(arena *memory, const mechanism *m)
{
    variable *all = arena_take(memory, (size_t)held_count(m) + 1, sizeof *all);
    for (int i = 0; i < held_count(m); i++) {
        all[i] = i < m->inputs.count ? m->inputs.all[i] : m->effects.memories[i - m->inputs.count].about;
    }
    return all;
}

static const variable *about_outputs(arena *memory, const plant *p)
{
    variable *all = arena_take(memory, (size_t)p->outputs.count + 1, sizeof *all);
    for (int i = 0; i < p->outputs.count; i++) {
        const char *quote = source_quote(p->m->source, p->outputs.shows[i]->name.at);
        all[i] = unlimited(p->outputs.names[i], p->outputs.units[i], quote);
    }
    return all;
}

naming naming_of(const plant *p, arena *memory, const char *prefix)
{
    const mechanism *m = p->m;
    naming result = {.prefix = prefix == NULL ? "plant" : prefix, .is_program = prefix == NULL};
    result.capitals = capitals_of(memory, result.prefix);
    result.states = mechanism_states(m, memory);
    const quantities held = quantities_of(&result, memory, 'U', about_held(memory, m), held_count(m));
    const int inputs = m->inputs.count;
    result.x = quantities_of(&result, memory, 'X', about_states(&result, memory, state_count(m)), state_count(m));
    result.u = (quantities){held.leaves, held.all, inputs};
    result.memories = (quantities){held.leaves + inputs, held.all + inputs, m->effects.memory_count};
    result.p = quantities_of(&result, memory, 'P', m->parameters.all, m->parameters.count);
    result.y = quantities_of(&result, memory, 'Y', about_outputs(memory, p), p->outputs.count);
    result.leaves = (leaf_names){result.x.leaves, held.leaves, result.p.leaves};
    return result;
}
