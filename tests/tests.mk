# The tests: included by the Makefile. pytest runs all that tests/ has (tests/README.md); the programs of the unit tests
# are made first (tests/units.mk). Compilers are found behind ccache, so that a source that many tests compile, in
# whatever folder, is compiled once. It looks at the preprocessed text each time: a test may plant a header before
# another.
TEST_JOBS := $(shell echo $$(($$(nproc 2>/dev/null || echo 1) + 1)))
# make test WHOLE=yes tries what by turns is tried a part of.
WHOLE =
TEST_ENVIRONMENT = $(if $(WHOLE),TEST_WHOLE=yes) TEST_BUILT=yes PYTHONUNBUFFERED= PATH="/usr/lib/ccache:$$PATH" CCACHE_DIR="$(CURDIR)/build/tests/ccache" CCACHE_NOHASHDIR=yes CCACHE_NODIRECT=yes
TEST_RUN = $(TEST_ENVIRONMENT) pytest-3 --keep -n $(TEST_JOBS) --dist loadgroup tests

.PHONY: test check test-times

test: ## run all tests, but for those that passed before and follow from nothing that has changed; WHOLE=yes: all turns
	@tests/tools.sh
	+@$(TEST_ENVIRONMENT) $(MAKE) -s $(TOOLS) build/tests/requests build/simavr_trace build/regions.tsv build/rp2040js
	+@for variant in plain asan m4f; do for real in float double; do $(TEST_ENVIRONMENT) \
	    $(MAKE) -s -f tests/units.mk VARIANT=$$variant REAL=$$real || exit; done; done
	@$(TEST_RUN)

check: ## run the fast tests
	@tests/tools.sh
	+@$(TEST_ENVIRONMENT) $(MAKE) -s $(TOOLS) build/tests/requests build/simavr_trace build/regions.tsv build/rp2040js
	+@for variant in plain m4f; do $(TEST_ENVIRONMENT) \
	    $(MAKE) -s -f tests/units.mk VARIANT=$$variant REAL=float || exit; done
	@$(TEST_RUN) --quick

test-times: ## print the processor time of each test of the last make test; tests/times keeps it
	@cat build/tests/takes.txt

# isoc for tests that call it often: its objects, with another main.
build/tests/requests: tests/host/requests.c $(OBJECTS_isoc) $(TOOL_OBJ)/tools/flags
	@mkdir -p $(@D)
	@$(TOOL_COMPILE) -g1 $< $(filter-out %/isoc/main.o,$(filter %.o,$^)) -lm -o $@
