#include "tools/isoc/scene/take.h"

#include <string.h>

static void parse_place(parser *p, pose *to, const token *word)
{
    if (to->position != NULL) {
        source_problem(p->s, word->at, "a second 'at'; the first is in %s", source_line(p->s, to->position->at));
    }
    if (to->turn_count != 0 || to->quaternion != NULL) {
        source_problem(p->s, word->at, "'at' comes before '%s': first move, then turn",
                       to->turn_count != 0 ? "rotate" : "quaternion");
    }
    to->position = parse_formula(p);
}

static void parse_turn(parser *p, pose *to, const token *word, bool axis_needed)
{
    to->turns = arena_grow(p->s->memory, to->turns, to->turn_count, &to->turn_room, sizeof *to->turns);
    turn *result = &to->turns[to->turn_count++];
    *result = (turn){.at = word->at, .angle = parse_formula(p)};
    if (!p->failed && (axis_needed ? take_word(p, "about") : take_option(p, "about"))) {
        result->axis = parse_axis(p);
    } else if (axis_needed) {
        parse_problem(p, "expected 'about' and an axis: rotate 90 deg about x");
    }
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
            parse_turn(p, &read, word, axis_needed);
        } else {
            parse_quaternion(p, &read, word);
        }
        if (read.turn_count != 0 && read.quaternion != NULL) {
            source_problem(p->s, word->at, "'%s' and '%s': give an orientation by turns or by a quaternion", word->text,
                           word->text[0] == 'r' ? "quaternion" : "rotate");
        }
        word = p->next;
    }
    return read;
}

void read_placement(parser *p, const token *word, void *slot)
{
    placement *to = slot;
    to->body = take_name(p, "expected the name of a body, or ground");
    if (p->failed) {
        return;
    }
    const pose read = parse_pose(p, true, false);
    if (read.quaternion != NULL) {
        source_problem(p->s, read.quaternion->at,
                       "a quaternion is only for a start; turn a %s like this: rotate 90 deg about x", word->text);
    }
    to->position = read.position;
    to->turns = read.turns;
    to->turn_count = read.turn_count;
    to->turn_room = read.turn_room;
}
