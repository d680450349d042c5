#include "base/sandbox.h"

#include <errno.h>
#include <fcntl.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/resource.h>
#include <unistd.h>

#ifdef __linux__
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#include "base/banned.h"

enum { GRACE = 10 }; /* processor time to save the state, s */

static int set_limit(int what, double soft, double more)
{
	struct rlimit r;

	if (getrlimit(what, &r) != 0)
		return -1;
	if (r.rlim_max == RLIM_INFINITY || (double)r.rlim_max > soft + more)
		r.rlim_max = (rlim_t)(soft + more);
	r.rlim_cur = (double)r.rlim_max < soft ? r.rlim_max : (rlim_t)soft;
	return setrlimit(what, &r);
}

int ts_sandbox_limit(const struct ts_sandbox_limits *limits)
{
	bool bad = set_limit(RLIMIT_AS, limits->memory, 0) != 0;

	bad |= set_limit(RLIMIT_CPU, limits->seconds, GRACE) != 0;
	bad |= set_limit(RLIMIT_FSIZE, limits->bytes, 0) != 0;
	bad |= set_limit(RLIMIT_CORE, 0, 0) != 0;
	return bad ? -1 : 0;
}

#ifdef __linux__

/* ---- Landlock: the kernel interface, which many headers lack. The system call numbers are the same
 * for all processors. */

enum { CREATE_RULESET = 444, ADD_RULE = 445, RESTRICT_SELF = 446 };
enum { ASK_VERSION = 1, PATH_BENEATH = 1 };

#define RIGHT(bit) ((uint64_t)1 << (bit))
#define FILES_WRITE RIGHT(1)
#define FILES_READ RIGHT(2)
#define FOLDERS_READ RIGHT(3)
/* remove folders and files, create folders and files; from version 2 on move between folders, from 3 on
 * truncate */
#define CHANGES (FILES_WRITE | RIGHT(4) | RIGHT(5) | RIGHT(7) | RIGHT(8) | RIGHT(13) | RIGHT(14))

struct ruleset {
	uint64_t files, network, scopes;
};

struct beneath {
	uint64_t allowed;
	int32_t folder;
} __attribute__((packed));

/* All rights that this version can restrict. */
static struct ruleset all_rights(long version)
{
	static const int bits[] = { 0, 13, 14, 15, 15, 16 }; /* highest bit of file rights, by version */
	struct ruleset r = { 0 };

	r.files = RIGHT(version < 6 ? bits[version] : 16) - 1;
	r.network = version >= 4 ? 3 : 0;
	r.scopes = version >= 6 ? 3 : 0;
	return r;
}

static long add_rule(int rules, int folder, uint64_t rights)
{
	struct beneath rule = { rights, folder };

	return syscall(ADD_RULE, rules, PATH_BENEATH, &rule, 0);
}

static bool add_rules(const struct ts_files *files, int rules, const struct ruleset *all)
{
	int null = open("/dev/null", O_PATH | O_CLOEXEC);
	bool good = null >= 0 && add_rule(rules, null, FILES_WRITE | FILES_READ) == 0;

	for (int k = 0; good && k < files->n; k++) {
		const struct ts_files_root *root = &files->root[k];

		good = add_rule(rules, root->folder,
				(FILES_READ | FOLDERS_READ | (root->writes ? CHANGES : 0)) & all->files) == 0;
	}
	if (null >= 0)
		close(null);
	return good;
}

int ts_sandbox_paths(const struct ts_files *files)
{
	long version = syscall(CREATE_RULESET, NULL, 0, ASK_VERSION);
	struct ruleset all;
	size_t size;
	bool good;
	int rules;

	if (version < 1)
		return 0;
	all = all_rights(version);
	size = version >= 6   ? sizeof all
	       : version >= 4 ? offsetof(struct ruleset, scopes)
			      : offsetof(struct ruleset, network);
	rules = (int)syscall(CREATE_RULESET, &all, size, 0);
	if (rules < 0)
		return 0;
	good = add_rules(files, rules, &all) && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
	       syscall(RESTRICT_SELF, rules, 0) == 0;
	close(rules);
	return good ? (int)version : 0;
}

/* ---- seccomp */

#if defined __x86_64__
#define MACHINE AUDIT_ARCH_X86_64
#elif defined __aarch64__
#define MACHINE AUDIT_ARCH_AARCH64
#endif

#ifdef MACHINE

#define LOAD(field) BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, field))
#define ANSWER(value) BPF_STMT(BPF_RET | BPF_K, value)
#define DENIED (SECCOMP_RET_ERRNO | EPERM)

static const int denied[] = {
	__NR_execve,
	__NR_execveat,
	__NR_socket,
	__NR_socketpair,
	__NR_ptrace,
	__NR_process_vm_readv,
	__NR_process_vm_writev,
	__NR_mount,
	__NR_umount2,
	__NR_pivot_root,
	__NR_chroot,
	__NR_unshare,
	__NR_setns,
	__NR_bpf,
	__NR_perf_event_open,
	__NR_keyctl,
	__NR_add_key,
	__NR_request_key,
	__NR_init_module,
	__NR_finit_module,
	__NR_delete_module,
	__NR_kexec_load,
	__NR_reboot,
	__NR_userfaultfd,
	__NR_open_by_handle_at,
	__NR_symlinkat,
	__NR_linkat,
	__NR_mknodat,
	__NR_fchmod,
	__NR_fchmodat,
	__NR_fchown,
	__NR_fchownat,
	__NR_setxattr,
	__NR_lsetxattr,
	__NR_fsetxattr,
	__NR_utimensat,
	__NR_truncate,
	425 /* io_uring_setup */,
#ifdef __x86_64__
	__NR_symlink,
	__NR_link,
	__NR_mknod,
	__NR_chmod,
	__NR_chown,
	__NR_lchown,
	__NR_utime,
	__NR_utimes,
	__NR_vfork,
#endif
};
enum { NDENIED = sizeof denied / sizeof *denied };

/* A fork is a clone without CLONE_VM. The arguments of clone3 cannot be inspected, so it fails with
 * ENOSYS and libraries fall back to clone. */
static unsigned short add_clones(struct sock_filter *f, bool copies)
{
	const struct sock_filter rules[] = {
		BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 435 /* clone3 */, 0, 1),
		ANSWER(SECCOMP_RET_ERRNO | ENOSYS),
		BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_clone, 0, 3),
		LOAD(args[0]),
		BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, CLONE_VM, 1, 0),
		ANSWER(DENIED),
		ANSWER(SECCOMP_RET_ALLOW),
	};
	unsigned short n = sizeof rules / sizeof *rules;

	if (copies)
		return 0;
	for (unsigned short k = 0; k < n; k++)
		f[k] = rules[k];
	return n;
}

bool ts_sandbox_calls(bool copies)
{
	struct sock_filter f[2 * NDENIED + 20] = {
		LOAD(arch),
		BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, MACHINE, 1, 0),
		ANSWER(DENIED),
		LOAD(nr),
#ifdef __x86_64__
		/* system call numbers of x32 */
		BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, 0x40000000, 0, 1),
		ANSWER(DENIED),
#endif
	};
	struct sock_fprog program = { .filter = f };
	unsigned short n = 4;

#ifdef __x86_64__
	n += 2;
	if (!copies) {
		f[n++] = (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_fork, 0, 1);
		f[n++] = (struct sock_filter)ANSWER(DENIED);
	}
#endif
	for (int k = 0; k < NDENIED; k++) {
		f[n++] = (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)denied[k], 0, 1);
		f[n++] = (struct sock_filter)ANSWER(DENIED);
	}
	n = (unsigned short)(n + add_clones(f + n, copies));
	f[n++] = (struct sock_filter)ANSWER(SECCOMP_RET_ALLOW);
	program.len = n;
	return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
	       prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0;
}

#else

bool ts_sandbox_calls(bool copies)
{
	(void)copies;
	return false;
}

#endif

#else

int ts_sandbox_paths(const struct ts_files *files)
{
	(void)files;
	return 0;
}

bool ts_sandbox_calls(bool copies)
{
	(void)copies;
	return false;
}

#endif
