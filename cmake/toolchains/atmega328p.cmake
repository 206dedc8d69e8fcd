set(EPF_MCU atmega328p)
include(${CMAKE_CURRENT_LIST_DIR}/avr.cmake)
