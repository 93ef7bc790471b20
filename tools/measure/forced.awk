# A generated plant in which every second tick has a discontinuity; its cause is between the ticks, in a function of its
# own that is not counted. Announced: a tunable `forced` changes; changed: the first tunable; input: the first input.
# Detected, where steps are checked: the usual error is so small that every error is larger; in the ticks between it is
# so large that none is. A tick is 10 ms, within which every step ends; the step is as long as it was.
#
#     awk -v discontinuity=announced|changed|input|detected -f forced.awk plant.c
BEGIN {
    cause["announced"] = "    memory->p[PLANT_P_FORCED] += (real)(tick % 2);"
    cause["changed"] = "    memory->p[0] += (real)(tick % 2);"
    cause["input"] = "    memory->u[0] += (real)(tick % 2);"
    cause["detected"] = "    memory->progress.usual = tick % 2 == 0 ? ISO_REAL_MAX : R(-1.0);\n" \
        "    memory->progress.watched = ISO_USUAL_STEPS;"
}
/^static void drive\(/ { driven = 1 }
/^const iso_model plant_model/ {
    places++
    print "__attribute__((noinline)) static void forced_cause(plant_memory *const memory, const uint64_t tick)\n{"
    print cause[discontinuity] "\n}\n"
    # The function that stands in the place of the plant's own `drive`.
    print "static void forced(void *const instance, const uint64_t tick)\n{\n    plant_memory *const memory = instance;"
    if (driven) print "    drive(instance, tick);"
    print "    forced_cause(memory, tick);\n}\n"
}
/^    .period_ns = / {
    places++
    $0 = "    .period_ns = UINT32_C(10000000),"
}
/^    .step = step,/ {
    places++
    $0 = $0 "\n    .drive = forced,"
}
/^    .drive = / { next }
{ print }
END {
    if (places != 3 || !(discontinuity in cause)) {
        print "forced: this is no plant made by isoc, or no cause" > "/dev/stderr"
        exit 1
    }
}
