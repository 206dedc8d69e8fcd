set(EPF_CPU_FLAGS "-mcpu=cortex-m33 -mfloat-abi=hard -mfpu=fpv5-sp-d16")
set(EPF_BOARD mps2-an505)
set(EPF_MEMORY 0x10000000 4M 0x38000000 4M)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
