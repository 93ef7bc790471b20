#include "tools/show/show.h"

#include <stdio.h>
#include <string.h>

#include "tools/trace/stream.h"

/* The number of rows of a frame: a page has some megabytes, and so the more frames, the fewer columns there are. */
static size_t stride_of(size_t rows, size_t columns)
{
    enum { NUMBERS = 250000, LEAST = 600, MOST = 4000 };
    const size_t most = NUMBERS / (columns + 1), frames = most < LEAST ? LEAST : most > MOST ? MOST : most;
    return (rows + frames - 1) / frames;
}

/* The words of a list with commas. */
static char **words_of(const char *list, size_t count)
{
    char **all = memory_for(count + 1, sizeof *all);
    const char *from = list;
    for (size_t i = 0; i < count; i++) {
        const size_t length = strcspn(from, ",");
        all[i] = memory_for(length + 1, 1);
        memcpy(all[i], from, length);
        from += length + (from[length] == ',');
    }
    return all;
}

/* The frame of a row, which is the number of the frames before it that are whole: row 0 is frame 0; behind it every
 * `stride` rows make a frame. */
static size_t frame_of(size_t row, size_t stride)
{
    return (row + stride - 1) / stride;
}

/* Takes a number of a row into the frame that it belongs to: the value of the frame is that of its last row. */
static void take(record *r, size_t row, size_t stride, size_t column, float x)
{
    const size_t frame = frame_of(row, stride), at = frame * r->outputs + column;
    const bool is_first = row == 0 || (row - 1) % stride == 0;
    if (column < r->outputs) {
        r->least[at] = is_first || x < r->least[at] ? x : r->least[at];
        r->most[at] = is_first || x > r->most[at] ? x : r->most[at];
    }
    r->value[frame * r->columns + column] = x;
}

static void make_room(record *r, size_t frames)
{
    r->value = memory_for(frames * r->columns, sizeof *r->value);
    r->least = memory_for(frames * r->outputs, sizeof *r->least);
    r->most = memory_for(frames * r->outputs, sizeof *r->most);
}

/* Why the run stopped before its time, if it did. */
static void find_stop(record *r, const stream *from)
{
    static char name[STREAM_TEXT_BYTES];
    if (from->end.guard < from->header.states) {
        snprintf(r->stopped, sizeof r->stopped, "the guard stopped it: state %.100s",
                 stream_name(from->header.state_names, (size_t)from->end.guard, name));
    } else if (from->end.guard > from->header.states) {
        snprintf(r->stopped, sizeof r->stopped, "the guard stopped it: near a singular position of closure %.100s",
                 stream_name(from->header.closure_names, (size_t)from->end.near_singular_closure, name));
    }
}

static void read_rows(record *r, stream *from, size_t room, size_t stride)
{
    size_t rows = 0;
    stream_part next = stream_read(from);
    for (; next == STREAM_ROW; next = stream_read(from)) {
        for (size_t i = 0; i < r->columns && frame_of(rows, stride) < room; i++) {
            take(r, rows, stride, i, (float)stream_number(from, i));
        }
        rows++;
    }
    r->frames = frame_of(rows, stride) < room ? frame_of(rows, stride) : room;
    r->end = (double)(rows > 0 ? rows - 1 : 0) * r->tick;
    if (next == STREAM_ERROR) {
        snprintf(r->stopped, sizeof r->stopped, "%.200s", from->error);
    } else {
        find_stop(r, from);
    }
}

static void find_places(record *r, size_t bodies)
{
    r->place = memory_for(bodies + 1, sizeof *r->place);
    for (size_t i = 0; i < bodies; i++) {
        char name[RECORD_NAME_BYTES];
        r->place[i] = record_column(r, record_name(name, "at_x", i));
        if (r->place[i] < 0) {
            quit("show: the run has no places of bodies; `show scene` writes a scene that has them");
        }
    }
}

record record_run(const char *command, size_t bodies)
{
    static stream from;
    record r = {.frames = 0};
    from = (stream){.file = popen(command, "r")};
    if (from.file == NULL || !stream_read_header(&from)) {
        quit("show: %s", from.file == NULL ? command : from.error);
    }
    const stream_header *h = &from.header;
    const size_t rows = h->period_ns > 0 ? (size_t)(h->duration_ns / h->period_ns) + 1 : 1;
    const size_t stride = stride_of(rows, 7 * bodies + 2 * h->outputs), room = rows / stride + 2;
    snprintf(r.method, sizeof r.method, "%s", h->method);
    snprintf(r.real, sizeof r.real, "%s", h->real);
    r.columns = (size_t)h->outputs;
    r.tick = h->step_size;
    r.interval = h->step_size * (double)stride;
    r.name = words_of(h->names, r.columns);
    r.unit = words_of(h->units, r.columns);
    find_places(&r, bodies);
    r.outputs = (size_t)r.place[0];
    make_room(&r, room);
    read_rows(&r, &from, room, stride);
    (void)pclose(from.file);
    if (r.frames == 0) {
        quit("show: %s", r.stopped[0] != '\0' ? r.stopped : "the run has no rows");
    }
    return r;
}

/* A table of the folder. */
static table table_in(const char *folder, const char *name, char separator)
{
    char path[FILE_PATH_BYTES];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return table_read(path, separator);
}

/* The value of a key in the summary; "" if there is none. */
static const char *said(const table *summary, const char *key)
{
    for (size_t i = 0; i < summary->rows; i++) {
        if (strcmp(table_text(summary, i, 0), key) == 0) {
            return table_text(summary, i, 1);
        }
    }
    return "";
}

/* Column 0 of the trace is the time, and row 0 has the names. */
static void take_trace(record *r, const table *trace, size_t stride)
{
    for (size_t row = 0; row + 1 < trace->rows; row++) {
        for (size_t i = 0; i < r->columns; i++) {
            take(r, row, stride, i, (float)table_number(trace, row + 1, i + 1));
        }
    }
}

record record_kept(const char *folder)
{
    static table trace, units, summary;
    record r = {.frames = 0};
    trace = table_in(folder, "trace.csv", ',');
    units = table_in(folder, "units.csv", ',');
    summary = table_in(folder, "summary.txt", ' ');
    if (trace.rows < 3 || table_cells(&trace, 0) < 2 || units.rows < 2) {
        quit("show: a run that is kept has no rows");
    }
    r.columns = r.outputs = table_cells(&trace, 0) - 1;
    const size_t rows = trace.rows - 1, stride = stride_of(rows, 3 * r.columns);
    snprintf(r.method, sizeof r.method, "%s", said(&summary, "method"));
    snprintf(r.real, sizeof r.real, "%s", said(&summary, "real"));
    r.tick = table_number(&trace, 2, 0) - table_number(&trace, 1, 0);
    r.interval = r.tick * (double)stride;
    r.end = table_number(&trace, rows, 0);
    r.name = trace.cell + 1;
    r.unit = units.cell + units.first[1] + 1;
    make_room(&r, rows / stride + 2);
    take_trace(&r, &trace, stride);
    r.frames = frame_of(rows, stride);
    return r;
}

int record_column(const record *r, const char *name)
{
    for (size_t i = 0; i < r->columns; i++) {
        if (strcmp(r->name[i], name) == 0) {
            return (int)i;
        }
    }
    return -1;
}

const char *record_name(char text[RECORD_NAME_BYTES], const char *what, size_t i)
{
    snprintf(text, RECORD_NAME_BYTES, "shown%zu_%s", i, what);
    return text;
}

pose record_pose(const record *r, size_t frame, int body)
{
    if (body == ON_GROUND) {
        return no_pose;
    }
    const float *v = r->value + frame * r->columns + r->place[body];
    const double q[4] = {(double)v[3], (double)v[4], (double)v[5], (double)v[6]};
    return pose_of(q, (vec){(double)v[0], (double)v[1], (double)v[2]});
}
