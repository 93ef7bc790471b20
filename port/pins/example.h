/* A table of pins for a Raspberry Pi Pico and for this machine: GPIO3 is the duty of a drive, from -10 to 10 of the
 * first input; GPIO10 to GPIO12 are an encoder of 4000 counts a turn with an index, of the first output, in radians. */
#define PINS_INPUTS                                                                                                    \
    {                                                                                                                  \
        .place = 0, .kind = PINS_DUTY, .pin = 3, .at_0 = R(-10.0), .at_1 = R(10.0)                                     \
    }
#define PINS_OUTPUTS                                                                                                   \
    {                                                                                                                  \
        .place = 0, .kind = PINS_QUADRATURE, .pin = 10, .at_0 = R(0.0), .at_1 = R(1.5707963268e-3), .turn = 4000       \
    }
