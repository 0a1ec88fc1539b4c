"""A command under faults: how it is called, what it has to leave behind, and what is wrong with what it left."""
import re
import shutil
import signal
import subprocess
from pathlib import Path

from program import Order, Program

TEMPORARY = re.compile(r"(.*/)?\.[^/]+\.twofold-\d+\.tmp")
# What glibc says when it ends a process that has no memory for a thread's own data.
GLIBC = re.compile(r"Fatal glibc error: failed to register TLS destructor: out of memory")
# OpenEXR takes some failed allocations for damaged data, a stream of the standard library for a bad file.
CODEC = re.compile(r"^twofold: (openexr|png|[^ ]*\.(png|hdr|json)): ", re.MULTILINE)
# Name: arguments, where IN, OUT and MADE stand for folders of inputs, outputs and earlier results.
COMMANDS = {
    "run": "run IN/scene.json -o OUT -j 1 -q",
    "factor": "factor IN/scene.json -o OUT -j 1 -q",
    "render png": "render IN/scene.json -o OUT/picture.png -j 1 -q",
    "render exr": "render IN/scene.json -o OUT/picture.exr -j 1 -q",
    "compare": "compare MADE/run/nv17.png MADE/run/nv17.png --diff OUT/diff.png -q",
    "study": "study IN/scene.json --study IN/study.json -o OUT -j 1 -q",
    "merge": "study IN/scene.json --study IN/study.json -o OUT -j 1 -q --merge MADE/part1 MADE/part2",
    "run on 2 threads": "run IN/scene.json -o OUT -j 2 -q",
}
# Earlier results: what compare and merge read.
MADE = {
    "run": "run IN/scene.json -o MADE/run -q",
    "part1": "study IN/scene.json --study IN/study.json -o MADE/part1 -q --shard 1/2",
    "part2": "study IN/scene.json --study IN/study.json -o MADE/part2 -q --shard 2/2",
}


def arguments(text, work, out):
    named = {"IN": work / "in", "OUT": out, "MADE": work / "made"}
    return [re.sub(r"^(IN|OUT|MADE)\b", lambda m: str(named[m[1]]), word) for word in text.split()]


def files_of(folder):
    """Contents by name."""
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def fill(folder, files):
    """The folder with these files and no others."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name, data in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)


class Scenario:
    """A loaded program, its output folder, and what a run without a fault leaves there."""

    def __init__(self, name, twofold, shim, work, number):
        self.name = name
        self.folder = work / f"{name.replace(' ', '-')}-{number}"
        self.out = self.folder / "out"
        command = [twofold, *arguments(COMMANDS[name], work, self.out)]
        self.old = self.old_files(command)
        self.program = Program(shim, command, self.folder)
        self.good = self.whole_run()
        self.files = files_of(self.out)
        first, self.good = self.good, self.whole_run()
        if (first.stdout, self.files) != (self.good.stdout, files_of(self.out)):
            raise SystemExit(f"{name}: two runs without a fault differ: {self.good.stderr}")

    def old_files(self, command):
        """What stands in the folder before a run: another scene's results, some with the same names."""
        fill(self.out, {})
        other = [] if command[1] == "compare" else ["-D", "white=0.5"]
        if "--merge" not in command:
            subprocess.run([*command, *other], capture_output=True, cwd=self.folder)
        return files_of(self.out)

    def whole_run(self):
        fill(self.out, {})
        answer = self.program.obey()
        if answer.signal() or answer.code() > 1:
            raise SystemExit(f"{self.name}: fails without a fault: {answer}")
        return answer

    def check(self, order, rerun):
        """(what came of it, what is wrong with that or nothing)."""
        before = self.old if order.first % 2 == 0 else {}
        fill(self.out, before)
        answer = self.program.obey(order)
        came, wrong = self.judged(order, answer, before)
        if not wrong and (rerun or order.call not in ("allocate", "thread")):
            wrong = self.rerun(before)
        return came, wrong and f"{self.name}, {order}: {wrong}: {answer.stderr[-300:].strip()}"

    def judged(self, order, answer, before):
        left = files_of(self.out)
        torn = self.torn(left, before)
        if torn:
            return "torn", torn
        if answer.signal() == signal.SIGKILL and order.kills():
            return "killed", ""
        if answer.signal() == signal.SIGABRT and GLIBC.match(answer.stderr):
            return "ended by glibc", ""
        if answer.signal():
            return "died", f"signal {answer.signal()}"
        if any(TEMPORARY.fullmatch(name) for name in left):
            return "stray", f"a temporary file is left: {sorted(set(left) - set(self.files))}"
        if answer.code() == self.good.code():
            whole = left == {**before, **self.files} and answer.stdout == self.good.stdout
            return ("completed", "") if whole else ("silent", "success without all results")
        return self.complaint(order, answer)

    def torn(self, left, before):
        for name, data in left.items():
            if data not in (self.files.get(name), before.get(name)) and not TEMPORARY.fullmatch(name):
                return f"{name} is neither the old file nor the new one"
        return ""

    def complaint(self, order, answer):
        """Out of memory is a failure, 2; what a file's calls say is 4 and names the file."""
        text = answer.stderr
        if order.call == "allocate" and answer.code() == 4 and CODEC.search(text):
            return "a library's error", ""
        if order.call == "allocate":
            fits = ((answer.code(), "out of memory" in text) == (2, True)
                    or (answer.code(), "Cannot allocate memory" in text) == (4, True))
        elif order.call == "thread":
            fits = answer.code() in (2, 4) and text.startswith("twofold: ")
        else:
            fits = answer.code() == 4 and str(self.folder.parent) in text
        return "error", "" if fits else f"exit {answer.code()} with this message"

    def rerun(self, before):
        answer = self.program.obey()
        if answer.signal() or answer.code() != self.good.code():
            return f"the rerun ends with {answer.status}: {answer.stderr[-300:]}"
        found, wanted = files_of(self.out), {**before, **self.files}
        different = sorted(n for n in {*found, *wanted} if found.get(n) != wanted.get(n))
        return f"the rerun leaves other files: {different}" if different else ""

    def close(self):
        self.program.close()


def make_earlier_results(twofold, work):
    for text in MADE.values():
        done = subprocess.run([twofold, *arguments(text, work, Path())], capture_output=True, text=True)
        if done.returncode > 1:
            raise SystemExit(f"{text}: {done.stderr}")
