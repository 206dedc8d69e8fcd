# Runs a program in a fresh directory and checks all that it leaves behind.
#
#   cmake -DPROGRAM=<path> -DSCRATCH=<directory> -DSTATUS=<exit status> [...] -P run.cmake -- <args>
#
#   RECORD, PARAMS    files to put there as record.csv and friction.params; they must not change
#   LINK, TO          a symbolic link to put there, and what it says
#   HARD_LINK         another name to give to record.csv
#   STDERR            regular expression that the one line on stderr must match; without: no line
#   STDOUT            regular expression that stdout must match
#   MADE              the files, and no others, that a success makes, as a shell would be told
#   RESULT, EXPECTED  a file that was made, and one that it must equal
#   AGAIN             a file that a second run with --out <file> makes, equal to RESULT
#   RMS_AT_MOST       bound for the rms residual that stdout tells, N
#   OFF_F32_AT_MOST   bound for the residual off f32 that stdout tells, either way, %
#   NO_GNUPLOT        if true, PATH leads nowhere
#
# A failure must print nothing on stdout and leave the directory as it was, with the result of an
# earlier run in it.

cmake_policy(VERSION 3.16)

include("${CMAKE_CURRENT_LIST_DIR}/arguments.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/checks.cmake")

file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
set(there)
if(RECORD)
    configure_file("${RECORD}" "${SCRATCH}/record.csv" COPYONLY)
    list(APPEND there record.csv)
endif()
if(PARAMS)
    configure_file("${PARAMS}" "${SCRATCH}/friction.params" COPYONLY)
    list(APPEND there friction.params)
endif()
if(LINK)
    file(CREATE_LINK "${TO}" "${SCRATCH}/${LINK}" SYMBOLIC)
    list(APPEND there ${LINK})
endif()
if(HARD_LINK)
    file(CREATE_LINK "${SCRATCH}/record.csv" "${SCRATCH}/${HARD_LINK}")
    list(APPEND there ${HARD_LINK})
endif()
if(NOT STATUS EQUAL 0)
    file(WRITE "${SCRATCH}/replay.csv" "earlier")
    file(WRITE "${SCRATCH}/replay.png" "earlier")
    list(APPEND there replay.csv replay.png)
endif()
if(NO_GNUPLOT)
    set(ENV{PATH} "${SCRATCH}")
endif()

function(run_program) # its arguments: more arguments for the program
    execute_process(COMMAND "${PROGRAM}" ${arguments} ${ARGN} WORKING_DIRECTORY "${SCRATCH}"
        RESULT_VARIABLE status OUTPUT_VARIABLE stdout ERROR_VARIABLE stderr)
    message("${stdout}${stderr}exit status ${status}")
    if(NOT status STREQUAL STATUS)
        message(SEND_ERROR "the exit status is ${status}, not ${STATUS}")
    endif()
    set(stdout "${stdout}" PARENT_SCOPE)
    set(stderr "${stderr}" PARENT_SCOPE)
endfunction()

function(check_equal one other)
    execute_process(COMMAND "${CMAKE_COMMAND}" -E compare_files "${one}" "${other}"
        RESULT_VARIABLE differs)
    if(differs)
        message(SEND_ERROR "${one} differs from ${other}")
    endif()
endfunction()

run_program()

if(STDERR AND NOT stderr MATCHES "${STDERR}")
    message(SEND_ERROR "stderr does not match ${STDERR}")
elseif(STDERR AND NOT stderr MATCHES "^[^\n]+\n$")
    message(SEND_ERROR "stderr is not exactly one line")
elseif(NOT STDERR AND NOT stderr STREQUAL "")
    message(SEND_ERROR "stderr is not empty")
endif()

if(STDOUT AND NOT stdout MATCHES "${STDOUT}")
    message(SEND_ERROR "stdout does not match ${STDOUT}")
endif()

if(NOT STATUS EQUAL 0)
    file(READ "${SCRATCH}/replay.csv" csv)
    file(READ "${SCRATCH}/replay.png" png)
    if(NOT "${csv}${png}" STREQUAL "earlierearlier")
        message(SEND_ERROR "the earlier result has been changed")
    endif()
    if(NOT stdout STREQUAL "")
        message(SEND_ERROR "stdout is not empty")
    endif()
endif()

file(GLOB found RELATIVE "${SCRATCH}" "${SCRATCH}/*")
separate_arguments(MADE UNIX_COMMAND "${MADE}")
list(APPEND there ${MADE})
list(SORT there)
list(SORT found)
if(NOT "${found}" STREQUAL "${there}")
    message(SEND_ERROR "expected the files ${there}, found ${found}")
endif()

if(RECORD)
    check_equal("${SCRATCH}/record.csv" "${RECORD}")
endif()
if(PARAMS)
    check_equal("${SCRATCH}/friction.params" "${PARAMS}")
endif()
if(EXPECTED)
    check_equal("${SCRATCH}/${RESULT}" "${EXPECTED}")
endif()

if(AGAIN)
    run_program(--out "${AGAIN}")
    check_equal("${SCRATCH}/${RESULT}" "${SCRATCH}/${AGAIN}")
endif()

if(RMS_AT_MOST)
    if(NOT stdout MATCHES "rms residual +([0-9.e+-]+) N")
        message(SEND_ERROR "stdout tells no rms residual")
    elseif(CMAKE_MATCH_1 GREATER RMS_AT_MOST)
        message(SEND_ERROR "the rms residual is ${CMAKE_MATCH_1} N, above ${RMS_AT_MOST} N")
    endif()
endif()

if(OFF_F32_AT_MOST)
    if(NOT stdout MATCHES "residual off f32 +[+-]([0-9.e+-]+) %")
        message(SEND_ERROR "stdout does not tell the residual off f32")
    elseif(CMAKE_MATCH_1 GREATER OFF_F32_AT_MOST)
        message(SEND_ERROR "the residual is ${CMAKE_MATCH_1} % off f32, not ${OFF_F32_AT_MOST} %")
    endif()
endif()

foreach(file IN LISTS MADE)
    if(file MATCHES "png$")
        must_be_picture("${SCRATCH}/${file}")
    endif()
endforeach()
