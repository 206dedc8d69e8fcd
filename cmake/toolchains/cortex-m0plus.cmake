set(EPF_CPU_FLAGS "-mcpu=cortex-m0plus")
set(EPF_BOARD microbit)
set(EPF_MEMORY 0 256k 0x20000000 16k)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
