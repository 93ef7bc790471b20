#!/bin/sh
# Runs a program on a board: board.sh TTY CONFIGURATION PROGRAM. OpenOCD writes it into the flash and starts it; what comes on the
# serial line goes to the standard output, until nothing has come for 3 s. The status of the program is not known here.
tty=$1
stty -F "$tty" 460800 raw -echo min 0 time 30 || exit 1
openocd -f "$2" -c "program $3 verify exit" >&2 || { echo "board.sh: openocd could not write $3" >&2; exit 1; }
{ sleep 0.5 && openocd -f "$2" -c "init; reset run; exit" >&2; } &
cat <"$tty"
wait
