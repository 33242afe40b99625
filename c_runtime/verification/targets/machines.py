"""The processors, and how code for them is compiled and run here."""

import platform
from dataclasses import dataclass

from sailnet.guidance.interface import Precision


@dataclass(frozen=True)
class Target:
    """A processor with its compiler and its emulator.

    Attributes:
        name: on the command line and in file names.
        title: in the table.
        compiler: the gcc.
        machine: its options that say which processor it is.
        optimisation: its options that the table is for, with contraction of products and sums where the
            processor has an instruction for both.
        emulator: command that runs a program, whose path is appended.
        folder: of the start-up code.
        packages: of Debian, which bring compiler and emulator.
        precisions: that it computes in hardware, and the cycles an instruction is assumed to take on average.
        fuses: it has fused multiply-add.
        hosted: there is an operating system and a C library.
        retires: the processor counts its instructions itself.
        arithmetic: of doubles in software, by the compiler's library: patterns of its functions' names.
    """

    name: str
    title: str
    compiler: str
    machine: tuple[str, ...]
    optimisation: tuple[str, ...]
    emulator: tuple[str, ...]
    folder: str
    packages: tuple[str, ...]
    precisions: dict[Precision, float]
    fuses: bool = True
    hosted: bool = False
    retires: bool = False
    arithmetic: tuple[str, ...] = ()


SMALL = ("-Os", "-fno-schedule-insns", "-fno-schedule-insns2")
"""Scheduling makes gcc move constants further away than short instructions reach, and spill registers."""

ARM = ("gcc-arm-none-eabi", "qemu-system-arm")
BOARD = (
    "-display",
    "none",
    "-monitor",
    "none",
    "-serial",
    "stdio",
    "-semihosting-config",
    "enable=on",
    "-kernel",
)
"""Of ARM: a serial port, and a debugger by which a program can end the emulation."""

TARGETS = (
    Target(
        name="cortex-m4f",
        title="Cortex-M4F",
        compiler="arm-none-eabi-gcc",
        machine=("-mthumb", "-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"),
        optimisation=SMALL,
        emulator=("qemu-system-arm", "-M", "mps2-an386", *BOARD),
        folder="cortex_m",
        packages=ARM,
        precisions={"float32": 2.0},
        arithmetic=("__aeabi_d*", "__aeabi_f2d"),
    ),
    Target(
        name="cortex-m7",
        title="Cortex-M7",
        compiler="arm-none-eabi-gcc",
        machine=("-mthumb", "-mcpu=cortex-m7", "-mfloat-abi=hard", "-mfpu=fpv5-d16"),
        optimisation=SMALL,
        emulator=("qemu-system-arm", "-M", "mps2-an500", *BOARD),
        folder="cortex_m",
        packages=ARM,
        precisions={"float32": 1.0, "float64": 1.5},
    ),
    Target(
        name="leon3",
        title="LEON3",
        compiler="sparc64-linux-gnu-gcc",
        machine=("-m32", "-mcpu=leon3"),
        optimisation=("-Os", "-fno-schedule-insns"),
        emulator=("qemu-system-sparc", "-M", "leon3_generic", "-nographic", "-monitor", "none", "-kernel"),
        folder="leon3",
        packages=("gcc-sparc64-linux-gnu", "qemu-system-sparc"),
        precisions={"float32": 2.0, "float64": 2.0},
        fuses=False,
    ),
    Target(
        name="riscv32",
        title="RISC-V RV32IMAFDC",
        compiler="riscv64-unknown-elf-gcc",
        machine=("-march=rv32imafdc", "-mabi=ilp32d", "-mcmodel=medany"),
        optimisation=SMALL,
        emulator=(
            *("qemu-system-riscv32", "-M", "virt", "-bios", "none", "-icount", "shift=0"),
            *("-display", "none", "-serial", "stdio", "-monitor", "none", "-kernel"),
        ),
        folder="riscv",
        packages=("gcc-riscv64-unknown-elf", "qemu-system-misc"),
        precisions={"float32": 1.5, "float64": 1.5},
        retires=True,
    ),
    Target(
        name="powerpc750",
        title="PowerPC 750",
        compiler="powerpc-linux-gnu-gcc",
        machine=("-mcpu=750",),
        # -Os calls functions of libgcc that save registers.
        optimisation=("-O2",),
        emulator=("qemu-ppc", "-cpu", "750"),
        folder="hosted",
        packages=("gcc-powerpc-linux-gnu", "libc6-dev-powerpc-cross", "qemu-user"),
        precisions={"float32": 1.0, "float64": 1.5},
        hosted=True,
    ),
)

HOST = Target(
    name="host",
    title="host",
    compiler="gcc",
    # The stack is painted up to the stack pointer, which a leaf function of x86-64 would reach below.
    machine=("-mno-red-zone",) if platform.machine() == "x86_64" else (),
    optimisation=("-O2",),
    emulator=(),
    folder="hosted",
    packages=("gcc", "libc6-dev", "binutils"),
    precisions={"float32": 1.0, "float64": 1.0},
    hosted=True,
)
"""The arithmetic that others are compared with, bit for bit; it is emulated by nothing and counts nothing."""
