# Other ways to look for faults, each in a folder of its own below the build folder.
.PHONY: sanitize coverage analyze format

# configure_in FOLDER,OPTIONS: once; later calls build what has changed
configure_in = $(MKDIR_P) $(1) && cd $(1) && { test -f Makefile || CC='$(CC)' $(abs_top_srcdir)/configure -q $(2); }

# Address and undefined-behaviour sanitizers: the first fault ends the program with a status that no test expects. Tests of
# scenes that are too large for the memory need an allocation that fails.
sanitize:
	$(call configure_in,sanitize,--enable-sanitize CFLAGS='-O1 -g')
	cd sanitize && ASAN_OPTIONS=exitcode=99:allocator_may_return_null=1:$$ASAN_OPTIONS UBSAN_OPTIONS=print_stacktrace=1:$$UBSAN_OPTIONS \
		CK_TIMEOUT_MULTIPLIER=10 $(MAKE) $(AM_MAKEFLAGS) check

# Lines executed by the quick tests (or by TESTS), in each folder of src; gcovr, where installed, makes pages of all files.
coverage:
	$(call configure_in,coverage,--disable-shared CFLAGS='-O1 -g --coverage -fprofile-update=atomic' LDFLAGS=--coverage)
	find coverage -name '*.gcda' -exec rm -f {} +
	cd coverage && CK_TIMEOUT_MULTIPLIER=10 $(MAKE) $(AM_MAKEFLAGS) check
	python3 $(top_srcdir)/tests/coverage.py $(abs_top_srcdir) coverage
	if command -v gcovr >/dev/null; then \
		gcovr -r $(top_srcdir) --filter '.*/src/' --html-details coverage/index.html coverage; fi

# Static analysis: cppcheck, which keeps what it knows of each file in the folder analyze; without it gcc -fanalyzer, but
# for its two warnings that are mostly wrong about loops and arrays.
analyze_flags = -D_GNU_SOURCE -DPACKAGE_VERSION='""' -DPACKAGE_STRING='""' -DTS_POTENTIALS='""' -I$(top_srcdir)/src
analyze:
	@$(MKDIR_P) analyze
	@if command -v cppcheck >/dev/null; then \
		cppcheck -q --std=c11 --language=c --enable=warning,performance,portability --error-exitcode=1 \
			--suppressions-list=$(top_srcdir)/tests/analyze.suppress --cppcheck-build-dir=analyze \
			--template='{file}:{line}: {severity}: {message} [{id}]' $(analyze_flags) $(top_srcdir)/src; \
	else \
		status=0; \
		for file in `find $(top_srcdir)/src -name '*.c'`; do \
			$(CC) -std=gnu11 -O1 -fopenmp -fanalyzer -Wno-analyzer-null-dereference \
				-Wno-analyzer-use-of-uninitialized-value -Werror -c -o analyze/object.o \
				$(analyze_flags) $(GSL_CFLAGS) $(ZLIB_CFLAGS) $$file || status=1; \
		done; \
		exit $$status; \
	fi
	@echo 'make analyze: nothing found'

# Lays out all C files but the generated one as .clang-format says.
format:
	cd $(top_srcdir) && find src tests bench examples -name '*.[ch]' ! -path src/library/style_table.c \
		-exec sh src/build/format.sh {} +
