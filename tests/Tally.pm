# The harness that `prove` runs the tests with: writes all they print to build/tests/log, shows what failed, compares the
# numbers of tests between the variants of the unit tests, and ends with one line "N passed, N failed".
#
# tests/times has the seconds of processor time that each test took when they were measured last, longest first. In that
# order they begin, so that every core has work to the end; what is not in it begins first of all. Of what took longer than
# $TALLY_MOST, or is not in it, nothing is run.
#
# What each takes this time goes to the folder $TEST_TAKES, and for all to $TEST_TAKES.txt. What passes is kept in the folder
# $TEST_KEPT under $TEST_STATE, and with the same state tests/exec.sh does not run it again.
package Tally;

use strict;
use warnings;
use parent 'TAP::Harness';
use File::Path 'make_path';

my $log = $ENV{TALLY_LOG} || 'build/tests/log';
my ($takes, $kept, $state) = @ENV{qw(TEST_TAKES TEST_KEPT TEST_STATE)};
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
    my @all = @{ $lines{$name} };
    my @shown = grep { /^(not ok|#|Bail out)/ } @all;
    if (@shown > 40) {
        @shown = ((grep { !/^#/ } @shown), "# the comments stand in $log");
    }
    if (!$parser->failed) {
        @shown = (@all > 20 ? @all[ -20 .. -1 ] : @all, map { "# $_" } $parser->parse_errors);
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
    my @chosen = grep { ($seconds{$_} // ($ENV{TALLY_MOST} ? 2 * $most : 0)) <= $most } @_;
    my $unknown = grep { !exists $seconds{$_} } @_;
    print "$unknown of the tests are not in tests/times, and left out\n" if $unknown && $ENV{TALLY_MOST};
    return sort { ($seconds{$b} // 1e9) <=> ($seconds{$a} // 1e9) || $a cmp $b } @chosen;
}

sub folder_of {
    my ($path) = @_;
    return $path =~ s{/[^/]*$}{}r;
}

sub write_file {
    my ($path, @text) = @_;
    make_path(folder_of($path));
    open my $file, '>', $path or die "$path: $!\n";
    print $file @text;
    close $file or die "$path: $!\n";
}

sub read_file {
    my ($path) = @_;
    open my $file, '<', $path or return '';
    return join '', <$file>;
}

# Whether exec.sh did not run this test again.
sub is_kept {
    my ($name) = @_;
    return ($lines{$name}[0] // '') =~ /^# not run again: /;
}

# The seconds of processor time that each of these tests took, or one that is kept took when it was run: what the shell's `times`
# printed, of itself and then of its children. Nothing where none is told.
sub read_takes {
    my %takes;
    for my $name (@_) {
        my $line = read_file(is_kept($name) ? "$kept/$name/takes" : "$takes/$name");
        my $seconds = 0;
        $seconds += 60 * $1 + $2 while $line =~ /([0-9]+)m([0-9.]+)s/g;
        $takes{$name} = $seconds if $line;
    }
    return %takes;
}

sub write_takes {
    my (%of) = @_;
    write_file("$takes.txt",
        map { sprintf "%7.1f %s\n", $of{$_}, $_ } sort { $of{$b} <=> $of{$a} || $a cmp $b } keys %of);
}

# Keeps what a test printed and took, if it passed and was run; what is left of an earlier time goes.
sub keep {
    my ($name, $has_passed) = @_;
    return if !$kept || !$state || is_kept($name);
    unlink "$kept/$name/state";
    return if !$has_passed;
    write_file("$kept/$name/output", map { "$_\n" } @{ $lines{$name} });
    write_file("$kept/$name/takes", read_file("$takes/$name"));
    write_file("$kept/$name/state", "$state\n");
}

# How many tests exec.sh did not run again.
sub count_kept {
    return scalar grep { is_kept($_) } keys %lines;
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

sub runtests {
    my ($self, @tests) = @_;
    $self->callback(made_parser => \&listen_to);
    @tests = choose(@tests);
    make_path(map { folder_of("$takes/$_") } @tests) if $takes;
    my $aggregate = $self->SUPER::runtests(@tests);
    my %parsers;
    @parsers{ $aggregate->descriptions } = $aggregate->parsers($aggregate->descriptions);

    my @sum = (0, 0, 0);
    for my $name (sort keys %parsers) {
        my @one = count($parsers{$name});
        $sum[$_] += $one[$_] for 0 .. 2;
        show_failure($name, $parsers{$name}) if $one[1];
        keep($name, !$one[1]);
    }
    write_log();
    my @compared = compare_variants(\%parsers);
    $sum[0] += $compared[0];
    $sum[1] += $compared[1];
    if ($takes) {
        write_takes(read_takes(keys %parsers));
    }
    my ($again, $all) = (count_kept(), scalar keys %parsers);
    print "$again of $all tests were not run again: they passed, and nothing has changed since\n" if $again;
    print "$sum[0] passed, $sum[1] failed", $sum[2] ? ", $sum[2] skipped" : '', "\n";
    exit($sum[1] || !$sum[0] ? 1 : 0);
}

1;
