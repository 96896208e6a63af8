# Reads TAP from standard input with Perl's own parser; prints a line per test, "status number description", and what
# the YAML block says. Ends with 1 when the parser found fault with the form.
use strict;
use warnings;
use TAP::Parser;
binmode STDOUT, ':raw';
my $tap = do { local $/; <STDIN> };
$tap =~ s/\ATAP version 14\n/TAP version 13\n/ or die "no version line\n";    # older parsers stop at 13
my $parser = TAP::Parser->new({tap => $tap});
my $stray = 0;
while (my $result = $parser->next) {
    if ($result->is_test) {
        my $status = $result->has_todo ? 'todo' : $result->has_skip ? 'skip' : $result->is_ok ? 'ok' : 'not-ok';
        print "$status ", $result->number, " ", $result->description, "\n";
    } elsif ($result->is_yaml) {
        my $data = $result->data;
        print "  severity=$data->{severity} points=$data->{points} checks=", scalar @{$data->{checks} || []}, "\n";
        my $message = $data->{message} // '';
        $message =~ s/\n/\\n/g;
        print "  message=$message\n";
    } elsif ($result->is_unknown) {
        print "unknown: ", $result->raw, "\n";
        $stray = 1;
    }
}
my @errors = $parser->parse_errors;
print "error: $_\n" for @errors;
print "planned ", $parser->tests_planned, "\n";
exit(@errors || $stray ? 1 : 0);
