# Proves the shipped sources, and the theorems on them. Fails when any goal is left.

foreach(tool frama-c why3 z3 cvc4)
    find_program(found_${tool} ${tool})
    if(NOT found_${tool})
        message(FATAL_ERROR "proof: no ${tool}; Debian has frama-c-base, why3, z3 and cvc4")
    endif()
endforeach()

# Why3 tells a shell the names of its scratch files, as they are
if("$ENV{TMPDIR}" MATCHES "[^-+._/a-zA-Z0-9]")
    set(ENV{TMPDIR} /tmp)
endif()

# The provers, known to a configuration of our own
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
set(ENV{WHY3CONFIG} ${SCRATCH}/why3.conf)
execute_process(COMMAND why3 config detect OUTPUT_QUIET ERROR_QUIET)

# Frama-C takes PWD for the folder that it works in.
set(ENV{PWD} ${SOURCE_DIR})

set(total 0)

# prove(FILE OPTIONS...): all contracts of a file; options may be more of Frama-C's
function(prove file)
    execute_process(
        COMMAND frama-c -wp -wp-rte -wp-no-volatile -wp-cache none
            -wp-prover z3,cvc4 -wp-timeout 60 -wp-par 2 "-cpp-extra-args=-Iinclude -Isrc"
            ${file} ${ARGN}
        WORKING_DIRECTORY ${SOURCE_DIR}
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT output MATCHES "Proved goals: +([0-9]+) / ([0-9]+)")
        message(FATAL_ERROR "proof: Frama-C did not get through ${file}\n${output}")
    endif()
    set(proved ${CMAKE_MATCH_1})
    set(goals ${CMAKE_MATCH_2})
    message("${file}: Proved goals: ${proved} / ${goals}")
    if(result OR goals EQUAL 0 OR NOT proved EQUAL goals)
        string(REGEX MATCHALL "\\[(Failed|Timeout|Unknown)\\] Goal [a-zA-Z0-9_]+" left "${output}")
        list(JOIN left "\n  " left)
        message(FATAL_ERROR "proof: goals are left in ${file}:\n  ${left}")
    endif()
    math(EXPR total "${total} + ${goals}")
    set(total ${total} PARENT_SCOPE)
endfunction()

prove(tests/proof/steps.c -wp-fct=internal_force,steady_motion)
prove(src/q31.c)
prove(src/q31.c -wp-fct=product -cpp-extra-args=-DHAS_NO_LONG_PRODUCT)
prove(src/q15.c)
message("all: Proved goals: ${total} / ${total}")
