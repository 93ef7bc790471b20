/* What interrupts of the serial lines share with the program is volatile: without it, a compiler may keep a place in a
 * register, or count a byte before it is there. That shows in no run that one can count on. */
#include CHANNEL_OF /* port/mps2/channel.c */

#define IS_VOLATILE(object, type) _Generic(&(object), volatile type * : 1, default : 0)

_Static_assert(IS_VOLATILE(lines[0].in.first, uint32_t), "the place where a ring begins is volatile");
_Static_assert(IS_VOLATILE(lines[0].in.last, uint32_t), "the place where a ring ends is volatile");
_Static_assert(IS_VOLATILE(lines[0].in.bytes[0], uint8_t), "the bytes of a ring are volatile");
_Static_assert(IS_VOLATILE(*uarts[0], uart), "the registers of a line are volatile");
