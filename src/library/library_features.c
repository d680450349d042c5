/* What this build has: optional parts, and the versions of its libraries. */
#include <gsl/gsl_version.h>
#include <zlib.h>
#ifdef TS_WITH_PNG
#include <png.h>
#endif
#ifdef TS_WITH_HDF5
#include <hdf5.h>
#endif

#include "base/process.h"
#include "library/library.h"

#include "base/banned.h"

#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)

typedef const char *feature_fn(void);

static const char *threads(void)
{
#ifdef _OPENMP
	return "OpenMP " TEXT(_OPENMP);
#else
	return "no";
#endif
}

/* base/clones.h: chosen when the program starts. */
static const char *vectors(void)
{
#if defined(__x86_64__) && defined(__GNUC__)
	return __builtin_cpu_supports("avx512f") ? "avx512f"
	       : __builtin_cpu_supports("avx2")	 ? "avx2"
						 : "sse2";
#else
	return "of the processor's architecture";
#endif
}

static const char *compiler(void)
{
#if defined(__clang__)
	return __VERSION__;
#elif defined(__GNUC__)
	return "gcc " __VERSION__;
#else
	return "unknown";
#endif
}

static const char *gsl(void)
{
	return gsl_version;
}

static const char *zlib(void)
{
	return zlibVersion();
}

static const char *png(void)
{
#ifdef TS_WITH_PNG
	return png_get_libpng_ver(NULL);
#else
	return "no";
#endif
}

static const char *hdf5(void)
{
#ifdef TS_WITH_HDF5
	return TEXT(H5_VERS_MAJOR) "." TEXT(H5_VERS_MINOR) "." TEXT(H5_VERS_RELEASE);
#else
	return "no";
#endif
}

static const char *hypre(void)
{
#ifdef TS_WITH_HYPRE
	return "yes";
#else
	return "no";
#endif
}

static const char *movies(void)
{
	struct ts_str path = { 0 };
	bool found = ts_process_find("ffmpeg", &path);

	ts_str_release(&path);
	return found ? "by ffmpeg" : "no";
}

static const struct {
	const char *name;
	feature_fn *text;
} features[] = {
	{ "compiler", compiler }, { "threads", threads }, { "vectors", vectors },
	{ "gsl", gsl },		  { "zlib", zlib },	  { "png", png },
	{ "hdf5", hdf5 },	  { "hypre", hypre },	  { "movies", movies },
};

const char *tsim_feature(size_t k, const char **text)
{
	if (k >= sizeof features / sizeof *features)
		return NULL;
	if (text)
		*text = features[k].text();
	return features[k].name;
}
