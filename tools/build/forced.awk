# A generated plant in which every second tick has a discontinuity; its cause is between the ticks, outside of what is
# counted.
#
#     awk -v discontinuity=announced|detected -f forced.awk plant.c
#
# Announced: a tunable `forced` changes. Detected, where steps are checked: the usual error is so small that every error is
# larger; in the ticks between it is so large that none is.
/^static void drive\(/ { driven = 1 }

/^static const iso_model model/ {
    print "static void forced(void *const instance, const uint32_t tick)\n{\n    plant_memory *const memory = instance;"
    if (driven)
        print "    drive(instance, tick);"
    if (discontinuity == "announced")
        print "    memory->p[PLANT_P_FORCED] += (real)(tick % 2);"
    else {
        print "    memory->progress.usual = tick % 2 == 0 ? ISO_REAL_MAX : R(-1.0);"
        print "    memory->progress.watched = ISO_USUAL_STEPS;"
    }
    print "}\n"
}

/^ *\.drive = / { next }

# A tick of 10 ms, within which every step ends; the step is as long as it was.
/^ *\.period_ns = / { $0 = "    .period_ns = UINT32_C(10000000)," }

{ print }

/^ *\.step = step,/ { print "    .drive = forced," }
