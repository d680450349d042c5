/* Any bytes as a script. "#explain" at the start: planned only. */
#include <string.h>

#include "sandbox.h"
#include "scripts.h"

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
	(void)argc;
	(void)argv;
	return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	static const char explain[] = "#explain";
	bool planned = size > strlen(explain) && memcmp(data, explain, strlen(explain)) == 0;

	fuzz_as_script(data, size, planned ? FUZZ_EXPLAIN : FUZZ_RUN);
	return 0;
}
