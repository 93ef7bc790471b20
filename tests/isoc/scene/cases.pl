# Bad scenes: what isoc says of each, to the letter, and that it leaves its output alone. Prints TAP.
# cases.pl plain all COMMAND...: isoc as tests/host/requests.c is it. cases.pl memcheck TURN COMMAND...: under valgrind.
# TURN is of thirds of bad.txt, and of what is larger than memcheck is quick.
#
# bad.txt: `== NAME`, then either the scene itself or lines `edit: OLD -> NEW` on the scene good.scene, or on the one that
# a line `of: SCENE` names (each OLD stands in it once; \0, \n, \t, \\ and \xHH are read as in C), then lines
# `> LINE:COLUMN: MESSAGE`, the errors in their order; a scene without one is to be accepted.
$|=1; use strict;
use warnings;
use File::Path qw(make_path remove_tree);
use IPC::Open2;
use POSIX 'mkfifo';

my ($kind, $turn, @compiler) = @ARGV;
my $dir = "build/tests/scenes/$kind";
my $number = 0;
my $isoc = open2(my $answers, my $requests, @compiler);
remove_tree($dir);
make_path($dir);

sub check {
    my ($good, $name, @told) = @_;
    $number++;
    print $good ? 'ok' : 'not ok', " $number - $name\n";
    print map { "# $_\n" } @told unless $good;
}

sub slurp {
    open my $file, '<:raw', $_[0] or return undef;
    local $/;
    return scalar <$file>;
}

sub spit {
    open my $file, '>:raw', $_[0] or die "$_[0]: $!\n";
    print $file $_[1];
    close $file or die "$_[0]: $!\n";
}

sub has_turn {
    return $turn eq 'all' || $_[0] % 3 == $turn;
}

# Runs the compiler with these arguments, its stdout and its stderr there: exit status.
sub run {
    print $requests map({ "$_\0" } @_), "\n";
    $requests->flush;
    my $status = <$answers> // die "@compiler ended\n";
    chomp $status;
    return $status;
}

# Runs the compiler with these arguments and its stdout there: exit status, lines of stderr.
sub compile_to {
    my ($out, @arguments) = @_;
    my $err = "$dir/stderr";
    my $status = run($out, $err, @arguments);
    return ($status, [split /\n/, slurp($err)]);
}

# The same: exit status, lines of stderr, stdout.
sub compile {
    my ($status, $lines) = compile_to("$dir/stdout", @_);
    return ($status, $lines, slurp("$dir/stdout"));
}

sub unescape {
    my ($text) = @_;
    my %of = (n => "\n", t => "\t", '\\' => '\\', 0 => "\0");
    $text =~ s/\\(x[0-9A-F]{2}|.)/length $1 > 1 ? chr hex substr $1, 1 : $of{$1}/ge;
    return $text;
}

# A scene is refused with exactly these problems, and the plant of before is still what it was.
sub refused {
    my ($name, $scene, @expected) = @_;
    spit("$dir/plant.h", 'as before');
    spit("$dir/plant.c", 'as before');
    my ($status, $lines, $stdout) = compile($scene, '-o', $dir);
    my @told = map { /^\Q$scene\E:(?:(\d+:\d+):)? error: (.*)/ ? ($1 || '-') . ": $2" : () } @$lines;
    my $same = slurp("$dir/plant.h") eq 'as before' && slurp("$dir/plant.c") eq 'as before';
    my $good = $status eq '1' && $same && $stdout eq '' && "@told" eq "@expected";
    check($good, $name, "status $status" . ($same ? '' : ', output touched'), map({ "expected $_" } @expected), map { "told     $_" } @told);
}

# A scene is accepted without a word, and its plant written.
sub accepted {
    my ($name, $scene) = @_;
    spit("$dir/plant.c", 'as before');
    my ($status, $lines) = compile($scene, '-o', $dir);
    check($status eq '0' && !@$lines && slurp("$dir/plant.c") ne 'as before', "$name: accepted", @$lines);
}

my %base = map { $_ => slurp("tests/isoc/scene/$_.scene") } 'good', 'closed', 'effect', 'loop', 'events';
my @cases = grep { /\S/ } split /^== /m, slurp('tests/isoc/scene/bad.txt');
for my $case (map { $cases[$_] } grep { has_turn($_) } 0 .. $#cases) {
    my ($name, @lines) = split /\n/, $case;
    my @expected = map { /^> (.*)/ ? $1 : () } @lines;
    my @edits = map { /^edit: (.*?) -> (.*)/ ? [$1, $2] : () } @lines;
    my ($of) = map { /^of: (.*)/ ? $1 : () } @lines, 'of: good';
    my $scene = @edits ? $base{$of} : join '', map { "$_\n" } grep { !/^> / } @lines;
    for my $edit (@edits) {
        my ($old, $new) = map { unescape($_) } @$edit;
        my $count = () = $scene =~ /\Q$old\E/g;
        $count == 1 or die "$name: '$old' stands $count times in $of.scene\n";
        $scene =~ s/\Q$old\E/$new/;
    }
    spit("$dir/bad.scene", $scene);
    @expected ? refused($name, "$dir/bad.scene", @expected) : accepted($name, "$dir/bad.scene");
}

# Scenes that are no text of a sensible size.
spit("$dir/empty.scene", '');
my @nothing = map { "1:1: $_" } 'nothing moves: the scene has neither a joint that is not fixed nor an effect with a state',
  'the scene has no output: output angle = position of a joint', 'the scene has no step: step 1 ms';
refused('an empty file', "$dir/empty.scene", @nothing);
if (has_turn(0)) {
    spit("$dir/long.scene", 'step 1 ms ' . ('@' x 10_000_000));
    refused('a line of 10 MB', "$dir/long.scene", "1:11: unexpected character '\@'",
        map { s/1:1:/1:10000011:/r } @nothing[0, 1]);
}
spit("$dir/long_name.scene", 'body ' . ('b' x 1_000_000));
my ($status, $lines) = compile("$dir/long_name.scene", '-o', $dir);
check($status eq '1' && "@$lines" =~ /a name of 1000000 characters: at most 64 are allowed/, 'a name of 1 MB', @$lines);
for my $sign ('(', '-', 'f(', '-(') {
    spit("$dir/deep.scene", 'step ' . ($sign x 100_000));
    ($status, $lines) = compile("$dir/deep.scene", '-o', $dir);
    check($status eq '1' && $lines->[0] =~ /^\S+:1:\d+: error: parentheses and signs nested more than 100 deep/, "100,000 times $sign", $lines->[0] // $status);
}

# What is long and not deep is compiled.
my $many = $kind eq 'memcheck' ? 3_000 : 30_000;
my $sum = join ' + ', map { "$_ ug" } 1 .. $many;
spit("$dir/sum.scene", $base{good} =~ s/mass 1 kg/mass 1 kg + $sum/r);
accepted("a sum of $many terms", "$dir/sum.scene");
my $chain = join '', map({ "constant k$_ = k" . ($_ + 1) . " + 1 ug\n" } 1 .. $many - 1), "constant k$many = 1 ug\n";
spit("$dir/chain.scene", $chain . $base{good} =~ s/mass 1 kg/mass 1 kg + k1/r);
accepted("a chain of $many constants, each of the next", "$dir/chain.scene");
spit("$dir/circle.scene", ($chain =~ s/= 1 ug/= k2000/r) . $base{good});
refused('a chain of constants that ends in a circle', "$dir/circle.scene",
    "$many:" . (14 + length $many) . ": 'k2000' depends on itself");
spit("$dir/outputs.scene", $base{good} . join '', map { "output push$_ = force of pivot along x\n" } 1 .. 200);
accepted('200 outputs of forces', "$dir/outputs.scene");
spit("$dir/noise.scene", join '', map { chr(($_ * 7919 + ($_ >> 3) * 104729) % 256) } 1 .. 100_000);
($status, $lines) = compile("$dir/noise.scene", '-o', $dir);
check($status eq '1' && @$lines < 200, '100 kB of noise gets a page of errors at most', scalar(@$lines) . ' lines');
refused('a directory', $dir, '-: a directory, not a scene: name a .scene file in it');
refused('a device', '/dev/zero', '-: not a regular file: a scene is a text file');
# A FIFO without a writer must not be waited for.
my $fifo = "$dir/fifo.scene";
mkfifo($fifo, 0666) or die "$fifo: $!\n";
refused('a FIFO', $fifo, '-: not a regular file: a scene is a text file');
refused('a file that is not there', "$dir/absent.scene", '-: No such file or directory');
spit("$dir/caret.scene", $base{good} =~ s/kg/kgg/r);
($status, $lines) = compile("$dir/caret.scene", '-o', $dir);
check($lines->[1] eq '        mass 1 kgg' && $lines->[2] eq '               ^', 'the line and a caret under the word', @$lines);

# More than a plant counts in 16 bits: refused where it begins.
my @large = (
    ['tunable parameters', 3, '65539:9', sub { "tunable k$_[0] = 1" }],
    ['inputs', 5, '65540:7', sub { "input u$_[0] = 1 N*m" }],
    ['outputs', 21, '65557:8', sub { "output y$_[0] = position of pivot" }],
    ['states', 12, '32780:7', sub { "joint j$_[0] revolute { parent ground; child bob; axis z }" }],
);
for my $case (map { $large[$_] } grep { has_turn($_) } 0 .. $#large) {
    my ($what, $before, $place, $line) = @$case;
    my @scene = split /^/, $base{good};
    spit("$dir/many.scene", join '', @scene[0 .. $before - 1], map({ $line->($_) . "\n" } 1 .. 65_535), @scene[$before .. $#scene]);
    ($status, $lines) = compile("$dir/many.scene", '-o', $dir);
    my @told = grep { /error: too many/ } @$lines;
    check($status eq '1' && @told == 1 && $told[0] =~ /:$place: error: too many $what: a plant has at most 65535$/, "65,536 $what", @told);
}

# The control: the scenes that all cases are made from are good ones, and then the plant is written.
accepted("$_.scene", "tests/isoc/scene/$_.scene") for 'loop', 'closed', 'good';

# Where the closures put what has no start is told, and is so: the pin's two sides meet, and move alike.
my (undef, undef, $summary) = compile('tests/isoc/scene/loop.scene', '-o', $dir);
my %at = $summary =~ /^assembled (\w+) (\S+) rad(?:\/s)?$/mg;
my $coupler = atan2(1, 0) + $at{elbow};
my @gaps = (
    0.26 * cos($coupler) - 0.39 - 0.25 * cos $at{foot},
    0.1 + 0.26 * sin($coupler) - 0.25 * sin $at{foot},
    -0.1 - 0.26 * sin($coupler) * (1 + $at{elbow_speed}) + 0.25 * sin($at{foot}) * $at{foot_speed},
    0.26 * cos($coupler) * (1 + $at{elbow_speed}) - 0.25 * cos($at{foot}) * $at{foot_speed},
);
check(keys %at == 4 && !grep({ abs > 1e-8 } @gaps), 'what is assembled is told, and closes the loop', $summary, "@gaps");

# What a float cannot hold a double can.
spit("$dir/ratio.scene", $base{loop} =~ s/rocker \{ mass 1 kg/rocker { mass 4294967296 kg/r
      . 'close drive motion { first shaft; speed 1 rad/s }');
($status, $lines) = compile("$dir/ratio.scene", '-o', $dir, '--real', 'double');
check($status eq '0', 'a ratio of masses that float cannot hold, in double', @$lines);

# The constants of the equations are the same whether the start is found or given as it was found.
my $found = $base{loop} . "stabilisation lagrangian\n";
my $given = $found =~ s/(elbow|foot)( revolute \{)/$1$2 start $at{$1} rad; speed $at{"$1_speed"} rad\/s;/gr;
my @constants;
for my $scene ($found, $given) {
    spit("$dir/start.scene", $scene);
    compile("$dir/start.scene", '-o', $dir, '--real', 'double');
    push @constants, [slurp("$dir/plant.c") =~ /\bR\(([^)]*)\)/g];
}
my ($of_found, $of_given) = @constants;
my @other = grep { abs($of_found->[$_] - $of_given->[$_]) > 1e-7 * abs $of_found->[$_] } 0 .. $#$of_found;
check(@$of_found > 20 && @$of_found == @$of_given && !@other, 'a start that is found gives the constants that it gives if it is given',
    map { "$of_found->[$_] and $of_given->[$_]" } @other);

# It closes in two ways, mirrored at the line from the knee to the foot; a rough start says which.
my ($knee, $diagonal) = (atan2(0.1, -0.39), sqrt(0.39**2 + 0.1**2));
my $opening = ($diagonal**2 + 0.25**2 - 0.26**2) / (2 * $diagonal * 0.25);
my $half = atan2(sqrt(1 - $opening**2), $opening);
for my $way ([60, $knee - $half], [200, $knee + $half]) {
    spit("$dir/way.scene", $base{loop} =~ s/foot revolute \{/foot revolute { start about $way->[0] deg;/r);
    (undef, undef, $summary) = compile("$dir/way.scene", '-o', $dir);
    check($summary =~ /^assembled foot (\S+) rad$/m && abs($1 - $way->[1]) < 1e-8, "the way that is closed from $way->[0] deg", $summary, $way->[1]);
}
(undef, undef, $summary) = compile('tests/isoc/scene/good.scene', '-o', $dir);
check($summary !~ /^assembled/m, 'where nothing is assembled nothing is told', $summary);

my $first = slurp("$dir/plant.c") . slurp("$dir/plant.h");
compile('tests/isoc/scene/good.scene', '-o', "$dir/deeper/folder");
check($first eq slurp("$dir/deeper/folder/plant.c") . slurp("$dir/deeper/folder/plant.h"),
    'the same scene gives the same bytes, in another folder too');

# The command line.
for my $case (
    [['--method', 'rk5'], "--method:1:1: error: no method is called 'rk5' (did you mean 'rk4'?); "
      . 'take euler, heun, rk4, ab4, semi_implicit, abm4, abm4_pec, abm4_pecece, bdf4, rosenbrock or adams'],
    [['--step', '1 kg'], '--step:1:1: error: the step is in s; this is in kg'],
    [['--step', '-1 ms'], '--step:1:1: error: the step must be between 1 us and 1 s'],
    [['--step', '1 ms method rk4'], "--step:1:6: error: unknown unit 'method'"],
    [['--real', 'half'], 'isoc: error: --real must be float or double, not half'],
    [['--fast'], 'isoc: error: unknown option --fast'],
    [['--fmu', '--fmi', '1'], 'isoc: error: --fmi must be 2 or 3, not 1'],
    [['--fmi', '2'], 'isoc: error: --fmi is the version of the standard of an FMU: add --fmu to --fmi 2'],
    [['--step'], 'isoc: error: a value is missing after --step'],
    [['-o', $dir], 'isoc: error: given twice: -o'],
    [['--dot'], "isoc: error: --dot makes no plant: leave out -o $dir"],
    [['other.scene'], 'isoc: error: more than one scene: other.scene'],
) {
    ($status, $lines) = compile('tests/isoc/scene/good.scene', '-o', $dir, @{ $case->[0] });
    check($status eq '1' && $lines->[0] eq $case->[1], "isoc @{$case->[0]}", "expected $case->[1]", @$lines);
}
($status, $lines) = compile('tests/isoc/scene/good.scene');
check($status eq '1' && $lines->[0] =~ /no folder for the plant/, 'isoc without -o', @$lines);
($status, $lines) = compile('tests/isoc/scene/good.scene', '-o', "$dir/plant.c/below");
check($status eq '1' && $lines->[0] =~ /Not a directory/, 'an output folder that cannot be', @$lines);
my $stdout;
($status, $lines, $stdout) = compile('tests/isoc/scene/good.scene', '-o', $dir, '--step', '500us', '--method', 'ab4', '--real', 'double');
check($status eq '0' && $stdout =~ /^method ab4\nstep 0\.0005 s\nreal double\nstates 2\n/m, 'the command line overrides the scene', $stdout);

# What is accepted compiles, also with what a compiler need not take: names of more than 4095 characters together.
sub compiles {
    my ($name, $scene, @options) = @_;
    accepted($name, $scene);
    return if $kind eq 'memcheck';
    my @cc = (split(' ', $ENV{CC} // 'cc'), qw(-std=c11 -Wall -Wextra -Wpedantic -Werror -Woverlength-strings -I. -c), "-I$dir", @options);
    check(system(@cc, "$dir/plant.c", '-o', "$dir/plant.o") == 0, "$name: compiles");
    return;
}
spit("$dir/names.scene", $base{good} . join '', map { 'output ' . 'a' x 50 . "_$_ = position of bob\n" } 1 .. 80);
compiles('long names', "$dir/names.scene");

# A double holds what a float cannot.
spit("$dir/wide.scene", $base{good} =~ s/10 deg/1e-46 rad; speed 1e39 rad\/s/r);
($status, $lines) = compile("$dir/wide.scene", '-o', $dir, '--real', 'double');
check($status eq '0' && !@$lines, 'numbers that only a double holds', @$lines);

# Standard output that cannot be written.
for my $case (['--help'], ['--methods'], ['tests/isoc/scene/good.scene', '-o', $dir], ['tests/isoc/scene/good.scene', '--dot']) {
    ($status, $lines) = compile_to('/dev/full', @$case);
    check($status eq '1' && "@$lines" eq 'isoc: error: standard output: No space left on device',
        "isoc @$case to a full device", "status $status", @$lines);
}

# Memcheck finds what is planted, and nothing where nothing is.
if ($kind eq 'memcheck') {
    for my $case (['leak', 99], ['branch', 99], ['nothing', 0]) {
        my $status = run("$dir/stdout", "$dir/stderr", 'planted', $case->[0]);
        check($status == $case->[1], "memcheck ends with $case->[1] for: $case->[0]", "status $status");
    }
}

# What it took of the processor counts when it has ended.
close $requests;
waitpid $isoc, 0;
print "1..$number\n";
