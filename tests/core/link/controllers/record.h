/* A snapshot of a plant, and the file that keeps it. */
#ifndef ISO_TESTS_RECORD_H
#define ISO_TESTS_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum { ROOM = 4096 };

static uint8_t record[ROOM];

/* Its bytes; 0: there is no such file. */
static inline size_t read_record(const char *const path)
{
    FILE *const file = fopen(path, "rb");
    const size_t bytes = file == NULL ? 0 : fread(record, 1, sizeof record, file);
    return file == NULL || fclose(file) != 0 ? 0 : bytes;
}

static inline bool write_record(const char *const path, const size_t bytes)
{
    FILE *const file = fopen(path, "wb");
    const bool good = file != NULL && bytes > 0 && fwrite(record, 1, bytes, file) == bytes;
    return file != NULL && fclose(file) == 0 && good;
}

#endif
