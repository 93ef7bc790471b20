/* The table of a board, and what all boards do with it. A port's pins.c includes this, and so has pins_error,
 * pins_start, pins_read, pins_publish and pins_safe. */
#ifndef ISO_PORT_PINS_TABLE_H
#define ISO_PORT_PINS_TABLE_H

#include "port/pins/pins.h"

/* The row behind the last is none. */
static const pins_row inputs[] = {
#ifdef PINS_INPUTS
    PINS_INPUTS,
#endif
    {.kind = PINS_KINDS}};
static const pins_row outputs[] = {
#ifdef PINS_OUTPUTS
    PINS_OUTPUTS,
#endif
    {.kind = PINS_KINDS}};
static const size_t input_rows = sizeof inputs / sizeof inputs[0] - 1,
                    output_rows = sizeof outputs / sizeof outputs[0] - 1;

static bool shares_a_pin(const pins_row *const a, const unsigned a_width, const pins_row *const b,
                         const unsigned b_width)
{
    return a->pin < b->pin + b_width && b->pin < a->pin + a_width;
}

/* The problem of row i of both tables, the inputs first, by itself or with one before it. */
static const char *row_error(const pins_row *const in, const size_t input_count, const pins_row *const out,
                             const size_t i)
{
    const bool is_output = i >= input_count;
    const pins_row *const row = is_output ? &out[i - input_count] : &in[i];
    const char *error = pins_lacks(row, is_output);
    if (error != NULL) {
        return error;
    }
    if (!(row->at_0 < row->at_1 || row->at_0 > row->at_1)) {
        return "a row needs two numbers that differ, at_0 and at_1";
    }
    if (!(row->safe >= 0 && row->safe <= 1)) {
        return "a row has safe outside of 0 to 1";
    }
    for (size_t k = 0; k < i && error == NULL; k++) {
        const bool is_before = k >= input_count;
        const pins_row *const before = is_before ? &out[k - input_count] : &in[k];
        if (shares_a_pin(row, pins_width(row, is_output), before, pins_width(before, is_before))) {
            error = "a pin stands in two rows";
        } else if (!is_output && before->place == row->place) {
            error = "an input is on two pins";
        } else {
            error = pins_clash(row, is_output, before, is_before);
        }
    }
    return error;
}

const char *pins_error(const pins_row *const in, const size_t input_count, const pins_row *const out,
                       const size_t output_count)
{
    const char *error = NULL;
    for (size_t i = 0; i < input_count + output_count && error == NULL; i++) {
        error = row_error(in, input_count, out, i);
    }
    return error;
}

const char *pins_start(void)
{
    const char *error = pins_error(inputs, input_rows, outputs, output_rows);
    for (size_t i = 0; i < input_rows && error == NULL; i++) {
        error = pins_open(&inputs[i], i, false);
    }
    for (size_t i = 0; i < output_rows && error == NULL; i++) {
        error = pins_open(&outputs[i], i, true);
    }
    return error;
}

void pins_read(real *const u, const size_t count)
{
    for (size_t i = 0; i < input_rows; i++) {
        const pins_row *const row = &inputs[i];
        real v = 0;
        if (row->place < count && pins_measure(row, i, &v)) {
            u[row->place] = row->at_0 + (row->at_1 - row->at_0) * v;
        }
    }
}

void pins_publish(const real *const y, const size_t count)
{
    for (size_t i = 0; i < output_rows; i++) {
        const pins_row *const row = &outputs[i];
        if (row->place < count) {
            const real v = (y[row->place] - row->at_0) / (row->at_1 - row->at_0);
            pins_show(row, i, row->kind == PINS_QUADRATURE ? v : iso_clamp(v, R(0.0), R(1.0)));
        }
    }
}

void pins_safe(void)
{
    for (size_t i = 0; i < output_rows; i++) {
        if (outputs[i].kind != PINS_QUADRATURE) {
            pins_show(&outputs[i], i, outputs[i].safe);
        }
    }
}

#endif
