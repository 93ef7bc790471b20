# The harness that `prove` runs the tests with: writes all they print to build/tests/log, shows what failed, compares the
# numbers of tests between the variants of the unit tests, and ends with one line "N passed, N failed".
#
# tests/times has the seconds of processor time that each test took when they were measured last, longest first. In that
# order they begin, so that every core has work to the end; what is not in it begins first of all. Of what took longer than
# $TALLY_MOST nothing is run. What they take this time goes to $TEST_TIMES.txt. What passes is marked with $TEST_STATE, and with
# the same state tests/exec.sh does not run it again. $TEST_BEGAN is how many processes the machine had started when all began.
package Tally;

use strict;
use warnings;
use parent 'TAP::Harness';

my $log = $ENV{TALLY_LOG} || 'build/tests/log';
my %lines;

# Keeps what a test prints as it comes.
sub listen_to {
    my ($parser, $job) = @_;
    my $kept = $lines{ ref $job eq 'ARRAY' ? $job->[0] : $job->filename } = [];
    $parser->callback(ALL => sub { push @$kept, $_[0]->raw });
}

# What one test file counts for: passed, failed, skipped. One that ended badly without naming a failed test, or that did
# not keep to its plan, counts as one failure.
sub count {
    my ($parser) = @_;
    my ($failed, $skipped) = (scalar $parser->failed, scalar $parser->skipped);
    my $passed = $parser->passed - $skipped;
    if ($parser->skip_all) {
        $skipped = 1;
    }
    if (!$failed && ($parser->parse_errors || $parser->exit || $parser->wait)) {
        $failed = 1;
    }
    return ($passed, $failed, $skipped);
}

sub write_log {
    open my $file, '>', $log or die "$log: $!\n";
    for my $name (sort keys %lines) {
        print $file "=== $name\n", map { "$_\n" } @{ $lines{$name} };
    }
    close $file or die "$log: $!\n";
}

# The lines of a failed file that tell why: failed tests and the comments around them, or its last lines.
sub show_failure {
    my ($name, $parser) = @_;
    my @kept = @{ $lines{$name} };
    my @shown = grep { /^(not ok|#|Bail out)/ } @kept;
    if (@shown > 40) {
        @shown = ((grep { !/^#/ } @shown), "# the comments stand in $log");
    }
    if (!$parser->failed) {
        @shown = (@kept > 20 ? @kept[ -20 .. -1 ] : @kept, map { "# $_" } $parser->parse_errors);
    }
    print "\n$name failed (status ", $parser->exit, "):\n", map { "    $_\n" } @shown;
}

# The seconds of each test in tests/times.
sub times_measured {
    my %seconds;
    open my $file, '<', $ENV{TALLY_TIMES} || 'tests/times' or return ();
    while (<$file>) {
        $seconds{$2} = $1 if /^\s*([0-9.]+) (\S+)$/;
    }
    return %seconds;
}

# Those that are to be run, in the order in which they begin.
sub choose {
    my %seconds = times_measured();
    my $most = $ENV{TALLY_MOST} || 1e9;
    my @chosen = grep { !exists $seconds{$_} || $seconds{$_} <= $most } @_;
    return sort { ($seconds{$b} // 1e9) <=> ($seconds{$a} // 1e9) || $a cmp $b } @chosen;
}

# Puts the seconds of user and system time of all tests, which tests/exec.sh left in $TEST_TIMES, in one file.
sub write_times {
    my $folder = $ENV{TEST_TIMES} or return;
    my %seconds;
    for my $path (glob "$folder/*") {
        open my $file, '<', $path or die "$path: $!\n";
        my ($own, $children) = <$file>;
        (my $name = $path) =~ s{.*/}{};
        $name =~ tr{:}{/};
        $seconds{$name} = 0;
        $seconds{$name} += 60 * $1 + $2 while ($children // '') =~ /([0-9]+)m([0-9.]+)s/g;
    }
    open my $file, '>', "$folder.txt" or die "$folder.txt: $!\n";
    printf $file "%7.1f %s\n", $seconds{$_}, $_ for sort { $seconds{$b} <=> $seconds{$a} || $a cmp $b } keys %seconds;
    close $file or die "$folder.txt: $!\n";
}

# Marks a test that passed with the state of all that it follows from, beside what tests/exec.sh kept of it.
sub mark_passed {
    my ($name) = @_;
    (my $folder = $name) =~ tr{/}{:};
    $folder = ($ENV{TEST_KEPT} || 'build/tests/passed') . "/$folder";
    return if !$ENV{TEST_STATE} || !-e "$folder/output";
    open my $file, '>', "$folder/state" or die "$folder/state: $!\n";
    print $file "$ENV{TEST_STATE}\n";
    close $file or die "$folder/state: $!\n";
}

# How many tests exec.sh did not run again.
sub count_kept {
    return scalar grep { ($lines{$_}[0] // '') =~ /^# not run again: / } keys %lines;
}

# Every variant of the unit tests must have run the same number of tests. Returns the numbers of passes and failures.
sub compare_variants {
    my ($parsers) = @_;
    my (%tests, $passed, $failed);
    for my $name (keys %$parsers) {
        if ($name =~ m{^build/tests/(plain|asan|memcheck|m4f)/(float|double)/}) {
            $tests{$2}{$1} += $parsers->{$name}->tests_run;
        }
    }
    ($passed, $failed) = (0, 0);
    for my $real (reverse sort keys %tests) {
        my %of = %{ $tests{$real} };
        my %numbers = map { $_ => 1 } values %of;
        my $same = keys %numbers == 1;
        $same ? $passed++ : $failed++;
        print "unit tests in $real: ", join(', ', map { "$_ $of{$_}" } sort keys %of),
          $same ? "\n" : ": the numbers of tests differ\n";
    }
    return ($passed, $failed);
}

# How many processes the machine has started since all began, those of others among them; nothing where it does not say.
sub count_processes {
    open my $file, '<', '/proc/stat' or return;
    my ($now) = join('', <$file>) =~ /^processes ([0-9]+)$/m;
    return defined $now && $ENV{TEST_BEGAN} ? $now - $ENV{TEST_BEGAN} : undef;
}

sub runtests {
    my ($self, @tests) = @_;
    $self->callback(made_parser => \&listen_to);
    my $aggregate = $self->SUPER::runtests(choose(@tests));
    my %parsers;
    @parsers{ $aggregate->descriptions } = $aggregate->parsers($aggregate->descriptions);

    my @sum = (0, 0, 0);
    for my $name (sort keys %parsers) {
        my @one = count($parsers{$name});
        $sum[$_] += $one[$_] for 0 .. 2;
        $one[1] ? show_failure($name, $parsers{$name}) : mark_passed($name);
    }
    write_log();
    write_times();
    my @compared = compare_variants(\%parsers);
    $sum[0] += $compared[0];
    $sum[1] += $compared[1];
    my ($kept, $all) = (count_kept(), scalar keys %parsers);
    print "$kept of $all tests were not run again: they passed, and nothing has changed since\n" if $kept;
    my $started = count_processes();
    print "$started processes were started meanwhile on this machine\n" if defined $started;
    print "$sum[0] passed, $sum[1] failed", $sum[2] ? ", $sum[2] skipped" : '', "\n";
    exit($sum[1] || !$sum[0] ? 1 : 0);
}

1;
