# A generated plant in which every second tick has a discontinuity; its cause is between the ticks, outside of what is counted.
# Announced: a tunable `forced` changes. Detected, where steps are checked: the usual error is so small that every error is
# larger; in the ticks between it is so large that none is. A tick is 10 ms, within which every step ends; the step is as long
# as it was.
#
#     awk -v discontinuity=announced|detected -f forced.awk plant.c
/^static void drive\(/ { driven = 1 }
/^const iso_model plant_model/ {
    places++
    # The function that stands in the place of the plant's own `drive`.
    print "static void forced(void *const instance, const uint64_t tick)\n{\n    plant_memory *const memory = instance;"
    if (driven) print "    drive(instance, tick);"
    if (discontinuity == "announced") print "    memory->p[PLANT_P_FORCED] += (real)(tick % 2);"
    if (discontinuity == "detected") {
        print "    memory->progress.usual = tick % 2 == 0 ? ISO_REAL_MAX : R(-1.0);"
        print "    memory->progress.watched = ISO_USUAL_STEPS;"
    }
    print "}\n"
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
    if (places != 3) {
        print "forced: this is no plant made by isoc" > "/dev/stderr"
        exit 1
    }
}
