/* overrun KIND, grace NUMBER ticks, publish WHEN, histogram: how the loop runs the plant. */
#include "tools/isoc/scene/take.h"

static const char *const overrun_names[] = {"count", "catch_up", "stop", "degrade"};
static const char *const publish_names[] = {"at_once", "next_tick"};
static const char *const rung_names[] = {"method", "drop", "hold"};

/* method NAME, drop EFFECT, or hold: the next rung. */
static void read_rung(parser *p, void *slot)
{
    policy_statement *to = slot;
    const rung_kind kind = (rung_kind)index_of_word(p->word->text, rung_names, COUNT_OF(rung_names));
    const name n = kind == RUNG_HOLD   ? (name){"hold", p->word->at}
                   : kind == RUNG_DROP ? take_name(p, "expected an effect of the scene, by the name of its use")
                                       : take_name(p, "expected a method, such as euler");
    if (to->rung_count == MOST_RUNGS) {
        source_problem(p->s, p->word->at, "a ladder has at most %d rungs", MOST_RUNGS);
    } else if (!p->failed) {
        to->rung_kinds[to->rung_count] = kind;
        to->rungs[to->rung_count++] = n;
    }
}

static void read_after(parser *p, void *slot)
{
    policy_statement *to = slot;
    to->after = parse_formula(p);
    expect_word(p, "ticks", "expected ticks: after 100 ticks");
}

static const property rung_properties[] = {
    {"method", read_rung, 0, EVERY_KIND | MANY, NULL},
    {"drop", read_rung, 0, EVERY_KIND | MANY, NULL},
    {"hold", read_rung, 0, EVERY_KIND, NULL},
    {"after", read_after, 0, EVERY_KIND, "after 100 ticks"},
};

static const block ladder = {"ladder", PROPERTIES(rung_properties)};

void read_overrun(parser *p, void *slot)
{
    policy_statement *to = slot;
    to->overrun_at = p->word->at;
    const size_t kind = take_one_of(p, overrun_names, COUNT_OF(overrun_names));
    to->overrun = kind < COUNT_OF(overrun_names) ? (overrun_kind)kind : OVERRUN_COUNT;
    if (!p->failed && to->overrun == OVERRUN_CATCH_UP) {
        to->catch_up = parse_formula(p);
    }
    if (!p->failed && to->overrun == OVERRUN_DEGRADE) {
        (void)parse_block(p, &ladder, 0, (name){"degrade", p->word->at}, to);
    }
}

void read_grace(parser *p, void *slot)
{
    policy_statement *to = slot;
    to->grace = parse_ticks(p, "a grace is a number of ticks: grace 10 ticks");
}

void read_publish(parser *p, void *slot)
{
    policy_statement *to = slot;
    to->publish_at = p->word->at;
    to->delayed = take_one_of(p, publish_names, COUNT_OF(publish_names)) == 1;
}

void read_histogram(parser *p, void *slot)
{
    policy_statement *to = slot;
    to->histogram_at = p->word->at;
    to->histogram = true;
}
