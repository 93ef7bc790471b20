/* every PERIOD [at PHASE] { ... }: signals, outputs and effects of the scene that are computed at a rate. The same block in
 * a definition is in parse_effect.c. */
#include "tools/isoc/scene/take.h"

const rate_block *take_rate(parser *p)
{
    if (p->block != NULL) {
        PARSE_FAULT(p, p->word->at, "a block of a rate within the one of %s: put them beside each other",
                    source_line(p->s, p->block->at));
        return NULL;
    }
    rate_block *result = arena_take(p->s->memory, 1, sizeof *result);
    result->at = p->word->at;
    result->period = parse_formula(p);
    if (!p->failed && take_word(p, "at")) {
        result->phase = parse_formula(p);
    }
    return p->failed ? NULL : result;
}

static const property paced[] = {
    {"signal", read_signal, 0, EVERY_KIND | MANY, NULL},
    {"output", read_output, 0, EVERY_KIND | MANY, NULL},
    {"effect", read_effect, 0, EVERY_KIND | MANY, NULL},
};

static const block rate = {"block of a rate", PROPERTIES(paced)};

void read_rate_block(parser *p, void *slot)
{
    scene *written = slot;
    const name word = {p->word->text, p->word->at};
    const rate_block *block = take_rate(p);
    if (block == NULL) {
        return;
    }
    p->block = block;
    written->broken |= !parse_block(p, &rate, 0, word, slot);
    p->block = NULL;
}
