/* Tables of pins: those that are refused, in QEMU, where no converter answers. */
#include <string.h>

#include "port/port.h"
#include "port/stm32f4/pins.h"
#include "tests/tap.h"

static const pins_input good_input = {.input = 0, .port = 'A', .pin = 0, .at_0 = R(-1.0), .at_full = R(1.0)};
static const pins_output good_output = {.output = 0, .port = 'A', .pin = 4, .at_0 = R(-1.0), .at_full = R(1.0)};

/* Whether these two inputs and two outputs are refused with a text that has this in it; NULL: they are not refused. */
static void refused(const pins_input a, const pins_input b, const pins_output c, const pins_output d,
                    const char *const text, const char *const name)
{
    const pins_input inputs[] = {a, b};
    const pins_output outputs[] = {c, d};
    const char *const error = pins_error(inputs, 2, outputs, 2);
    tap_ok(text == NULL ? error == NULL : error != NULL && strstr(error, text) != NULL, name);
}

int main(void)
{
    pins_input a = good_input, b = good_input;
    pins_output c = good_output, d = good_output;
    b.input = 1;
    b.pin = 1;
    d.output = 1;
    d.pin = 6;
    refused(a, b, c, d, NULL, "two inputs and two outputs are taken");
    a.port = 'D';
    refused(a, b, c, d, "without a converter", "a pin without a converter");
    a = good_input;
    a.pin = 2;
    refused(a, b, c, d, "the console's", "the pin of the console");
    a = good_input;
    b.input = 0;
    refused(a, b, c, d, "an input is on two pins", "an input on two pins");
    b.input = 1;
    c.pin = 3;
    refused(a, b, c, d, "cannot show it", "a pin that cannot show an output");
    c = good_output;
    c.at_full = c.at_0;
    refused(a, b, c, d, "differ", "an output without a range");
    c = good_output;
    c.safe = R(1.5);
    refused(a, b, c, d, "safe from 0 to 1", "a safe state beyond the range");
    c = good_output;
    d.pin = 4;
    refused(a, b, c, d, "a pin shows two outputs", "two outputs on a pin");
    d.pin = 6;
    b.pin = 6;
    refused(a, b, c, d, "measures an input and shows", "an input and an output on a pin");

    real u = R(7.0);
    const char *const error = pins_start();
    tap_ok(error == NULL, "the table of the build is taken");
    iso_port_read(&u, 1);
    tap_same(u, R(7.0), "an input whose converter does not answer keeps its value");
    tap_done();
}
