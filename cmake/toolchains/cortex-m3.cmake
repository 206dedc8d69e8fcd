set(EPF_CPU_FLAGS "-mcpu=cortex-m3")
set(EPF_BOARD mps2-an385)
set(EPF_MEMORY 0 4M 0x20000000 4M)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
