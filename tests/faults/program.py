"""The program under faults: loaded once, forked for every order (fail_nth.cpp)."""
import os
import signal
import subprocess
from dataclasses import dataclass

LAST = 2 ** 62


@dataclass(frozen=True)
class Order:
    """Which calls fail, or when the program is killed; without arguments none and never."""
    call: str = "allocate"
    first: int = 0
    last: int = LAST
    kill: bool = False
    microseconds: int = 0
    megabytes: int = 0

    def line(self):
        return (f"{self.call} {self.first} {self.last} {int(self.kill)} {self.microseconds} "
                f"{self.megabytes}\n")

    def kills(self):
        return self.kill or self.microseconds > 0


@dataclass(frozen=True)
class Answer:
    status: int
    microseconds: int
    counts: dict
    stdout: str
    stderr: str

    def signal(self):
        return os.WTERMSIG(self.status) if os.WIFSIGNALED(self.status) else 0

    def code(self):
        return os.WEXITSTATUS(self.status)


class Program:
    """A loaded program with its arguments. obey() runs it once."""

    def __init__(self, shim, command, folder):
        self.files = {name: folder / name for name in ("stdout", "stderr")}
        orders, self.orders = os.pipe()
        self.answers, answers = os.pipe()
        environment = {**os.environ, "LD_PRELOAD": str(shim), "LC_ALL": "C", "OMP_NUM_THREADS": "1",
                       "TWOFOLD_FAULT_SERVER": f"{orders},{answers}",
                       **{f"TWOFOLD_FAULT_{k.upper()}": str(v) for k, v in self.files.items()}}
        self.process = subprocess.Popen(command, env=environment, cwd=folder, pass_fds=(orders, answers),
                                        stdin=subprocess.DEVNULL)
        os.close(orders)
        os.close(answers)
        self.reader = os.fdopen(self.answers)

    def obey(self, order=Order()):
        os.write(self.orders, order.line().encode())
        status, microseconds, *counts = self.reader.readline().split()
        texts = [self.files[name].read_text(errors="replace") for name in ("stdout", "stderr")]
        counts = {name: int(n) for name, n in (pair.split("=") for pair in counts)}
        return Answer(int(status), int(microseconds), counts, *texts)

    def close(self):
        os.close(self.orders)
        self.process.wait()
        self.reader.close()
