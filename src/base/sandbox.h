/* Restrictions that the kernel enforces on this process and its children, for -sandbox. They cannot be
 * lifted. */
#ifndef TS_BASE_SANDBOX_H
#define TS_BASE_SANDBOX_H

#include <stdbool.h>

#include "base/files.h"

struct ts_sandbox_limits {
	double memory;	/* address space, bytes */
	double seconds; /* processor time; SIGXCPU, then SIGKILL */
	double bytes;	/* size of a file, bytes */
};

int ts_sandbox_limit(const struct ts_sandbox_limits *limits); /* 0, or -1 and errno */

/* Landlock: allows file access only below the roots of `files`, and to /dev/null. Returns its version,
 * or 0 if the kernel does not support it. */
int ts_sandbox_paths(const struct ts_files *files);
/* seccomp: forbids other programs, sockets, links, devices and changes of permissions. `copies`: the
 * process may fork, as -explain does. False: not supported by the kernel or the processor. */
bool ts_sandbox_calls(bool copies);

#endif
