"""The faults of a scenario, by kind, each kind in a random order that is the same in every run."""
import random

from program import LAST, Order

FILE_CALLS = ("open", "read", "write", "fsync", "close", "rename", "unlink", "mkdir", "stat", "readdir")
KILLS = 1000  # some of them come when the run has ended
FULL_DISKS = 200
MEMORY_STEPS = 200


def one_call(call, count):
    """Each call fails alone."""
    return [Order(call, n, n) for n in range(1, count + 1)]


def from_call_on(call, count):
    """Each call and all that follow fail."""
    return [Order(call, n, LAST) for n in range(1, count + 1)]


def file_calls(counts, make):
    return [order for call in FILE_CALLS for order in make(call, counts[call])]


def killed_before(call, count):
    return [Order(call, n, n, kill=True) for n in range(1, count + 1)]


def full_disks(dice, count):
    """Disks with room for some bytes; all of them where there are few."""
    rooms = range(1, count + 1)
    return [Order("disk", n) for n in dice.sample(rooms, min(FULL_DISKS, count))]


def random_moments(dice, microseconds):
    return [Order(microseconds=dice.randint(1, microseconds)) for _ in range(KILLS)]


def little_memory():
    """Address space for so many MiB more: real failures of the system's own calls."""
    return [Order(megabytes=n) for n in range(1, MEMORY_STEPS + 1)]


def faults_of(scenario):
    """Lists of orders by the kind's name."""
    dice = random.Random(1)
    counts, taken = scenario.good.counts, scenario.good.microseconds
    if "threads" in scenario.name:
        kinds = {"one allocation on two threads": one_call("allocate", counts["allocate"]),
                 "a thread that cannot be started": one_call("thread", counts["thread"]),
                 "all threads from one on": from_call_on("thread", counts["thread"]),
                 "little address space": little_memory()}
    else:
        kinds = {"one allocation": one_call("allocate", counts["allocate"]),
                 "all allocations from one on": from_call_on("allocate", counts["allocate"]),
                 "one call on files": file_calls(counts, one_call),
                 "all calls on files from one on": file_calls(counts, from_call_on),
                 "a full disk": full_disks(dice, counts["disk"]),
                 "killed before a call on files": file_calls(counts, killed_before),
                 "killed at a random moment": random_moments(dice, taken)}
    for orders in kinds.values():
        dice.shuffle(orders)
    return kinds
