# The harness that `prove` runs the tests with: writes all they print to build/tests/log, shows what failed, compares the
# numbers of tests between the variants of the unit tests, and ends with one line "N passed, N failed".
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
    my $aggregate = $self->SUPER::runtests(@tests);
    my %parsers;
    @parsers{ $aggregate->descriptions } = $aggregate->parsers($aggregate->descriptions);

    my @sum = (0, 0, 0);
    for my $name (sort keys %parsers) {
        my @one = count($parsers{$name});
        $sum[$_] += $one[$_] for 0 .. 2;
        show_failure($name, $parsers{$name}) if $one[1];
    }
    write_log();
    my @compared = compare_variants(\%parsers);
    $sum[0] += $compared[0];
    $sum[1] += $compared[1];
    print "$sum[0] passed, $sum[1] failed", $sum[2] ? ", $sum[2] skipped" : '', "\n";
    exit($sum[1] || !$sum[0] ? 1 : 0);
}

1;
