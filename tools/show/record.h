/* A run: the outputs of a plant at a number of frames, and what they were between these. */
#ifndef ISO_TOOLS_SHOW_RECORD_H
#define ISO_TOOLS_SHOW_RECORD_H

#include <stdbool.h>
#include <stddef.h>

#include "tools/show/shape.h"

typedef struct record {
    char method[16], step[64], real[16];
    double tick, interval; /* s: of the plant; from frame to frame */
    size_t frames, columns;
    char **name, **unit; /* [columns] */
    float *value;        /* [frames][columns]; */
    float *least, *most; /* likewise, since the frame before */
    int *place;          /* [bodies]: the first column of their poses */
    double end;          /* s: when the run ended */
    char stopped[256];   /* why it ended too early; empty: it did not */
} record;

/* Runs the command, which writes a stream (core/application/stream.h). Exits with a message where there is none. */
record record_run(const char *command, size_t bodies);

/* A run that make keeps in a folder: trace.csv, units.csv and summary.txt. It has no bodies. */
record record_kept(const char *folder);

/* The column of this name; -1 if there is none. */
int record_column(const record *r, const char *name);

/* What the recorded scene calls the place and the turn of body i, and the input of force i. */
enum { RECORD_NAME_BYTES = 64 };
void record_name(char text[RECORD_NAME_BYTES], const char *what, size_t i);

/* Where body i is in a frame. */
pose record_pose(const record *r, size_t frame, int body);

#endif
