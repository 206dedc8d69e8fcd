# What the toolchains with picolibc and QEMU share. Whoever includes this has set
#   EPF_TRIPLE     the name of the compiler before -gcc
#   EPF_CPU_FLAGS  which core to compile for
#   EPF_QEMU       the emulator and its board, as a list
#   EPF_MEMORY     origin and size of the flash, origin and size of the RAM of that board, as a list

set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_C_COMPILER ${EPF_TRIPLE}-gcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_C_FLAGS_INIT "${EPF_CPU_FLAGS} -ffunction-sections -fdata-sections \
-specs=/usr/lib/picolibc/${EPF_TRIPLE}/picolibc.specs")

# The exit status of main is that of the emulator: picolibc asks it by semihosting.
list(GET EPF_MEMORY 0 flash)
list(GET EPF_MEMORY 1 flash_size)
list(GET EPF_MEMORY 2 ram)
list(GET EPF_MEMORY 3 ram_size)
set(CMAKE_EXE_LINKER_FLAGS_INIT "--crt0=hosted --oslib=semihost \
-Wl,--defsym=__flash=${flash},--defsym=__flash_size=${flash_size} \
-Wl,--defsym=__ram=${ram},--defsym=__ram_size=${ram_size},--defsym=__stack_size=4k")
set(CMAKE_CROSSCOMPILING_EMULATOR ${EPF_QEMU}
    -display none -monitor none -serial none -chardev stdio,id=console,signal=off
    -semihosting-config enable=on,target=native,chardev=console -kernel)

# Emulation is slow: see tests/sequences/effort.h
set(EPF_TEST_ONE_IN 20 CACHE STRING "Run one in so many samples of each test")
