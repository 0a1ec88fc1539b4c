"""The platforms of the matrix: how each is compiled and run."""
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Platform:
    name: str
    processor: str
    compiler: str
    flags: str
    runner: tuple = ()        # what stands before the program
    cmake: tuple = ()         # further definitions
    threads: tuple = (1, 2, 7)


def native(name, compiler, flags):
    return Platform(name, "x86-64", compiler, flags)


def cross(processor, triple, emulator, flags="-O1", system_processor=None):
    return Platform(
        processor, processor, f"{triple}-g++", flags, (emulator,) if emulator else (),
        ("-DCMAKE_SYSTEM_NAME=Linux", f"-DCMAKE_SYSTEM_PROCESSOR={system_processor or processor}",
         "-DCMAKE_EXE_LINKER_FLAGS=-static"))


def wasm(name, flags):
    return Platform(
        name, "wasm32", "clang++", f"{flags} -fignore-exceptions",
        ("node", "--no-warnings", "tests/platforms/wasi.mjs"),
        ("-DCMAKE_SYSTEM_NAME=Generic", "-DCMAKE_SYSTEM_PROCESSOR=wasm32",
         "-DCMAKE_CXX_COMPILER_TARGET=wasm32-wasi", "-DCMAKE_CXX_COMPILER_WORKS=TRUE",
         "-DCMAKE_EXE_LINKER_FLAGS=-Wl,-z,stack-size=8388608"), (1,))


# Those that differ most from each other come first: what a run with little time should see.
PLATFORMS = [
    cross("s390x", "s390x-linux-gnu", "qemu-s390x-static"),
    cross("i686", "i686-linux-gnu", None),
    wasm("wasm-simd", "-O1 -msimd128"),
    native("clang-libc++", "clang++", "-O1 -stdlib=libc++"),
    cross("aarch64", "aarch64-linux-gnu", "qemu-aarch64-static", "-O2"),
    native("gcc-lto", "g++", "-O2 -flto=2"),
    cross("riscv64", "riscv64-linux-gnu", "qemu-riscv64-static"),
    cross("ppc64le", "powerpc64le-linux-gnu", "qemu-ppc64le-static"),
    cross("armhf", "arm-linux-gnueabihf", "qemu-arm-static", system_processor="armv7l"),
    cross("mips64el", "mips64el-linux-gnuabi64", "qemu-mips64el-static"),
    wasm("wasm-scalar", "-O1"),
    native("gcc-O0", "g++", "-O0"),
    native("gcc-O2", "g++", "-O2"),
    native("gcc-O3-native", "g++", "-O3 -march=native"),
    native("clang-O0", "clang++", "-O0"),
    native("clang-O2", "clang++", "-O2"),
    native("clang-O3-native", "clang++", "-O3 -march=native"),
]


def build(platform):
    """The program, or the end of what its build said."""
    folder = ROOT / "build/platforms" / platform.name
    configure = ["cmake", "-S", ROOT / "tests/platforms", "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
                 f"-DCMAKE_CXX_COMPILER={platform.compiler}", f"-DCMAKE_CXX_FLAGS={platform.flags}",
                 *platform.cmake]
    compile_all = ["cmake", "--build", folder, "--target", "platform_hashes",
                   "--parallel", str(os.cpu_count())]
    for command in (configure, compile_all):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            return None, done.stdout[-4000:]
    return folder / "platform_hashes", ""
