#include "tools/show/show.h"

#include <stdlib.h>
#include <string.h>

/* --- values of JSON --- */

static void write_text(FILE *out, const char *text)
{
    fputc('"', out);
    for (const char *c = text == NULL ? "" : text; *c != '\0'; c++) {
        if (*c == '"' || *c == '\\' || *c == '<' || (unsigned char)*c < ' ') {
            fprintf(out, "\\u%04x", (unsigned)(unsigned char)*c);
        } else {
            fputc(*c, out);
        }
    }
    fputc('"', out);
}

static void write_vec(FILE *out, vec v)
{
    fprintf(out, "[%.7g,%.7g,%.7g]", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

/* The bytes of numbers, which are little-endian as those of a browser are, in base 64 (RFC 4648). */
static void write_floats(FILE *out, const float *x, size_t count)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *byte = (const unsigned char *)x;
    const size_t bytes = count * sizeof *x;
    fputc('"', out);
    for (size_t i = 0; i < bytes; i += 3) {
        const unsigned a = byte[i], b = i + 1 < bytes ? byte[i + 1] : 0U, c = i + 2 < bytes ? byte[i + 2] : 0U;
        fputc(digit[a >> 2], out);
        fputc(digit[(a & 3U) << 4 | b >> 4], out);
        fputc(i + 1 < bytes ? digit[(b & 15U) << 2 | c >> 6] : '=', out);
        fputc(i + 2 < bytes ? digit[c & 63U] : '=', out);
    }
    fputc('"', out);
}

/* --- a run --- */

static void write_mesh(FILE *out, const mesh *m)
{
    fputs("\"v\":[", out);
    for (size_t i = 0; i < m->vertices; i++) {
        const vec p = m->vertex[i];
        fprintf(out, "%s%.5g,%.5g,%.5g", i == 0 ? "" : ",", p.x + 0.0, p.y + 0.0, p.z + 0.0);
    }
    fputs("],\"f\":[", out);
    for (size_t i = 0, from = 0; i < m->faces; from = m->end[i++]) {
        for (size_t n = from; n < m->end[i]; n++) {
            fprintf(out, "%s%zu", n > from ? "," : i > 0 ? ",[" : "[", m->corner[n]);
        }
        fputs("]", out);
    }
    fputs("]", out);
}

static void write_figure(FILE *out, const figure *f)
{
    for (size_t i = 0; i < f->parts; i++) {
        const part *p = &f->all[i];
        fprintf(out, "%s{\"kind\":%d,\"ink\":%d,\"body\":[%d,%d],\"point\":[", i == 0 ? "" : ",\n", (int)p->kind,
                p->ink, p->body[0], p->body[1]);
        write_vec(out, p->point[0]);
        fputc(',', out);
        write_vec(out, p->point[1]);
        fprintf(out, "],\"column\":%d,\"scale\":%.7g,", p->column, p->scale);
        write_mesh(out, &p->shape);
        fputs("}", out);
    }
}

static void write_names(FILE *out, char *const *names, size_t count)
{
    fputc('[', out);
    for (size_t i = 0; i < count; i++) {
        fputs(i == 0 ? "" : ",", out);
        write_text(out, names[i]);
    }
    fputc(']', out);
}

static void write_run(FILE *out, const run *x)
{
    const record *r = &x->record;
    fputs("{\"label\":", out);
    write_text(out, x->label);
    fprintf(out, ",\"method\":\"%s\",\"real\":\"%s\",\"tick\":%.9g,\"interval\":%.9g,\"end\":%.9g,\"frames\":%zu",
            r->method, r->real, r->tick, r->interval, r->end, r->frames);
    fputs(",\"stopped\":", out);
    write_text(out, r->stopped);
    fprintf(out, ",\"bodies\":%zu,\"columns\":%zu,\"place\":[", x->shape.bodies, r->columns);
    for (size_t i = 0; i < x->shape.bodies; i++) {
        fprintf(out, "%s%d", i == 0 ? "" : ",", r->place[i]);
    }
    fputs("],\"ways\":[", out);
    for (size_t i = 0, shown = 0; i < x->shape.points; i++) {
        char name[RECORD_NAME_BYTES];
        snprintf(name, sizeof name, "%.60s_x", x->shape.point[i].name);
        const int column = record_column(r, name);
        if (column >= 0) {
            fprintf(out, "%s%d", shown++ == 0 ? "" : ",", column);
        }
    }
    fputs("],\"names\":", out);
    write_names(out, r->name, r->outputs);
    fputs(",\"units\":", out);
    write_names(out, r->unit, r->outputs);
    fputs(",\n\"value\":", out);
    write_floats(out, r->value, r->frames * r->columns);
    fputs(",\n\"least\":", out);
    write_floats(out, r->least, r->frames * r->outputs);
    fputs(",\n\"most\":", out);
    write_floats(out, r->most, r->frames * r->outputs);
    fputs(",\n\"parts\":[", out);
    write_figure(out, &x->figure);
    fputs("]}", out);
}

static void write_view(FILE *out, const view *v)
{
    const struct {
        const char *name;
        vec is;
    } all[] = {{"up", v->up},         {"right", v->right},       {"out", v->out},
               {"centre", v->centre}, {"floor", v->floor_point}, {"floorX", v->floor_x},
               {"floorY", v->floor_y}};
    fputc('{', out);
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        fprintf(out, "\"%s\":", all[i].name);
        write_vec(out, all[i].is);
        fputc(',', out);
    }
    fprintf(out, "\"yaw\":%g,\"pitch\":%g,\"halfWidth\":%.7g,\"halfHeight\":%.7g,\"distance\":%.7g,\"cell\":%.7g,",
            v->yaw, v->pitch, v->half_width, v->half_height, v->distance, v->cell);
    fprintf(out, "\"follows\":%d,\"hasFloor\":%d}", v->follows, v->has_floor);
}

/* All runs as one object; they are seen by the camera of the first. */
static void write_data(FILE *out, const run *runs, size_t count)
{
    const view v = view_of(&runs[0].shape, &runs[0].record, &runs[0].figure);
    fputs("{\"name\":", out);
    write_text(out, runs[0].shape.name);
    fputs(",\"inks\":[", out);
    for (int i = 0; i < INKS; i++) {
        fprintf(out, "%s[%d,%d,%d]", i == 0 ? "" : ",", ink_colours[i][0], ink_colours[i][1], ink_colours[i][2]);
    }
    fputs("],\"view\":", out);
    write_view(out, &v);
    fputs(",\"runs\":[", out);
    for (size_t i = 0; i < count; i++) {
        fputs(i == 0 ? "\n" : ",\n", out);
        write_run(out, &runs[i]);
    }
    fputs("]}", out);
}

/* --- the template --- */

/* Copies a file; of a template, which comes with runs, with its places @NAME@ filled: the title, the data, or a file
 * beside it. */
static void copy_file(FILE *out, const char *folder, const char *name, const run *runs, size_t count)
{
    char path[FILE_PATH_BYTES];
    size_t bytes = 0;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    char *const text = file_content(path, &bytes);
    if (text == NULL) {
        quit("show: %s cannot be read", path);
    }
    char *at = text, *start = NULL, *end = NULL;
    while (runs != NULL && (start = strchr(at, '@')) != NULL && (end = strchr(start + 1, '@')) != NULL) {
        *start = *end = '\0';
        fputs(at, out);
        if (strcmp(start + 1, "title") == 0) {
            fputs(runs[0].shape.name, out);
        } else if (strcmp(start + 1, "data") == 0) {
            write_data(out, runs, count);
        } else {
            copy_file(out, folder, start + 1, NULL, 0);
        }
        at = end + 1;
    }
    fputs(at, out);
    free(text);
}

void page_write(FILE *out, const char *folder, const run *runs, size_t count)
{
    copy_file(out, folder, "page.html", runs, count);
}
