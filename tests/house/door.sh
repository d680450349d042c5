#!/bin/sh
# All paths go through one door, base/files.c, which -sandbox closes: nobody else opens, looks at, moves or removes a
# file, makes a folder, or reads the environment.
cd "$top_srcdir/src" || exit 1
status=0

# Elsewhere only -crosscheck, -advise and ranks, which -sandbox refuses, the sandbox itself, io/replace.c in a folder
# that the door has opened, and io/h5library.c and program/program_mpi.c, which load libraries of the system and are not used
# in the sandbox.
calls='fopen|freopen|open|openat|openat2|creat|gzopen|gzopen64|opendir|scandir|nftw|ftw|glob|wordexp|mkdir|mkdirat'
calls="$calls|mkdtemp|mkstemp|tmpfile|rename|renameat|unlink|unlinkat|remove|rmdir|chdir|fchdir|stat|lstat|fstatat|statx"
calls="$calls|access|faccessat|statvfs|realpath|readlink|symlink|link|truncate|chmod|chown|utimensat|mkfifo|mknod|dlopen"
found=$(grep -rnE "(^|[^_a-zA-Z.>])($calls)\(" --include='*.[ch]' . |
	grep -vE '^\./(base/(files|files_peers|sandbox|process)\.[ch]|crosscheck/(folder|inputs)\.c|advise/advise\.c|program/program_(sandbox|mpi)\.c|io/(replace|h5library)\.c):' |
	grep -vE '^[^:]*:[0-9]+:[[:space:]]*(/\*|\*)')
if [ -n "$found" ]; then
	echo 'files are opened through base/files.h alone:'
	echo "$found"
	status=1
fi

calls='system|popen|fork|vfork|execvp|execv|execl|execlp|execve|posix_spawn|posix_spawnp|socket|connect'
found=$(grep -rnE "(^|[^_a-zA-Z.>])($calls)\(" --include='*.[ch]' . |
	grep -vE '^\./(base/process\.c|script/shell\.c|explain/price\.c|advise/(advise|trial)\.c):')
if [ -n "$found" ]; then
	echo 'processes are started by base/process.c, shell, -explain and -advise alone:'
	echo "$found"
	status=1
fi

found=$(grep -rnE "(^|[^_a-zA-Z.>])(getenv|secure_getenv|setenv|putenv|unsetenv|clearenv)\(" --include='*.[ch]' . |
	grep -vE '^\./(base/process\.c|core/(life|coeff)\.c|crosscheck/folder\.c|advise/advise\.c|program/program_(options|plot|ranks|sandbox)\.c|base/input_limit\.c|script/shell\.c|formula/variable_text\.c):')
if [ -n "$found" ]; then
	echo 'who reads the environment must do without it in -sandbox:'
	echo "$found"
	status=1
fi
exit $status
