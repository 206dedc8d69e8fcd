# What all RISC-V toolchains share; included by rv32*.cmake, which sets EPF_CPU_FLAGS and EPF_CPU.
# Debian packages: gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf; to run, qemu-system-misc

set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(EPF_TRIPLE riscv64-unknown-elf)
set(EPF_QEMU qemu-system-riscv32 -M virt -cpu ${EPF_CPU} -bios none)
set(EPF_MEMORY 0x80000000 2M 0x80200000 2M)
include(${CMAKE_CURRENT_LIST_DIR}/picolibc.cmake)
