#include "tools/isoc/names.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef struct listing {
    name *names;
    size_t count, room;
} listing;

static void list_one(source *s, listing *l, name n)
{
    if (n.text != NULL) {
        l->names = arena_grow(s->memory, l->names, l->count, &l->room, sizeof *l->names);
        l->names[l->count++] = n;
    }
}

static int by_text(const void *left, const void *right)
{
    const name *a = left, *b = right;
    const int order = strcasecmp(a->text, b->text);
    return order != 0 ? order : a->at < b->at ? -1 : a->at > b->at;
}

static bool is_vector(const output *o)
{
    return o->along < 0 && (o->kind == OUTPUT_VELOCITY || o->kind == OUTPUT_POSITION);
}

/* An output of three components declares NAME_x, NAME_y and NAME_z as well. */
static void list_components(source *s, listing *l, const output *o)
{
    for (int i = 0; i < 3 && is_vector(o) && o->name.text != NULL; i++) {
        const char *text = arena_format(s->memory, "%s_%c", o->name.text, "xyz"[i]);
        list_one(s, l, (name){text, o->name.at});
    }
}

/* Whether a name's place has its problem already: the components of a name taken twice need no more words. */
static bool is_told(const source *s, place at)
{
    for (size_t i = 0; i < s->problem_count; i++) {
        if (s->problems[i].at == at) {
            return true;
        }
    }
    return false;
}

static void check_list(source *s, listing *l)
{
    if (l->count > 1) {
        qsort(l->names, l->count, sizeof *l->names, by_text);
    }
    for (size_t i = 1; i < l->count; i++) {
        const name *first = &l->names[i - 1], *again = &l->names[i];
        if (first->at == again->at || is_told(s, again->at)) {
            continue;
        }
        if (strcmp(first->text, again->text) == 0) {
            source_problem(s, again->at, "the name '%s' is taken in line %zu", again->text, source_line(s, first->at));
        } else if (strcasecmp(first->text, again->text) == 0) {
            source_problem(s, again->at, "the name '%s' differs from '%s' in line %zu only in case", again->text,
                           first->text, source_line(s, first->at));
        }
    }
}

/* Outputs have names of their own: they may be called like what they show. */
void names_check(source *s, const scene *written)
{
    listing things = {0}, outputs = {0};
    for (size_t i = 0; i < written->body_count; i++) {
        list_one(s, &things, written->bodies[i].name);
    }
    for (size_t i = 0; i < written->joint_count; i++) {
        list_one(s, &things, written->joints[i].name);
    }
    for (size_t i = 0; i < written->parameter_count; i++) {
        list_one(s, &things, written->parameters[i].name);
    }
    for (size_t i = 0; i < written->input_count; i++) {
        list_one(s, &things, written->inputs[i].name);
    }
    for (size_t i = 0; i < written->output_count; i++) {
        list_one(s, &outputs, written->outputs[i].name);
        list_components(s, &outputs, &written->outputs[i]);
    }
    check_list(s, &things);
    check_list(s, &outputs);
}

/* The name of thing i of an array of structs that begin with their name. */
static name name_at(const void *things, size_t size, size_t i)
{
    name n;
    memcpy(&n, (const char *)things + i * size, sizeof n);
    return n;
}

static int find_among(const void *things, size_t count, size_t size, name n)
{
    for (size_t i = 0; i < count; i++) {
        const name other = name_at(things, size, i);
        if (other.text != NULL && strcmp(other.text, n.text) == 0) {
            return (int)i;
        }
    }
    return -1;
}

static size_t collect(const char **names, const void *things, size_t count, size_t size)
{
    size_t found = 0;
    for (size_t i = 0; i < count; i++) {
        const name n = name_at(things, size, i);
        if (n.text != NULL) {
            names[found++] = n.text;
        }
    }
    return found;
}

static int find_or_suggest(source *s, const void *things, size_t count, size_t size, name n, const char *kind)
{
    const int found = find_among(things, count, size, n);
    if (found < 0) {
        const char **names = arena_take(s->memory, count + 1, sizeof *names);
        size_t listed = collect(names, things, count, size);
        if (strcmp(kind, "body") == 0) {
            names[listed++] = "ground";
        }
        source_problem(s, n.at, "no %s is called '%s'%s", kind, n.text, source_suggestion(s, n.text, names, listed));
    }
    return found;
}

int find_body(source *s, const scene *written, name n)
{
    if (strcmp(n.text, "ground") == 0) {
        return -2;
    }
    return find_or_suggest(s, written->bodies, written->body_count, sizeof *written->bodies, n, "body");
}

int find_joint(source *s, const scene *written, name n)
{
    return find_or_suggest(s, written->joints, written->joint_count, sizeof *written->joints, n, "joint");
}

int find_input(source *s, const scene *written, name n)
{
    return find_or_suggest(s, written->inputs, written->input_count, sizeof *written->inputs, n, "input");
}

int find_joint_or_body(source *s, const scene *written, name n, bool *is_joint)
{
    int found = find_among(written->joints, written->joint_count, sizeof *written->joints, n);
    *is_joint = found >= 0;
    if (found < 0) {
        found = find_among(written->bodies, written->body_count, sizeof *written->bodies, n);
    }
    if (found < 0) {
        const char **names = arena_take(s->memory, written->joint_count + written->body_count + 1, sizeof *names);
        size_t listed = collect(names, written->joints, written->joint_count, sizeof *written->joints);
        listed += collect(names + listed, written->bodies, written->body_count, sizeof *written->bodies);
        source_problem(s, n.at, "no joint or body is called '%s'%s", n.text,
                       source_suggestion(s, n.text, names, listed));
    }
    return found;
}
