#!/bin/sh
# Writes an A2L: puts the addresses of a linked program into the template that isoc wrote.
#
#     a2l.sh NM PROGRAM PLACES TEMPLATE float|double
#
# @SYMBOL+OFFSET@ in the template becomes a number, and so does @bytes of SYMBOL@. The symbols of PLACES, the object of
# tools/a2l/places.c, list the statistics; choice__ are those that a program may lack. Any other symbol that the program
# does not have, or has twice, is an error: then nothing is written.
set -eu
nm=$1 program=$2 places=$3 template=$4 real=$5
cat "$program" "$places" "$template" >/dev/null
{
    $nm -S --defined-only "$program" | sed 's/^/P /'
    $nm -S --defined-only "$places" | sed 's/^/S /'
    sed 's/^/T/' "$template"
} | awk -v real="$real" '
    function fail(why) { print "a2l.sh: " why >"/dev/stderr"; failed = 1; exit 1 }
    function number(hex,  value, i) {
        for (i = 1; i <= length(hex); i++) {
            value = value * 16 + index("0123456789abcdef", tolower(substr(hex, i, 1))) - 1
        }
        return value
    }
    function address(symbol, offset) {
        if (times[symbol] != 1) {
            fail("the program has " (times[symbol] + 0) " symbols " symbol ", and not one")
        }
        if (offset >= bytes[symbol]) {
            fail(symbol " has " bytes[symbol] " bytes, and nothing at " offset)
        }
        if (at[symbol] + offset > 4294967295) {
            fail(symbol " is beyond the 32 bits of an address of XCP")
        }
        return sprintf("0x%08X", at[symbol] + offset)
    }
    function statistic(i) {
        split(rows[i], part, "__")
        type = part[2] == "REAL" ? (real == "double" ? "FLOAT64_IEEE" : "FLOAT32_IEEE") : part[2]
        if (part[4] == "margin") {
            type = "A_INT64"
        }
        most = part[2] == "REAL" ? 1e38 : type == "A_INT64" ? "9223372036854775807" : "18446744073709551615"
        least = type == "A_UINT64" ? 0 : "-" most
        return "    /begin MEASUREMENT statistics." part[4] " \"statistic\" " type " NO_COMPU_METHOD 0 0 " least " " most \
            "\n      ECU_ADDRESS " address(part[3], offsets[i]) \
            "\n      /begin IF_DATA XCP /begin DAQ_EVENT FIXED_EVENT_LIST EVENT 0 /end DAQ_EVENT /end IF_DATA\n    /end MEASUREMENT"
    }
    $1 == "P" && NF == 5 {
        sub(/_(float|double)$/, "", $5)
        times[$5]++
        at[$5] = number($2)
        bytes[$5] = number($3)
    }
    $1 == "S" && NF == 5 && $5 ~ /^choice__/ {
        split($5, part, "__")
        if (times[part[3]] == 0 || number($3) > bytes[part[3]]) {
            next
        }
        sub(/^choice__/, "place__", $5)
    }
    $1 == "S" && NF == 5 && $5 ~ /^place__/ {
        rows[++count] = $5
        offsets[count] = number($3) - 1
    }
    $1 !~ /^T/ { next }
    { sub(/^T/, "") }
    $0 == "@statistics@" { for (i = 1; i <= count; i++) print statistic(i); next }
    $0 == "@names of statistics@" {
        for (i = 1; i <= count; i++) {
            split(rows[i], part, "__")
            print "        statistics." part[4]
        }
        next
    }
    {
        while (match($0, /@bytes of [a-z_]+@/)) {
            symbol = substr($0, RSTART + 10, RLENGTH - 11)
            address(symbol, 0)
            $0 = substr($0, 1, RSTART - 1) sprintf("0x%X", bytes[symbol]) substr($0, RSTART + RLENGTH)
        }
        while (match($0, /@[a-z_]+\+[0-9]+@/)) {
            place = substr($0, RSTART + 1, RLENGTH - 2)
            split(place, of, "+")
            $0 = substr($0, 1, RSTART - 1) address(of[1], of[2]) substr($0, RSTART + RLENGTH)
        }
        print
    }
    END { exit failed }'
