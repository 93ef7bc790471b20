#!/bin/sh
# The sizes and limits that the documents of core name are the constants of the code.
. tests/host/test.sh
begin limits
real float
EXTRA=-D_POSIX_C_SOURCE=200809L program limits tests/core/link/controllers/limits.c && "$out/limits" >"$out/texts"
result $? "the constants of core and of the monitor"
count=0
while read -r document text; do
    count=$((count + 1))
    stated "$document" "$text"
    result $? "$document: $text"
done <"$out/texts"
[ $count -eq 14 ]
result $? "$count texts"
! stated core/xcp/README.md "A packet of commands has up to 65 bytes (MAX_CTO)" >"$out/found" && [ -s "$out/found" ]
result $? "found: another number"
finish
