"""Faults of places, made for real and without a shim: full, read-only and missing folders, missing inputs,
closed and full standard streams."""
import shutil
import subprocess
from collections import Counter

from inputs import FILES
from scenario import arguments, files_of, fill

# Mounts live in a name space of the command's own, so that none is left behind.
PRIVATE = ["unshare", "--user", "--map-root-user", "--mount", "sh", "-c"]
ROOMS = ("4k", "8k", "16k", "32k", "64k")


def call(command, folder, **streams):
    given = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **streams}
    done = subprocess.run(command, cwd=folder, text=True, **given)
    return done.returncode, done.stderr or ""


def expect(wanted, text, found):
    code, stderr = found
    good = code == wanted and text in stderr
    return "" if good else f"exit {code}, wanted {wanted} with '{text}': {stderr[-300:].strip()}"


class Places:
    """Each check gives a complaint or nothing."""

    def __init__(self, twofold, work):
        self.work, self.out, self.copy = work, work / "place", work / "copy"
        fill(self.out, {})
        self.twofold = twofold
        self.good = self.good_files()

    def command(self, text, out=None):
        return [self.twofold, *arguments(text, self.work, out or self.out)]

    def good_files(self):
        fill(self.out, {})
        call(self.command("run IN/scene.json -o OUT -q"), self.work)
        return files_of(self.out)

    def mounted(self, options, command):
        """The command with a file system of its own in the output folder; what it left is copied out."""
        shutil.rmtree(self.copy, ignore_errors=True)
        script = (f"mount -t tmpfs -o {options} none '{self.out}' && \"$@\"; code=$?; "
                  f"cp -r '{self.out}' '{self.copy}'; exit $code")
        return call([*PRIVATE, script, "sh", *command], self.work)

    def can_mount(self):
        return self.mounted("size=4k", ["true"])[0] == 0

    def full(self, room):
        wrong = expect(4, "No space left", self.mounted(f"size={room}", self.command("run IN/scene.json -o OUT -q")))
        left = files_of(self.copy)
        torn = [n for n, data in left.items() if n not in self.good or not same(n, data, self.good[n])]
        return wrong or (f"torn or stray: {torn}" if torn else "")

    def read_only(self):
        return expect(4, str(self.out), self.mounted("ro", self.command("run IN/scene.json -o OUT -q")))

    def file_in_place(self):
        shutil.rmtree(self.out)
        self.out.write_text("in the way")
        found = [call(self.command(f"{c} -q"), self.work) for c in (
            "run IN/scene.json -o OUT", "run IN/scene.json -o OUT/below",
            "study IN/scene.json --study IN/study.json -o OUT", "render IN/scene.json -o OUT/a.png")]
        kept = self.out.read_text() == "in the way"
        self.out.unlink()
        wrongs = [w for w in (expect(4, str(self.out), f) for f in found) if w]
        return wrongs[0] if wrongs else "" if kept else "the file was replaced"

    def missing(self, name):
        """An input is gone; nothing is written."""
        fill(self.out, {})
        there, away = self.work / "in" / name, self.work / "away"
        there.rename(away)
        found = call(self.command("run IN/scene.json -o OUT/new -q"), self.work)
        away.rename(there)
        return expect(4, name, found) or ("something was written" if files_of(self.out) else "")

    def streams(self, redirection, wanted):
        """Standard streams by the shell's redirections."""
        fill(self.out, {})
        command = self.command("run IN/scene.json -o OUT")
        code, _ = call(["sh", "-c", f'exec "$@" {redirection}', "sh", *command], self.work)
        left = files_of(self.out)
        if code != wanted:
            return f"exit {code} with {redirection}, wanted {wanted}"
        return "" if left.keys() == self.good.keys() else f"other files with {redirection}"

    def error_without_streams(self, redirection):
        command = self.command("run IN/none.json -o OUT")
        code, _ = call(["sh", "-c", f'exec "$@" {redirection}', "sh", *command], self.work)
        return "" if code == 4 else f"exit {code} for a missing scene with {redirection}"


def same(name, data, good):
    """Reports hold times."""
    return data == good or name == "report.html" and data.rstrip().endswith(b"</html>")


def check_places(twofold, work):
    """Rows for the table, and complaints."""
    p = Places(twofold, work)
    kinds = {
        "an unwritable place: a file where a folder should be": [p.file_in_place],
        "a missing input": [lambda n=n: p.missing(n) for n in FILES],
        "standard streams full or closed": [
            lambda: p.streams("2>/dev/full", 0), lambda: p.streams("2>&-", 0),
            lambda: p.streams(">/dev/full", 4), lambda: p.streams(">&-", 4),
            lambda: p.streams(">&- 2>&- <&-", 4), lambda: p.error_without_streams("2>/dev/full"),
            lambda: p.error_without_streams("2>&-")],
    }
    if p.can_mount():
        kinds["a small tmpfs, full"] = [lambda r=r: p.full(r) for r in ROOMS]
        kinds["an unwritable place: mounted read-only"] = [p.read_only]
    else:
        print("SKIPPED: no file system can be mounted here: neither a full nor a read-only one is tested")
    rows, wrongs = [], []
    for kind, checks in kinds.items():
        found = [check() for check in checks]
        bad = [f"{kind}: {wrong}" for wrong in found if wrong]
        rows.append([kind, f"{len(checks)} of {len(checks)}", "run, study, render" if "file where" in kind else "run",
                     Counter({"as documented": len(checks) - len(bad), "failed": len(bad)})])
        wrongs += bad
    print(*wrongs, sep="\n")
    return rows, wrongs
