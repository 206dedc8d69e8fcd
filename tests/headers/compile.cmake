# What the tests of this folder share. Needs COMPILER, LANGUAGE (C or CXX) and INCLUDE_DIR.

set(strict -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Werror -fsyntax-only)
set(strict_C -std=c99 -x c ${strict})
set(strict_CXX -std=c++11 -x c++ ${strict} -Wold-style-cast)

# compile(SOURCE FLAGS...): sets result and message
function(compile source)
    execute_process(
        COMMAND ${COMPILER} ${strict_${LANGUAGE}} -I${INCLUDE_DIR} ${ARGN} ${source}
        RESULT_VARIABLE result ERROR_VARIABLE message)
    set(result ${result} PARENT_SCOPE)
    set(message "${message}" PARENT_SCOPE)
endfunction()

# compile_constant(COEFFS): one macro, with its arguments
function(compile_constant coeffs)
    string(REGEX REPLACE "^EPF_(.*)_COEFFS.*" "epf_\\1_coeffs_t" type "${coeffs}")
    string(TOLOWER "${type}" type)
    compile(${CMAKE_CURRENT_LIST_DIR}/constant.h "-DTYPE=${type}" "-DCOEFFS=${coeffs}" ${ARGN})
    set(result ${result} PARENT_SCOPE)
    set(message "${message}" PARENT_SCOPE)
endfunction()
