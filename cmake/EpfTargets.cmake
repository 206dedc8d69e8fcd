# How every target of the project is compiled.

include(GNUInstallDirs) # before the library says where its headers will be

# Warnings as errors for what is ours, and only while we are the ones who build: a compiler that is
# newer than ours must not break a user's build.
function(epf_own_warnings target)
    if(EPF_IS_TOP_LEVEL AND CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
        target_compile_options(${target} PRIVATE
            -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow
            -Wcast-qual -Wundef -Werror
            $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes>
            $<$<COMPILE_LANGUAGE:C>:-Wmissing-prototypes>)
    endif()
endfunction()

# C99, no extensions, and no fused multiply-add: the same bits on every target.
function(epf_language target)
    set_target_properties(${target} PROPERTIES
        C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
    if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
        target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:C>:-ffp-contract=off>)
    endif()
endfunction()

# The library, also for targets that compile it once more under other flags.
function(epf_library_sources target)
    target_sources(${target} PRIVATE
        ${PROJECT_SOURCE_DIR}/src/coeffs.c
        ${PROJECT_SOURCE_DIR}/src/f32.c
        ${PROJECT_SOURCE_DIR}/src/params.c
        ${PROJECT_SOURCE_DIR}/src/q15.c
        ${PROJECT_SOURCE_DIR}/src/q31.c)
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    epf_language(${target})
    epf_own_warnings(${target})
endfunction()
