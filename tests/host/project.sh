# A copy of the project for tests that call make, so that what they build or alter disturbs nobody; read after
# tests/host/test.sh and `begin`.

# The tests run under make themselves: what that one was told is no concern of the one that is tried.
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES SCENE METHOD STEP SECONDS TARGET REAL SCRIPT V CFLAGS

# project: copies the sources into $out/project, and the tools as far as they are built, with their dates: what is
# built once is not built again for every test.
project()
{
    mkdir -p "$out/project"
    {
        find . ! -type d ! -path './build/*' ! -path './.git/*'
        find build -maxdepth 1 -type f ! -name lock 2>/dev/null
        find build/obj/tools -type f 2>/dev/null
    } | tar -cf - -T - | tar -xf - -C "$out/project"
}

# unoptimised: the copy compiles for the host without optimisation: a run has the same bits (check/same_bits.sh), and compiles in a
# third of the time. What reports measure runs for longer than that, and is optimised a little.
unoptimised()
{
    sed -i 's/^PORT_OPTIMISE = -O2$/PORT_OPTIMISE = -O0/' "$out/project/port/sim/port.mk" &&
        sed -i 's/\(COMPILE=$(call quote,$(CC) $(WARNINGS)\) -O2 /\1 -O1 /' "$out/project/tools/build/goals.mk"
}

# call ARGUMENT...: make in the copy; its output is in $out/output, what it said in $out/errors. Returns its status.
call()
{
    make -C "$out/project" --no-print-directory "$@" >"$out/output" 2>"$out/errors" </dev/null
}

# value KEY: what the last call printed for it in its summary, which comes last.
value()
{
    value_found=
    while IFS= read -r value_line || [ -n "$value_line" ]; do
        case $value_line in
        "$1 "*) value_found=${value_line#"$1 "} ;;
        esac
    done <"$out/output"
    [ -z "$value_found" ] || printf '%s\n' "$value_found"
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
