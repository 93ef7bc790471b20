#!/bin/sh
# A million packets that nobody should send, between the ticks of a plant; fewer under valgrind; and defects that they
# find.
. tests/host/test.sh
begin xcp/malformed
slave="core/xcp/daq.c core/xcp/measure.c core/xcp/stimulation.c core/xcp/slave.c core/xcp/transfer.c"
real float
build/isoc tests/core/xcp/masters/cart.scene -o "$out/cart" >"$out/summary"
result $? "the plant"

# built NAME SOURCE: the packets, for a slave with this source for what may be accessed.
built()
{
    # shellcheck disable=SC2086
    EXTRA="-I$out/cart" program "$1" tests/core/xcp/masters/malformed.c tests/host/report.c "$out/cart/plant.c" $slave "$2"
}

built malformed core/xcp/access.c
result $? "it compiles"
joined malformed "$out/malformed" 1000000
joined valgrind valgrind --quiet --error-exitcode=99 "$out/malformed" 20000

# planted WHAT SCRIPT: with this change of what may be accessed, something does not hold.
planted()
{
    sed "$2" core/xcp/access.c >"$out/access.c" && ! cmp -s core/xcp/access.c "$out/access.c" && built planted "$out/access.c" &&
        ! "$out/planted" 1000000 >"$out/tap" && grep -q '^not ok' "$out/tap"
    result $? "found: $1"
}
# planted_stimulation WHAT SCRIPT: likewise in what is stimulated.
planted_stimulation()
{
    sed "$2" core/xcp/stimulation.c >"$out/stimulation.c" && ! cmp -s core/xcp/stimulation.c "$out/stimulation.c" &&
        slave="core/xcp/daq.c core/xcp/measure.c $out/stimulation.c core/xcp/slave.c core/xcp/transfer.c" &&
        built planted core/xcp/access.c && ! "$out/planted" 1000000 >"$out/tap" && grep -q '^not ok' "$out/tap"
    result $? "found: $1"
}
planted "a download to all that can be read" 's/ ? ISO_XCP_ACCESS_DENIED : ISO_XCP_WRITE_PROTECTED;/ ? ISO_XCP_ACCESS_DENIED : (memcpy((uint8_t *)(uintptr_t)iso_xcp_at(access, address, count), bytes, count), ISO_XCP_NONE);/'
planted "limits that are not looked at" 's/x <= limits->most/x <= x/'
planted "a download of which the first number is checked" 's/i \* sizeof(real) < offset + count; i++/i * sizeof(real) <= offset; i++/'
planted_stimulation "a place of an input that is not looked at" 's/ < access->input_count ?/ < 10000 ?/'
finish
