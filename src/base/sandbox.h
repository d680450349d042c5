/* What the kernel is asked to hold back from this process and all that it starts, for -sandbox. None of it
 * can be taken back. */
#ifndef TS_BASE_SANDBOX_H
#define TS_BASE_SANDBOX_H

#include <stdbool.h>

#include "base/files.h"

struct ts_sandbox_limits {
	double memory;	/* bytes of address space */
	double seconds; /* of processor time; SIGXCPU, then SIGKILL */
	double bytes;	/* of one file */
};

int ts_sandbox_limit(const struct ts_sandbox_limits *limits); /* 0, or -1 and errno */

/* Files as the roots of the door say (Landlock), /dev/null; its version, or 0 where the kernel has none. */
int ts_sandbox_paths(const struct ts_files *files);
/* No other programs, sockets, links, devices, changes of rights (seccomp). `copies`: the process may copy
 * itself, as -explain does. False: the kernel has none, or not for this processor. */
bool ts_sandbox_calls(bool copies);

#endif
