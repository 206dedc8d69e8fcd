set(EPF_CPU_FLAGS "-mcpu=cortex-m0")
set(EPF_BOARD microbit)
set(EPF_MEMORY 0 256k 0x20000000 16k)
set(EPF_TEST_ONE_IN 40 CACHE STRING "Run one in so many samples of each test") # soft floats
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
