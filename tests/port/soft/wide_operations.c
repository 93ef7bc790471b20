#include "tests/port/soft/wide_operations.h"

#include "port/soft/binary64.h"

#define OPERATION(name, expression)                                                                                    \
    static uint64_t name(const uint64_t a, const uint64_t b)                                                           \
    {                                                                                                                  \
        (void)b;                                                                                                       \
        return expression;                                                                                             \
    }

OPERATION(sum, soft64_add(a, b))
OPERATION(difference, soft64_subtract(a, b))
OPERATION(product, soft64_multiply(a, b))
OPERATION(quotient, soft64_divide(a, b))
OPERATION(root, soft64_root(a))
OPERATION(comparison, soft64_is_less(a, b) | soft64_is_equal(a, b) << 1 | soft64_is_at_most(a, b) << 2 |
                          soft64_is_unordered(a, b) << 3)
OPERATION(from_int32, soft64_from_int32((uint32_t)a))
OPERATION(from_uint32, soft64_from_uint32((uint32_t)a))
OPERATION(from_int64, soft64_from_int64(a))
OPERATION(from_uint64, soft64_from_uint64(a))
OPERATION(to_int32, soft64_to_int32(a))
OPERATION(to_uint32, soft64_to_uint32(a))
OPERATION(to_int64, soft64_to_int64(a))
OPERATION(to_uint64, soft64_to_uint64(a))
OPERATION(from_binary32, soft64_from_binary32((uint32_t)a))
OPERATION(to_binary32, soft64_to_binary32(a))

const char *const wide_names[WIDE_KINDS] = {
    "sum",        "difference",  "product",  "quotient",  "root",     "comparison", "from int32", "from uint32",
    "from int64", "from uint64", "to int32", "to uint32", "to int64", "to uint64",  "from float", "to float"};
wide_operation *const wide_operations[WIDE_KINDS] = {
    sum,        difference,  product,  quotient,  root,     comparison, from_int32,    from_uint32,
    from_int64, from_uint64, to_int32, to_uint32, to_int64, to_uint64,  from_binary32, to_binary32};
