# A copy of the project for tests that call isochron, so that what they build or alter disturbs nobody; read after
# tests/host/test.sh and `begin`.

# The tests run under make themselves: what that one was told is no concern of the one that is tried.
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES SCENE METHOD STEP SECONDS TARGET REAL SCRIPT V CFLAGS TEST_BUILT

# project: copies the sources into $out/project, and the tools and the objects that programs share, as far as they are
# built, with their dates: what is built once is not built again for every test.
project()
{
    mkdir -p "$out/project"
    find . \( -path ./.git -o -type d -path './build/*' ! -path ./build/obj ! -path './build/obj/tools*' \) -prune \
        -o ! -type d ! -path ./build/lock -exec cp -a --parents -t "$out/project" {} +
    [ ! -d build/rp2040js ] || ln -s "$PWD/build/rp2040js" "$out/project/build"
}

# unoptimised [COMPILER]: the copy compiles for the host without optimisation, by this compiler: a run has the same bits
# (promises/same_bits.t), and compiles in a third of the time, by clang in less. What reports measure runs for longer
# than that, and is optimised a little.
unoptimised()
{
    sed -i "${1:+s/^PORT_CC = .*/PORT_CC = $1/}"';s/^PORT_OPTIMISE = -O2$/PORT_OPTIMISE = -O0/' "$out/project/port/host/port.mk"
}

# isochron COMMAND...: tools/isochron in the copy; its output is in $out/output, what it said in $out/errors. Returns
# its status.
isochron()
{
    (cd "$out/project" && exec tools/isochron "$@") >"$out/output" 2>"$out/errors" </dev/null
}

# value KEY: what the last call printed for it in its summary, which comes last.
value()
{
    read_value "$1"
    [ -z "$value" ] || printf '%s\n' "$value"
}

# read_value KEY: the same in $value, by no process.
read_value()
{
    value=
    while IFS= read -r value_line || [ -n "$value_line" ]; do
        case $value_line in
        "$1 "*) value=${value_line#"$1 "} ;;
        esac
    done <"$out/output"
}

# printed KEY VALUE: whether the last call printed this for it; an empty word is nothing.
printed()
{
    read_value "$1"
    [ "$value" = "$2" ]
}

# says PATTERN: whether a line of what the last call said has it.
says()
{
    while IFS= read -r said || [ -n "$said" ]; do
        # shellcheck disable=SC2254
        case $said in
        *$1*) return 0 ;;
        esac
    done <"$out/errors"
    return 1
}

# explain: shows the end of the last call as comments.
explain()
{
    tail -n 15 "$out/output" "$out/errors" | sed 's/^/# /'
}

# expect STATUS NAME: a result; a failure is explained.
expect()
{
    [ "$1" -eq 0 ] || explain
    result "$1" "$2"
}
