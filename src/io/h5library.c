#include "io/h5library.h"

#ifdef TS_WITH_HDF5
#include <stdio.h>
#ifdef TS_HDF5_FILE
#include <dlfcn.h>
#endif

#include "base/banned.h"

#ifdef TS_HDF5_FILE
/* The library stays loaded after dlclose, so that this costs only a search among the loaded ones. */
static void *look_up(const char *name)
{
	void *library = dlopen(TS_HDF5_FILE, RTLD_NOW | RTLD_NODELETE);
	void *found = library ? dlsym(library, name) : NULL;

	if (library)
		dlclose(library);
	return found;
}

ts_h5_fn *ts_h5_function(const char *name)
{
	union {
		void *object;
		ts_h5_fn *function;
	} symbol = { look_up(name) };

	return symbol.function;
}

const void *ts_h5_object(const char *name)
{
	return look_up(name);
}

bool ts_h5_loads(char *reason, size_t size)
{
	const char *why;

	dlerror();
	if (look_up("H5open"))
		return true;
	why = dlerror();
	snprintf(reason, size, "%s", why ? why : "it is another library");
	return false;
}
#else
bool ts_h5_loads(char *reason, size_t size)
{
	snprintf(reason, size, "%s", "");
	return true;
}
#endif
#else
#include "base/banned.h"
#endif
