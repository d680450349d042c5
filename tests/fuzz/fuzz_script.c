/* Any bytes as a script. */
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
	fuzz_as_script(data, size, FUZZ_RUN);
	return 0;
}
