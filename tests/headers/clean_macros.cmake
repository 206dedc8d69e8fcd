# The headers and macros keep to strict warnings, old-style casts of C++ included, without the pragma that
# keeps the messages of constants.h short; and a constant does not grow beyond what a compiler reads in
# no time. Needs SCRATCH too.

include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)

set(slide "1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,EPF_STRIBECK_LORENTZIAN,EPF_UPDATE_SATURATED")
set(constants "EPF_F32_COEFFS(${slide})")
foreach(name EPF_Q31_COEFFS EPF_Q15_COEFFS)
    list(APPEND constants "${name}(${slide},1e-7f,1e-7f,1e-4f,1e-5f)")
endforeach()

file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${INCLUDE_DIR}/epf DESTINATION ${SCRATCH})
set(engine ${SCRATCH}/epf/detail/constants.h)
file(READ ${engine} text)
string(REGEX REPLACE "\n#pragma GCC[ \\\n]+system_header[^\n]*" "" without "${text}")
if(without STREQUAL text)
    message(FATAL_ERROR "${engine} has no pragma to leave out")
endif()
file(WRITE ${engine} "${without}")

foreach(constant IN LISTS constants)
    foreach(INCLUDE_DIR ${INCLUDE_DIR} ${SCRATCH})
        compile_constant("${constant}")
        if(result OR message)
            message(SEND_ERROR "${constant} should compile without a word:\n${message}")
        endif()
    endforeach()
endforeach()

set(MOST_CHARACTERS 30000)
if(LANGUAGE STREQUAL "C")
    foreach(constant IN LISTS constants)
        execute_process(COMMAND ${COMPILER} -std=c99 -x c -E -P -I${INCLUDE_DIR}
            "-DTYPE=int" "-DCOEFFS=${constant}" ${CMAKE_CURRENT_LIST_DIR}/constant.h
            OUTPUT_VARIABLE expanded COMMAND_ERROR_IS_FATAL ANY)
        string(REGEX REPLACE ".*const int coeffs;" "" expanded "${expanded}")
        string(LENGTH "${expanded}" length)
        string(REGEX REPLACE "_COEFFS.*" "_COEFFS" name "${constant}")
        message(STATUS "${name}: ${length} characters")
        if(length LESS 100 OR length GREATER MOST_CHARACTERS)
            message(SEND_ERROR "${name} expands to ${length} characters, not 100 to ${MOST_CHARACTERS}")
        endif()
    endforeach()
endif()
