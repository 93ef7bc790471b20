/* A real of a build with lanes, -DISO_LANES=16: a vector of 16 numbers, by the vector extension of gcc and clang. Each
 * lane is a plant with its own states, inputs, tunables and outputs; the tick and the constants are those of all. An
 * operation in each lane is the scalar one, so that a lane has the bits of a single plant. core/numbers/real.h includes
 * it, and says what each function does. An `iso_scalar` is one number for all lanes: a constant in a table, a limit.
 *
 * Each value that differs from lane to lane is as wide as a scalar, counts too: a memory is rows of so many words.
 */
#ifndef ISO_CORE_NUMBERS_LANES_H
#define ISO_CORE_NUMBERS_LANES_H

#if ISO_LANES != 2 && ISO_LANES != 4 && ISO_LANES != 8 && ISO_LANES != 16 && ISO_LANES != 32
#error "Isochron: ISO_LANES is 2, 4, 8, 16 or 32"
#endif

#define ISO_VECTOR __attribute__((vector_size(ISO_LANES * sizeof(iso_word))))

#define ISO_REAL_NAMED(name, type) name##_lanes_##type /* none is that of a plant alone */

typedef iso_scalar real ISO_VECTOR;
typedef iso_word iso_bits ISO_VECTOR;
typedef iso_bits iso_flag;
typedef iso_bits iso_count;
typedef iso_bits iso_steps;
typedef iso_bits iso_rest;
typedef iso_bits iso_turns;
typedef struct iso_pair {
    iso_count first, second;
} iso_pair;
#ifdef ISO_REAL_DOUBLE
typedef int64_t iso_signed ISO_VECTOR;
#else
typedef int32_t iso_signed ISO_VECTOR;
#endif

/* The same number in all lanes. */
#define ISO_REPEAT_2(x) x, x
#define ISO_REPEAT_4(x) ISO_REPEAT_2(x), ISO_REPEAT_2(x)
#define ISO_REPEAT_8(x) ISO_REPEAT_4(x), ISO_REPEAT_4(x)
#define ISO_REPEAT_16(x) ISO_REPEAT_8(x), ISO_REPEAT_8(x)
#define ISO_REPEAT_32(x) ISO_REPEAT_16(x), ISO_REPEAT_16(x)
#define ISO_REPEAT_N(n, x) ISO_REPEAT_##n(x)
#define ISO_REPEAT(n, x) ISO_REPEAT_N(n, x)
#define R(literal) ((real){ISO_REPEAT(ISO_LANES, ISO_SCALAR(literal))})
#define ISO_COUNT(count) ((iso_count){ISO_REPEAT(ISO_LANES, count)})

static inline real iso_all(const iso_scalar x)
{
    return (real){ISO_REPEAT(ISO_LANES, x)};
}

static inline bool iso_any(const iso_bits mask)
{
    enum { WORDS = sizeof(iso_bits) / sizeof(uint64_t) };
    uint64_t words[WORDS], any = 0;
    memcpy(words, &mask, sizeof words);
    for (int i = 0; i < WORDS; i++) {
        any |= words[i];
    }
    return any != 0;
}

static inline iso_bits iso_hidden(const iso_bits mask)
{
    return mask;
}

static inline iso_bits iso_mask_where(const bool condition)
{
    const iso_word word = (iso_word)0 - condition;
    return (iso_bits){ISO_REPEAT(ISO_LANES, word)};
}

#define ISO_NOTHING ((iso_bits){0})

static inline void iso_spread(real *const x, const iso_scalar *const numbers, const uint16_t n)
{
    for (uint16_t i = 0; i < n; i++) {
        x[i] = iso_all(numbers[i]);
    }
}

static inline iso_flag iso_is_larger(const real a, const real b)
{
    return (iso_flag)(a > b);
}

static inline iso_flag iso_is_set(const iso_bits bits)
{
    return (iso_flag)(bits != 0);
}

static inline iso_count iso_more_unless(const iso_flag flag, const iso_count count)
{
    return count - ~flag;
}

static inline iso_count iso_count_where(const iso_bits mask, const uint32_t count)
{
    return mask & count;
}

static inline iso_pair iso_pair_of(const iso_count first, const iso_count second)
{
    return (iso_pair){first, second};
}

static inline iso_pair iso_pair_more(const iso_pair pair, const iso_count second)
{
    return (iso_pair){pair.first, pair.second + second};
}

/* Where the mask is not set, good[n] = x[n]. */
static inline void iso_hold(real *const x, real *const good, const uint32_t n, const iso_bits mask)
{
    for (uint32_t i = 0; i < n; i++) {
        const iso_bits held = (iso_bits)good[i] & mask, taken = (iso_bits)x[i] & ~mask;
        x[i] = good[i] = (real)(held | taken);
    }
}

static inline real iso_real_of_turns(const iso_turns turns)
{
    enum { BEYOND = 8 * sizeof(iso_word) - 32 };
    return __builtin_convertvector((iso_signed)(turns << BEYOND) >> BEYOND, real);
}

static inline real iso_real_of_whole(const iso_bits whole)
{
    return iso_real_of_turns(whole);
}

#endif
