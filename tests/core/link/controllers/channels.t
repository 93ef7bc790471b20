#!/bin/sh
# Addresses of the host's channels, and peers that come and go.
. tests/host/test.sh
begin link/channels

program channels tests/core/link/controllers/channels.c tests/host/report.c port/host/*.c port/unix/*.c
result $? "it compiles"
joined channels "$out/channels" "$out"

# One that sends half of what there is no room for is found.
sed 's/count > WAITING_BYTES - to->waiting_bytes/count == 0/; s/memcpy(to->waiting +/const size_t room = WAITING_BYTES - to->waiting_bytes, cut = count < room ? count : room;\n    memcpy(to->waiting +/; s/waiting_bytes, bytes, count);$/waiting_bytes, bytes, cut);/; s/waiting_bytes += count/waiting_bytes += cut/' \
    port/unix/channel.c >"$out/cut.c"
program cut tests/core/link/controllers/channels.c tests/host/report.c port/host/*.c port/unix/console.c "$out/cut.c" port/unix/datagrams.c && ! "$out/cut" "$out" >"$out/tap" &&
    grep -q '^not ok .* records were sent' "$out/tap"
result $? "found: a send of a part"
finish
