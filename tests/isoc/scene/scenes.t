#!/bin/sh
# Bad scenes and bad command lines: what isoc says of each, and that it leaves its output alone.
exec perl tests/isoc/scene/cases.pl plain all build/tests/requests
