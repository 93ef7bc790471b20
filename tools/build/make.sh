#!/bin/sh
exec make -f tools/build/old.mk "$@"
