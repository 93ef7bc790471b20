#!/bin/sh
# Runs a program on a board by OpenOCD: board.sh TTY CONFIGURATION PROGRAM. The bytes of the serial line go to the
# standard output, until none has come for 3 s. The status of the program is not known here.
tty=$1
stty -F "$tty" 460800 raw -echo min 0 time 30 || exit 1
openocd -f "$2" -c "program $3 verify exit" >&2 || { echo "board.sh: openocd could not write $3" >&2; exit 1; }
{ sleep 0.5 && openocd -f "$2" -c "init; reset run; exit" >&2; } &
cat <"$tty"
wait
