# What all Cortex-M toolchains share; included by cortex-*.cmake, which sets EPF_CPU_FLAGS, EPF_BOARD
# and EPF_MEMORY (see picolibc.cmake).
# Debian packages: gcc-arm-none-eabi picolibc-arm-none-eabi; to run, qemu-system-arm

set(CMAKE_SYSTEM_PROCESSOR arm)
set(EPF_TRIPLE arm-none-eabi)
string(APPEND EPF_CPU_FLAGS " -mthumb")
set(EPF_QEMU qemu-system-arm -M ${EPF_BOARD})
include(${CMAKE_CURRENT_LIST_DIR}/picolibc.cmake)
