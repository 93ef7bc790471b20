#include "tests/port/soft/operations.h"

#include "port/soft/binary32.h"

#define OPERATION(name, parameters, expression)                                                                        \
    static uint32_t name parameters                                                                                    \
    {                                                                                                                  \
        return expression;                                                                                             \
    }

OPERATION(add, (const uint32_t a, const uint32_t b), soft_add(a, b))
OPERATION(subtract, (const uint32_t a, const uint32_t b), soft_subtract(a, b))
OPERATION(multiply, (const uint32_t a, const uint32_t b), soft_multiply(a, b))
OPERATION(divide, (const uint32_t a, const uint32_t b), soft_divide(a, b))
OPERATION(compare, (const uint32_t a, const uint32_t b),
          soft_is_less(a, b) | soft_is_equal(a, b) << 1 | soft_is_at_most(a, b) << 2 | soft_is_unordered(a, b) << 3)
OPERATION(from_int64, (const uint32_t low, const uint32_t high), soft_from_int64((uint64_t)high << 32 | low))
OPERATION(from_uint64, (const uint32_t low, const uint32_t high), soft_from_uint64((uint64_t)high << 32 | low))
OPERATION(to_int64, (const uint32_t a, const uint32_t is_high), (uint32_t)(soft_to_int64(a) >> (is_high == 0 ? 0 : 32)))
OPERATION(to_uint64, (const uint32_t a, const uint32_t is_high),
          (uint32_t)(soft_to_uint64(a) >> (is_high == 0 ? 0 : 32)))

/* Those of one operand. */
#define OPERATION_1(name)                                                                                              \
    static uint32_t name(const uint32_t a, const uint32_t unused)                                                      \
    {                                                                                                                  \
        (void)unused;                                                                                                  \
        return soft_##name(a);                                                                                         \
    }

OPERATION_1(root)
OPERATION_1(from_int32)
OPERATION_1(from_uint32)
OPERATION_1(to_int32)
OPERATION_1(to_uint32)

const operations the_operations = {add,         subtract,   multiply,    divide,   root,      compare,  from_int32,
                                   from_uint32, from_int64, from_uint64, to_int32, to_uint32, to_int64, to_uint64};
