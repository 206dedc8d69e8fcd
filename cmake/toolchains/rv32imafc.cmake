set(EPF_CPU_FLAGS "-march=rv32imafc -mabi=ilp32f")
set(EPF_CPU rv32,d=false)
include(${CMAKE_CURRENT_LIST_DIR}/riscv64-unknown-elf.cmake)
