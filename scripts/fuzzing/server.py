"""springfit, loaded once and run in a child of its own for each case."""
import os
import select
import signal
import subprocess
import time

ENVIRONMENT = {"OMP_NUM_THREADS": "1"}


class Server:
    def __init__(self, program):
        self._process = subprocess.Popen([str(program)], stdin=subprocess.PIPE,
                                         stdout=subprocess.PIPE, bufsize=0,
                                         env={**os.environ, **ENVIRONMENT})

    def run(self, folder, arguments, seconds):
        """The status as subprocess has it, None when it took longer; seconds."""
        begin = time.monotonic()
        words = [os.fsencode(word) for word in (str(folder), *arguments)]
        self._process.stdin.write(b"%d\n" % len(words) + b"".join(
            b"%d %s\n" % (len(word), word) for word in words))
        child = int(self._process.stdout.readline())
        in_time = select.select([self._process.stdout], [], [], seconds)[0]
        if not in_time:
            os.killpg(child, signal.SIGKILL)
        status = os.waitstatus_to_exitcode(int(self._process.stdout.readline()))
        return status if in_time else None, time.monotonic() - begin

    def close(self):
        self._process.stdin.close()
        self._process.wait()
