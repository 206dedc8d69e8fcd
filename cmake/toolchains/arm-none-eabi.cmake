# What all Cortex-M toolchains share; included by cortex-*.cmake, which sets EPF_CPU_FLAGS.
# Debian packages: gcc-arm-none-eabi picolibc-arm-none-eabi

set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_C_FLAGS_INIT "${EPF_CPU_FLAGS} -mthumb -ffunction-sections -fdata-sections \
-specs=/usr/lib/picolibc/arm-none-eabi/picolibc.specs")
