# Builds and runs the three tests with each compiler at each level of optimisation.
# Needs SOURCE_DIR, UNITY_DIR and SCRATCH.

set(levels "-O0" "-O1" "-O2" "-O3" "-Os" "-O3 -march=native")
set(tests "${SOURCE_DIR}/tests")
set(shared "${tests}/bits/checksum.c" "${SOURCE_DIR}/src/params.c" "${UNITY_DIR}/unity.c")
set(fixed "${tests}/bits/fixed_bits.c" "${SOURCE_DIR}/src/coeffs.c")
set(sources_f32 "${SOURCE_DIR}/src/f32.c")
set(sources_q31 "${tests}/theorems/q31_variant.c" ${fixed})
set(sources_q15 "${tests}/theorems/q15_variant.c" ${fixed})
set(flags -std=c99 -ffp-contract=off -I${SOURCE_DIR}/include -I${tests}/theorems -I${tests}/sequences
    -DUNITY_INCLUDE_DOUBLE -isystem ${UNITY_DIR})

file(MAKE_DIRECTORY "${SCRATCH}")
foreach(compiler gcc clang)
    foreach(level IN LISTS levels)
        separate_arguments(optimisation UNIX_COMMAND "${level}")
        foreach(variant f32 q31 q15)
            set(program "${SCRATCH}/${variant}_bits")
            foreach(command "${compiler};${optimisation};${flags};${tests}/bits/${variant}_bits.c;\
${sources_${variant}};${shared};-lm;-o;${program}" "${program}")
                execute_process(COMMAND ${command} RESULT_VARIABLE status OUTPUT_VARIABLE output
                    ERROR_VARIABLE output)
                if(NOT status EQUAL 0)
                    message(FATAL_ERROR "${compiler} ${level}: ${variant}: ${status}\n${output}")
                endif()
            endforeach()
        endforeach()
        message(STATUS "${compiler} ${level}: the bits of checksums.h")
    endforeach()
endforeach()
