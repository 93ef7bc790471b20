/* Modes, events and holds, of an effect and of the scene: mode NAME = START, when CONDITION { set NAME = VALUE; ... },
 * hold NAME on JOINT up to LIMIT; and what a step does about events: events NUMBER rest METHOD. */
#include <string.h>

#include "tools/isoc/scene/take.h"

/* (NAME, ...) */
static void parse_choices(parser *p, name_choices *to)
{
    expect_sign(p, '(', "expected ( and the names of its values, as in: mode valve in (shut, open) = shut");
    do {
        const name n = take_inner_name(p, "expected a name of a value");
        if (!p->failed) {
            LIST_ADD(p->s->memory, *to, n);
        }
    } while (!p->failed && take_sign(p, ','));
    expect_sign(p, ')', "expected , or )");
}

void parse_mode(parser *p, quantity *to, name_choices *choices)
{
    if (!p->failed && take_option(p, "in")) {
        parse_choices(p, choices);
    }
    expect_sign(p, '=', "expected = and its value at the start, as in: mode on = 0");
    to->value = parse_formula(p);
}

/* The names of the values are constants of the scene. */
void read_mode(parser *p, void *slot)
{
    scene *written = slot;
    quantity q = {.name = take_new_name(p, "expected a name for the mode")};
    name_choices choices = {0};
    parse_mode(p, &q, &choices);
    for (size_t i = 0; i < choices.count; i++) {
        const name n = choices.all[i];
        LIST_ADD(p->s->memory, written->parameters,
                 ((quantity){.name = n, .value = formula_of_number(p, (double)i, n.at)}));
    }
    LIST_ADD(p->s->memory, written->events.modes, q);
}

/* set TARGET = VALUE */
static void parse_set(parser *p, when_statement *to)
{
    static const char *const words[] = {"speed", "position", "velocity"};
    set_statement set = {.which = NULL};
    expect_word(p, "set", "expected set or }, as in: set on = 1; set speed of rail = 0 m/s");
    if (!p->failed && next_is_owned(p)) {
        const size_t which = take_one_of(p, words, COUNT_OF(words));
        set.which = which < COUNT_OF(words) ? words[which] : NULL;
        expect_word(p, "of", "expected of and a joint or a body");
    }
    set.what = take_name(p, "expected the name of a mode or a state, or: speed of JOINT");
    if (!p->failed && set.which != NULL && strcmp(set.which, "velocity") == 0) {
        expect_word(p, "along", "expected along and a vector, as in: set velocity of ball along (0, 0, 1) = 0 m/s");
        set.along = parse_formula(p);
    }
    expect_sign(p, '=', "expected = and a value");
    set.value = parse_formula(p);
    if (!p->failed) {
        LIST_ADD(p->s->memory, to->sets, set);
    }
}

void parse_sets(parser *p, when_statement *to)
{
    expect_sign(p, '{', "expected { and what is set, as in: when x < 0 m { set on = 1 }");
    while (!p->failed && !take_sign(p, '}')) {
        if (!take_sign(p, ';')) {
            parse_set(p, to);
        }
    }
    if (!p->failed && to->sets.count == 0) {
        source_problem(p->s, to->at, "this event sets nothing: when x < 0 m { set on = 1 }");
    }
}

void read_when(parser *p, void *slot)
{
    scene *written = slot;
    when_statement when = {.at = p->word->at};
    when.condition = parse_condition(p);
    parse_sets(p, &when);
    if (!p->failed) {
        LIST_ADD(p->s->memory, written->events.whens, when);
    }
}

void parse_hold(parser *p, hold_statement *to)
{
    if (!p->failed && take_option(p, "between")) {
        to->on = take_name(p, "expected a joint, as in: hold grip between wheel and shaft up to 5 N*m");
        expect_word(p, "and", "expected and, and another joint");
        to->against = take_name(p, "expected another joint");
    } else {
        expect_word(p, "on", "expected on and a joint, or between and two, as in: hold grip on rail up to 5 N");
        to->on = take_name(p, "expected a joint");
    }
    expect_word(p, "up", "expected up to and the largest effort, as in: hold grip on rail up to 5 N");
    expect_word(p, "to", "expected up to and the largest effort, as in: hold grip on rail up to 5 N");
    to->limit = parse_formula(p);
    if (!p->failed && take_option(p, "then")) {
        to->sliding = parse_formula(p);
    }
}

/* Its mode is one of the scene, which begins as the speed says. */
void read_hold(parser *p, void *slot)
{
    scene *written = slot;
    hold_statement hold = {.name = take_new_name(p, "expected a name for the hold")};
    parse_hold(p, &hold);
    if (!p->failed) {
        LIST_ADD(p->s->memory, written->events.modes, ((quantity){.name = hold.name}));
        LIST_ADD(p->s->memory, written->events.holds, hold);
    }
}

void read_events(parser *p, void *slot)
{
    event_statements *to = slot;
    to->slots = parse_formula(p);
    if (!p->failed && take_option(p, "rest")) {
        to->rest = take_name(p, "expected the method of the rest of a step, as in: events 1 rest rk4");
    }
}
