#!/bin/sh
# Runs a test by itself, and what it prints.
exec pytest-3 "$@"
