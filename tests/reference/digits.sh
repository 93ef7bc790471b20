# shellcheck shell=sh
# The table of digits, tests/digits.md, that `isochron digits` prints; read after tests/host/test.sh and `begin`.
# $out/digits has its rows.

# digits MECHANISM REAL STEP: a row for each case of what `joined` has joined last, of its largest error until the last
# time: of the lines
#     ok 1 - CASE, t = TIME s: error ERROR ... DEMAND
#     ok 2 - CASE: at every step the energy is off by at most ERROR J; allowed DEMAND
# A case is told where its name has more than a word.
digits()
{
    awk -v mechanism="$1" -v real="$2" -v step="$3" '
        function row()
        {
            if (until != "")
                printf "| %s | %s | %s | %s s | %.0e | %d | %s | %s | %s |\n", mechanism name, real, step, until, worst,
                    -log(worst) / log(10), demand, energy, allowed
            until = ""
            energy = allowed = "-"
            worst = 0
        }
        BEGIN {
            sub(/[0-9.]*/, "& ", step)
            row()
        }
        / t = [^ ]* s: error / {
            match($0, /, t = [^ ]* s: error /)
            if (until + 0 > substr($0, RSTART + 6) + 0) row()
            name = substr($0, 1, RSTART - 1)
            sub(/^[^-]* - /, "", name)
            name = name ~ / / ? ", " name : ""
            until = substr($0, RSTART + 6) + 0
            error = substr($0, RSTART + RLENGTH) + 0
            if (!(error <= worst)) {
                worst = error
                demand = $NF
            }
        }
        / energy is off by at most / {
            match($0, /at most [^ ]*/)
            energy = sprintf("%.0e", substr($0, RSTART + 8))
            allowed = $NF
        }
        END { row() }
    ' "$out/tap" >>"$out/digits"
}

# rows_of FILE MECHANISMS...: the rows of a table of digits; the mechanisms are options of grep.
rows_of()
{
    rows_file=$1
    shift
    grep '^| [^-]' "$rows_file" | grep -v '^| reference ' | grep "$@"
}

# listed MECHANISMS...: the rows of tests/digits.md are those measured here; and one with another digit is found. Not
# where `isochron digits` prints the rows that are to be.
listed()
{
    [ -z "${MAKES_DIGITS-}" ] || return 0
    rows_of tests/digits.md "$@" | diff "$out/digits" - >"$out/unlike"
    listed_status=$?
    sed 's/^/# /' "$out/unlike"
    result $listed_status "tests/digits.md has the $(grep -c . "$out/digits") rows that were measured"
    sed 's/e-\([0-9]\)/e-1\1/' tests/digits.md >"$out/changed.md"
    ! rows_of "$out/changed.md" "$@" | cmp -s "$out/digits" -
    result $? "found: another error in tests/digits.md"
}
