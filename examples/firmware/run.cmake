# Runs an image, on its emulator if it has one, and checks what it prints.
#
#     cmake -DSTATUS=<exit status> [...] -P run.cmake -- <command>
#
#   TRACE   file with which the output must begin
#   PRINTS  regular expression that the output must match
#   UPDATE  file that is to become the output

math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
    if(DEFINED command)
        list(APPEND command ${CMAKE_ARGV${i}})
    elseif(CMAKE_ARGV${i} STREQUAL "--")
        set(command "")
    endif()
endforeach()

execute_process(COMMAND ${command} RESULT_VARIABLE status OUTPUT_VARIABLE output)
if(NOT status STREQUAL STATUS)
    message("${output}")
    message(FATAL_ERROR "the exit status is ${status}, not ${STATUS}")
endif()

if(UPDATE)
    file(WRITE "${UPDATE}" "${output}")
    return()
endif()
message("${output}")
if(TRACE)
    file(READ "${TRACE}" trace)
    string(FIND "${output}" "${trace}" found)
    if(NOT found EQUAL 0)
        message(FATAL_ERROR "the output does not begin with ${TRACE}:\n${trace}")
    endif()
endif()
if(NOT output MATCHES "${PRINTS}")
    message(FATAL_ERROR "the output does not match ${PRINTS}")
endif()
