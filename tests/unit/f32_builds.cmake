# How src/f32.c may be compiled and linked, and how not. Each WAY is a test; needs COMPILER, NM, SOURCE_DIR,
# UNITY_DIR and SCRATCH.

set(includes -I${SOURCE_DIR}/include -I${SOURCE_DIR}/src)
set(strict -std=c99 -Wall -Wextra -Wpedantic -Werror -ffp-contract=off ${includes})
set(library ${SOURCE_DIR}/src/f32.c ${SOURCE_DIR}/src/params.c)
set(test ${SOURCE_DIR}/tests/unit/f32_drift_test.c ${UNITY_DIR}/unity.c -isystem ${UNITY_DIR}
    -I${SOURCE_DIR}/tests/sequences -DUNITY_INCLUDE_DOUBLE -DEPF_TEST_ONE_IN=1)
file(MAKE_DIRECTORY ${SCRATCH})

function(run)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${SCRATCH}
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    set(result ${result} PARENT_SCOPE)
    set(output "${output}" PARENT_SCOPE)
endfunction()

function(works)
    run(${ARGN})
    if(result)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "${command}\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

# fails(TEXT COMMAND...): for the reason that TEXT matches
function(fails text)
    run(${ARGN})
    if(NOT result OR NOT output MATCHES "${text}")
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "should fail with \"${text}\": ${command}\n${output}")
    endif()
endfunction()

# The two-sum survives, or the compiler is told no: there is no third way
function(refused_or_right)
    run(${COMPILER} ${strict} -Wno-error ${ARGN} ${test} ${library} -lm -o ${WAY})
    if(result)
        if(NOT output MATCHES "epf needs IEEE arithmetic")
            message(FATAL_ERROR "${ARGN}: refused, but for another reason\n${output}")
        endif()
        return()
    endif()
    works(${SCRATCH}/${WAY})
endfunction()

if(WAY STREQUAL "fast_math")
    foreach(level -O0 -O2 -O3)
        foreach(source f32 params coeffs) # all that computes with floats
            fails("epf needs IEEE arithmetic"
                ${COMPILER} ${strict} ${level} -ffast-math -c ${SOURCE_DIR}/src/${source}.c -o refused.o)
        endforeach()
        refused_or_right(${level} -funsafe-math-optimizations)
        refused_or_right(${level} -fassociative-math -fno-signed-zeros -fno-trapping-math)
        refused_or_right(${level} -fassociative-math -fno-signed-zeros)
    endforeach()
elseif(WAY STREQUAL "other_form")
    # the user's file without EPF_STRIBECK_ONLY, the library with it; and the other way round
    set(user ${SOURCE_DIR}/tests/unit/f32_user.c)
    works(${COMPILER} ${strict} -c ${user} -o user.o)
    works(${COMPILER} ${strict} -DEPF_STRIBECK_ONLY=EPF_STRIBECK_LORENTZIAN -c ${user} -o only_user.o)
    works(${COMPILER} ${strict} user.o ${library} -o user)
    works(${SCRATCH}/user)
    works(${COMPILER} ${strict} -DEPF_STRIBECK_ONLY=EPF_STRIBECK_LORENTZIAN only_user.o ${library} -o user)
    works(${SCRATCH}/user)
    foreach(form LORENTZIAN GAUSSIAN COULOMB)
        fails("epf_f32_init" ${COMPILER} ${strict} -DEPF_STRIBECK_ONLY=EPF_STRIBECK_${form}
            user.o ${library} -o user)
    endforeach()
    fails("epf_f32_init" ${COMPILER} ${strict} only_user.o ${library} -o user)
    fails("epf_f32_init" ${COMPILER} ${strict} -DEPF_STRIBECK_ONLY=EPF_STRIBECK_GAUSSIAN
        only_user.o ${library} -o user)
elseif(WAY STREQUAL "no_calls")
    # what f32 calls: the check of the parameters, and nothing that has a loop
    foreach(level -O1 -O2 -O3 -Os) # unoptimised, clang copies structures of 16 bytes by memcpy
        works(${COMPILER} ${strict} ${level} -fno-stack-protector -c ${SOURCE_DIR}/src/f32.c -o f32.o)
        works(${NM} -u f32.o)
        string(REGEX REPLACE "epf_params_check|_GLOBAL_OFFSET_TABLE_|[ Uw\n]" "" left "${output}")
        if(left)
            message(FATAL_ERROR "${level}: f32.c calls something else, too:\n${output}")
        endif()
    endforeach()
else()
    message(FATAL_ERROR "no such way: ${WAY}")
endif()
