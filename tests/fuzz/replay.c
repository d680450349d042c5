/* For compilers without libFuzzer: tries each file given, and each file of each folder given. */
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "sandbox.h"

static long tried;

static void try_file(const char *path)
{
	FILE *file = sandbox_open(path, "rb");
	uint8_t *bytes = NULL;
	size_t n = 0, room = 0, got = 1;

	while (file && got) {
		if (n == room) {
			room = room ? 2 * room : 4096;
			bytes = realloc(bytes, room);
			if (!bytes)
				abort();
		}
		got = fread(bytes + n, 1, room - n, file);
		n += got;
	}
	if (!file) {
		perror(path);
		exit(EXIT_FAILURE);
	}
	fclose(file);
	if (getenv("FUZZ_VERBOSE"))
		fprintf(stderr, "%s\n", path);
	LLVMFuzzerTestOneInput(bytes, n);
	free(bytes);
	tried++;
}

static void try(const char *path)
{
	struct stat info;
	DIR *folder;
	struct dirent *entry;
	char name[4096];

	if (stat(path, &info) != 0 || !S_ISDIR(info.st_mode)) {
		try_file(path);
		return;
	}
	folder = opendir(path);
	while (folder && (entry = readdir(folder))) {
		if (entry->d_name[0] == '.')
			continue;
		snprintf(name, sizeof name, "%s/%s", path, entry->d_name);
		try(name);
	}
	if (folder)
		closedir(folder);
}

int main(int argc, char **argv)
{
	LLVMFuzzerInitialize(&argc, &argv);
	for (int k = 1; k < argc; k++)
		try(argv[k]);
	printf("%ld inputs\n", tried);
	return EXIT_SUCCESS;
}
