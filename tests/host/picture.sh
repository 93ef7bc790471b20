# shellcheck shell=sh
# Pictures read back, and what they must show; read after tests/host/test.sh and `begin`.

# reads_picture: builds the program of tests/tools/lab/picture/.
reads_picture()
{
    EXTRA=-O0 program picture tests/tools/lab/picture/*.c
}

# shows SVG [POINTS all|drawn|covered]...: whether the picture shows these points, and has no text that is cut off. If
# not, it is said in comments.
shows()
{
    "$out/picture" "$@" >"$out/shown" 2>&1
    shows_status=$?
    [ $shows_status -eq 0 ] || head -n 20 "$out/shown" | sed 's/^/# /'
    return $shows_status
}

# report_points TSV: what a report's picture must show: every error over cost and over the step, and of each kind the
# Pareto front, the points with a smaller error than any that are as cheap.
report_points()
{
    report_panels='
        function over(what) { return title[$1] "|" what }
        function cost() { return ($1 ~ /^cycles/ ? "cycles" : "instructions") " per second, " ($1 == "double" ? "host" : "Cortex-M4F") }
        BEGIN {
            FS = OFS = "\t"
            title["float"] = "float"
            title["compensated"] = "float, compensated sums"
            title["cycles_float"] = title["float"]
            title["cycles_compensated"] = title["compensated"]
            title["double"] = "double"
        }
        $5 == "inf" || $5 + 0 <= 0 || $5 + 0 > 100 { next }'
    sed 1d "$1" | awk "$report_panels"'{ print over(cost()), $2, $8, $5; print over("step, ms"), $2, 1000 * $3, $5 }'
    sed 1d "$1" | sort -t "$(printf '\t')" -k 1,1 -k 8,8g -k 5,5g | awk "$report_panels"'
        $1 != kind || $5 + 0 < least { print over(cost()), "Pareto front", $8, $5; kind = $1; least = $5 + 0 }'
}

# stands_out SVG POINTS: whether in the panels over the cost the points of the Pareto fronts have the looks of the
# legend and of the panels over the step, and all others do not.
stands_out()
{
    awk -F '\t' '
        FNR == NR { if ($1 ~ /instructions/) { if ($2 == "Pareto front") fronts++; else points++ } next }
        /^use / && match($0, /translate\([^)]*/) {
            split(substr($0, RSTART + 10, RLENGTH - 10), at, ",")
            match($0, / color=.#[0-9a-f]*/)
            looks = substr($0, RSTART, RLENGTH)
            if (at[2] < 320) { upper[++n] = looks } else if (at[2] < 610) lower[looks]
        }
        END {
            for (i = 1; i <= n; i++) if (upper[i] in lower) best++; else pale++
            exit !(fronts > 0 && best == fronts && pale == points)
        }' "$2" RS='<' "$1"
}
