# What all AVR toolchains share; included by atmega*.cmake, which sets EPF_MCU.
# Debian packages: gcc-avr avr-libc; to run, libsimavr-dev libelf-dev and a compiler for the host

set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR avr)
set(CMAKE_C_COMPILER avr-gcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_C_FLAGS_INIT "-mmcu=${EPF_MCU} -ffunction-sections -fdata-sections")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,--gc-sections")

# Ours, on libsimavr: tests/target builds it
set(CMAKE_CROSSCOMPILING_EMULATOR ${CMAKE_BINARY_DIR}/avrrun ${EPF_MCU})

# Emulation is slow: see tests/sequences/effort.h
set(EPF_TEST_ONE_IN 400 CACHE STRING "Run one in so many samples of each test")
