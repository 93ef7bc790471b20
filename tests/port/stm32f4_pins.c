/* Tables of pins: those that are refused, in QEMU, where no converter answers. */
#include <string.h>

#include "port/port.h"
#include "port/stm32f4/pins.h"
#include "tests/tap.h"

static const pins_row good_input = {.place = 0, .kind = PINS_VOLTAGE, .pin = 0, .at_0 = R(-1.0), .at_1 = R(1.0)};
static const pins_row good_output = {.place = 0, .kind = PINS_VOLTAGE, .pin = 4, .at_0 = R(-1.0), .at_1 = R(1.0)};

/* Whether these two inputs and two outputs are refused with a text that has this in it; NULL: they are not refused. */
static void refused(const pins_row a, const pins_row b, const pins_row c, const pins_row d, const char *const text,
                    const char *const name)
{
    const pins_row inputs[] = {a, b};
    const pins_row outputs[] = {c, d};
    const char *const error = pins_error(inputs, 2, outputs, 2);
    tap_ok(text == NULL ? error == NULL : error != NULL && strstr(error, text) != NULL, name);
}

int main(void)
{
    pins_row a = good_input, b = good_input, c = good_output, d = good_output;
    b.place = 1;
    b.pin = 1;
    d.place = 1;
    d.kind = PINS_DUTY;
    d.pin = 6;
    refused(a, b, c, d, NULL, "two inputs and two outputs are taken");
    a.pin = 3 * PINS_OF_A_PORT;
    refused(a, b, c, d, "without a converter", "a pin without a converter");
    a = good_input;
    a.pin = 2;
    refused(a, b, c, d, "the console's", "the pin of the console");
    a = good_input;
    a.kind = PINS_QUADRATURE;
    refused(a, b, c, d, "measures no duty", "an input that this port cannot measure");
    a = good_input;
    b.place = 0;
    refused(a, b, c, d, "an input is on two pins", "an input on two pins");
    b.place = 1;
    c.pin = 3;
    refused(a, b, c, d, "cannot show it", "a pin that cannot show an output");
    c.pin = 7;
    refused(a, b, c, d, "cannot show it", "a voltage on a pin that shows duties");
    c = good_output;
    c.kind = PINS_LEVEL;
    refused(a, b, c, d, "shows no levels", "an output that this port cannot show");
    c = good_output;
    c.at_1 = c.at_0;
    refused(a, b, c, d, "differ", "an output without a range");
    c = good_output;
    c.safe = R(1.5);
    refused(a, b, c, d, "safe outside of 0 to 1", "a safe state beyond the range");
    c = good_output;
    d.pin = 4;
    d.kind = PINS_VOLTAGE;
    refused(a, b, c, d, "a pin stands in two rows", "two outputs on a pin");
    d.kind = PINS_DUTY;
    d.pin = 6;
    b.pin = 6;
    refused(a, b, c, d, "a pin stands in two rows", "an input and an output on a pin");

    real u = R(7.0);
    const char *const error = pins_start();
    tap_ok(error == NULL, "the table of the build is taken");
    iso_port_read(&u, 1);
    tap_same(u, R(7.0), "an input whose converter does not answer keeps its value");
    tap_done();
}
