# Two runs, 1 and 2, and their common outputs and times.
#
#     run_name[r]      the last part of its folder
#     shared[i, r]     the column of an output, of `outputs`
#     instant[i, r]    the row of a time, of `instants`
function find_outputs(a, b)
{
    for (a = 1; a < columns[1]; a++) {
        for (b = 1; b < columns[2] && name[2, b] != name[1, a]; b++) continue
        if (b == columns[2]) continue
        if (unit[1, a] != unit[2, b])
            fail("compare: " name[1, a] " is in '" unit[1, a] "' in " run_name[1] ", and in '" unit[2, b] "' in " run_name[2])
        shared[++outputs, 1] = a
        shared[outputs, 2] = b
    }
    if (!outputs) fail("compare: " run_name[1] " and " run_name[2] " have no output in common")
}

# Times are ticks times a step, rounded: the same where they differ by less than a thousandth of the shorter step.
function find_instants(a, b, t, near, every)
{
    for (a = 1; a <= 2; a++) every[a] = count[a] > 1 ? line[a, 2] + 0 : 1e300
    near = 1e-3 * smaller(every[1], every[2])
    b = 1
    for (a = 1; a <= count[1]; a++) {
        t = line[1, a] + 0
        while (b < count[2] && line[2, b] + 0 < t - near) b++
        if (size_of(line[2, b] - t) >= near) continue
        instant[++instants, 1] = a
        instant[instants, 2] = b
    }
    if (instants < 2)
        fail(sprintf("compare: %s has a row every %g s and %s every %g s: they have no time in common but the start; run both " \
            "with one STEP, or a multiple of it", run_name[1], every[1], run_name[2], every[2]))
}

function read_both(r)
{
    for (r = 1; r <= 2; r++) {
        run_name[r] = ARGV[r]
        sub(/.*\//, "", run_name[r])
        read_run(r, ARGV[r], 300)
    }
    find_outputs()
    find_instants()
}
