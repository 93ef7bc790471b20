#!/bin/sh
# Runs a program in simavr: run.sh PROGRAM NANOSECONDS. The duration goes into the EEPROM. The simulator shows the
# console as lines of hexadecimal digits; they come out as bytes. The status is that of the program. The simulator has
# the EEPROM at address 0x810000.
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
eeprom=$folder/eeprom.hex
perl -e '
    my @bytes = unpack "C8", pack "Q<", $ARGV[0];
    my @record = (8, 0, 0, 0, @bytes);
    my $sum = 0;
    $sum += $_ for @record;
    printf ":02000004008179\n:%s%02X\n:00000001FF\n", join("", map { sprintf "%02X", $_ } @record), -$sum & 0xFF;
' "$2" >"$eeprom"
simavr -m atmega1284p -f 1000000000 "$1" -ee "$eeprom" 2>&1 >/dev/null | perl -e '
    binmode STDOUT;
    $| = 1;
    my $status = 1;
    while (<STDIN>) {
        $status = $1, last if /\e\[32m!([0-9])/;
        print pack "H*", $1 if /\e\[32m([0-9a-f]+)/;
    }
    1 while <STDIN>;
    exit $status;
'
