#!/bin/sh
# A name is a noun that says what it holds, or begins with is_, has_ or the like: no variable, parameter or member in
# core, the ports and the tools has one of these words alone as its name. Functions and types may.
. tests/host/test.sh
. tests/host/plain.sh
begin check/names

WORDS='made|of|told|given|asked|said|seen'

# names FOLDER: "FILE:LINE: NAME" of each such name where it is declared, below a folder.
names()
{
    (cd "$1" && find core port tools \( -name '*.[ch]' -o -name '*.[ch].in' \) | sort | xargs awk -v words="$WORDS" "$PLAIN"'
        BEGIN { whole = "(^|[^A-Za-z_0-9])(" words ")($|[^A-Za-z_0-9])" }

        # How many brackets are open behind a text; those of `for` do not count.
        function depth(text) {
            gsub(/for \(/, "", text)
            return gsub(/[([{]/, "", text) - gsub(/[])}]/, "", text)
        }

        # Whether a name declares something, from what stands before it since the last statement, and what behind it.
        function declares(before, after, last) {
            if (before ~ /^#define [A-Za-z_0-9]+\([^)]*$/) return after ~ /^[,)]/
            if (before ~ /FOR_(ALL|EACH) \([^,(]*, $/) return 1
            if (before ~ /[A-Za-z_0-9*] \(\**(const )?$/) return after ~ /^\)[([]/ && before ~ /\*(const )?$/
            if (after !~ /^ *([],;=)[]|: *[0-9A-Z]|$)/ || after ~ /^ *==/) return 0
            if (before ~ /^ *typedef / && depth(before) == 0) return 0
            if (before ~ /, *\**(const )?$/) return depth(before) == 0
            if (before ~ /} *$/) return before !~ /^}/ || !is_type
            sub(/ \**$/, "", before)
            if (!match(before, /(^|[^A-Za-z_0-9])[A-Za-z_][A-Za-z_0-9]*$/)) return 0
            last = substr(before, RSTART)
            sub(/^[^A-Za-z_]/, "", last)
            return last !~ /^(return|else|goto|case|sizeof|struct|union|enum|define|defined|if|elif|ifdef|ifndef|undef)$/
        }

        FNR == 1 { inside = 0; text = "" }
        {
            line = inside || $0 ~ /["\x27\/]/ ? plain($0) : $0
            if (line ~ /^[a-z].*\{ *$/) is_type = line ~ /^typedef /
            if (line ~ whole) {
                at = text == "" ? 0 : length(text) + 1
                all = text == "" ? line : text " " line
                while (match(substr(all, at + 1), whole)) {
                    from = at + RSTART
                    if (substr(all, from, 1) !~ /[A-Za-z]/) from++
                    match(substr(all, from), "^(" words ")")
                    name = substr(all, from, RLENGTH)
                    at = from + RLENGTH - 1
                    if (declares(substr(all, 1, from - 1), substr(all, at + 1))) print FILENAME ":" FNR ": " name
                }
            }
            sub(/ *\\?$/, "", line)
            text = line ~ /[;{}]$/ || line == "" || (line ~ /^#/ && $0 !~ /\\$/) ? "" : text == "" ? line : text " " line
        }')
}

names . >"$out/names"
sed 's/^/# a name that is no noun: /' "$out/names"
[ ! -s "$out/names" ]
result $? "no variable, parameter or member of core, port and tools is called $(echo "$WORDS" | sed 's/|/, /g')"

# planted EXTENSION LINES: whether of a file with the text of the input just these lines are found, one for each name.
planted()
{
    rm -rf "$out/tree"
    mkdir -p "$out/tree/core" "$out/tree/port" "$out/tree/tools/isoc"
    cat >"$out/tree/tools/isoc/planted.$1"
    names "$out/tree" >"$out/planted"
    [ "$(cut -d : -f 2 "$out/planted" | paste -sd ' ')" = "$2" ]
}

planted c '3 4 5 6 7 9 10 12 13' <<'END'
static int f(int a)
{
    int of = a;
    const real *const given = &x, *other = y;
    double begun, told; /* s */
    for (int i = 0, said = 1; i < said; i++) {
        static const char *made[] = {"a", "b"};
        const labels states = labels_of(a, b), inputs = labels_of(b),
                     seen = labels_of(c);
        FOR_ALL (const quantity, asked, in->all, in->count) {
            g(asked, of, *of, made[0], (a + of) * of);
            int (*of)(int x);
            value a = first(b, c), given;
        }
    }
    return of;
}
END
result $? "found: variables of these names"
planted c.in '1 3 3 5 9' <<'END'
static int f(const script *of, int b)
{
    int (*call)(void *of, const value given[]);
}
#define PLACE(type, of, name) offsetof(of, name)

static int
g(int a, /* the first */ const real *restrict const
      b, bool asked)
{
}
END
result $? "found: parameters of these names"
planted h.in '2 3 4 7 10' <<'END'
typedef struct given {
    const script *of;
    bool a, seen; /* both */
    unsigned made : 3;
    struct {
        int x;
    } told;
} given;

static struct { int x; } said;
END
result $? "found: members of these names"

# What is no declaration of such a name: other words, types and functions, comments and texts.
planted h '' <<'END'
/* int of; */
/* A comment of two lines:
    int given; */
#define text "int of;"
typedef struct seen {
    int of_x, x_of, is_asked, given_2; /* int told; */
} seen;
typedef const struct seen *made;
static int of(const seen *p, seen q);
static seen told(void);

static int f(void)
{
    const char quote = '"', *text = "a, *of; int said";
    return of(&(seen){1}, told()) + b.of + c->given * sizeof(made);
}
END
result $? "let through: these words in comments, in texts, in longer names, and as the names of types and functions"
finish
