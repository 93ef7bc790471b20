# shellcheck shell=sh
# Programs of a few instructions and what they take by hand, of rules.txt; read by tests/check/cycles.sh.

# of_core CORE: its lines, with the number of each before it.
of_core()
{
    awk -F ' *[|] *' -v core="$1" -v OFS='|' '$1 == core && $2 != "return" { print ++n, $2, $3, $4 }' tests/cycles/rules.txt
}

# assembly CORE: a program that calls a function `rule_N` for each of its lines.
assembly()
{
    of_core "$1" | awk -F '|' -v avr="$(case $1 in atm*) echo yes ;; esac)" '
        BEGIN {
            if (avr) print ".global main\nmain: cli"
            else {
                print ".syntax unified\n.thumb\n.global reset\nvectors: .word 0x20008000, reset + 1\n.thumb_func\nreset:"
                print "ldr r0, =0xe000ed88\nldr r1, =0x00f00000\nstr r1, [r0]\ndsb\nisb"
            }
        }
        {
            if (avr) printf "ldi r26, 0\nldi r27, 4\nldi r28, 0\nldi r29, 4\nldi r30, 0\nldi r31, 4\ncall rule_%d\n", $1
            else printf "ldr r0, =0x20001000\nbl rule_%d\n", $1
            text = $2
            gsub(/; */, "\n", text)
            functions = functions sprintf(".type rule_%d, %%function\nrule_%d:\n%s\n%s\n", $1, $1, text, avr ? "ret" : "bx lr\n.ltorg")
        }
        END {
            if (avr) print "sleep"
            else print "ldr r0, =0x18\nldr r1, =0x20026\nbkpt 0xab\nb .\n.ltorg"
            print functions
        }'
}

# counted CORE LISTING TRACE: for each line its instructions, what it took, and what it has to take, with the return.
counted()
{
    back=$(awk -F ' *[|] *' -v core="$1" -v OFS=' ' '$1 == core && $2 == "return" { print $3, $4 }' tests/cycles/rules.txt)
    of_core "$1" | while IFS='|' read -r number text least most; do
        printf 'rule\t%s\t%s\t%s\n' "$text" "$least+${back% *}" "$most+${back#* }"
        build/cycles tick "tools/measure/cycles/cores/$1.txt" "$2" "rule_$number" "" none=none <"$3" || exit
    done | awk -F '\t' '
        function sum(text, part, n, i, all) {
            gsub(/-/, "+-", text)
            n = split(text, part, "+")
            for (i = 1; i <= n; i++) all += part[i]
            return all
        }
        $1 == "rule" { text = $2; least = $3; most = $4 }
        $1 == "part" && $2 == "tick" { printf "%s|%s %s|%s %s\n", text, $4, $5, sum(least), sum(most) }'
}

# untried CORE: the rules of its table of which no line has an instruction, but for those that end a program or wait.
untried()
{
    { of_core "$1" && echo && cat "tools/measure/cycles/cores/$1.txt"; } | awk -F ' *[|] *' '
        # Without conditions and sizes.
        function is(text, name) {
            sub(/[.].*/, "", text)
            if (sub(/[*]$/, "", name)) return index(text, name) == 1
            return text == name || text == name "s" || text == name "eq" || text == name "ne"
        }
        $0 == "" { behind = 1 }
        !behind {
            n = split($2, part, / *; */)
            for (i = 1; i <= n; i++) { sub(/^1: */, "", part[i]); sub(/^2: */, "", part[i]); sub(/ .*/, "", part[i]); tried[part[i]] }
        }
        behind && NF == 6 && !/^#/ && $1 !~ /^(wfi|bkpt|sleep)/ {
            found = 0
            n = split($1, name, " ")
            for (text in tried) for (i = 1; i <= n; i++) found = found || is(text, name[i])
            if (!found) print $1
        }'
}
