set(EPF_CPU_FLAGS "-march=rv32imac -mabi=ilp32")
set(EPF_CPU rv32,f=false,d=false)
include(${CMAKE_CURRENT_LIST_DIR}/riscv64-unknown-elf.cmake)
