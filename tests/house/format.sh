#!/bin/bash
# All C files are laid out as .clang-format says, by the clang-format of Debian 12: other versions differ in details.
command -v clang-format >/dev/null || { echo 'skipped: needs clang-format 14 (apt-get install clang-format)'; exit 77; }
clang-format --version | grep -q 'version 14\.' || { echo 'skipped: needs clang-format 14'; exit 77; }
cd "${top_srcdir:-$(dirname "$0")/../..}" || exit 99
find src tests bench examples -name '*.[ch]' ! -path src/library/style_table.c -print0 |
	xargs -0 -P 2 -n 50 clang-format --dry-run -Werror --ferror-limit=1 2>&1 |
	grep error: && { echo 'lay them out with: clang-format -i FILE'; exit 1; }
exit 0
