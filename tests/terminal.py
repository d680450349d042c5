"""Runs a program on a terminal: terminal.py COLUMNS interrupt|wait PROGRAM ARGUMENTS. Prints what it has written there;
with `interrupt` the first per cent sign is answered by Ctrl-C. The exit status is that of the program."""
import fcntl
import os
import pty
import struct
import sys
import termios

columns, interrupt, command = int(sys.argv[1]), sys.argv[2] == "interrupt", sys.argv[3:]
process, terminal = pty.fork()
if process == 0:
    fcntl.ioctl(1, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    os.execv(command[0], command)
written = b""
while True:
    try:
        piece = os.read(terminal, 65536)
    except OSError:  # the program has closed the terminal
        break
    if not piece:
        break
    written += piece
    if interrupt and b"%" in piece:
        os.write(terminal, b"\x03")
        interrupt = False
sys.stdout.buffer.write(written)
sys.exit(os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]) % 256)
