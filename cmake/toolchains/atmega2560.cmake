set(EPF_MCU atmega2560)
include(${CMAKE_CURRENT_LIST_DIR}/avr.cmake)
