set(EPF_CPU_FLAGS "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16")
set(EPF_BOARD mps2-an386)
set(EPF_MEMORY 0 4M 0x20000000 4M)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
