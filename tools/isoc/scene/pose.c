#include "tools/isoc/scene/take.h"

static void parse_place(parser *p, pose *to, const token *word)
{
    placement *at = &to->place;
    if (at->position != NULL) {
        source_problem(p->s, word->at, "a second 'at'; the first is in %s", source_line(p->s, at->position->at));
    }
    if (at->turns.count != 0 || to->quaternion != NULL) {
        source_problem(p->s, word->at, "'at' comes before '%s': first move, then turn",
                       at->turns.count != 0 ? "rotate" : "quaternion");
    }
    at->position = parse_formula(p);
}

static void parse_turn(parser *p, placement *to, const token *word, bool axis_needed)
{
    turn result = {.at = word->at, .angle = parse_formula(p)};
    if (!p->failed && (axis_needed ? take_word(p, "about") : take_option(p, "about"))) {
        result.axis = parse_axis(p);
    } else if (axis_needed) {
        parse_problem(p, "expected 'about' and an axis: rotate 90 deg about x");
    }
    LIST_ADD(p->s->memory, to->turns, result);
}

static void parse_quaternion(parser *p, pose *to, const token *word)
{
    if (to->quaternion != NULL) {
        source_problem(p->s, word->at, "a second 'quaternion'; the first is in %s",
                       source_line(p->s, to->quaternion->at));
    }
    to->quaternion = parse_formula(p);
}

pose parse_pose(parser *p, bool axis_needed, bool part_needed)
{
    pose read = {0};
    const token *const first = p->next, *word = first;
    while (!p->failed && (!word->first_on_line || (part_needed && word == first)) &&
           (take_word(p, "at") || take_word(p, "rotate") || take_word(p, "quaternion"))) {
        if (word->text[0] == 'a') {
            parse_place(p, &read, word);
        } else if (word->text[0] == 'r') {
            parse_turn(p, &read.place, word, axis_needed);
        } else {
            parse_quaternion(p, &read, word);
        }
        if (read.place.turns.count != 0 && read.quaternion != NULL) {
            source_problem(p->s, word->at, "'%s' and '%s': give an orientation by turns or by a quaternion", word->text,
                           word->text[0] == 'r' ? "quaternion" : "rotate");
        }
        word = p->next;
    }
    return read;
}

placement parse_place_and_turns(parser *p, const char *what)
{
    const pose read = parse_pose(p, true, false);
    if (read.quaternion != NULL) {
        source_problem(p->s, read.quaternion->at,
                       "a quaternion is only for a start; turn %s like this: rotate 90 deg about x", what);
    }
    return read.place;
}

void read_placement(parser *p, void *slot)
{
    placement *to = slot;
    const name parent = take_name(p, "expected the name of a body, or ground");
    if (!p->failed) {
        *to = parse_place_and_turns(p, arena_format(p->s->memory, "a %s", p->word->text));
    }
    to->body = parent;
}
