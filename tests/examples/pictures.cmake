# Runs a program that draws a picture of its result, where the picture does not come about. Every CASE is a
# property that must hold, of every program.
#
#   cmake -DCASE=<see below> -DPROGRAM=<path> -DNAME=<its name> -DDATA=<file> -DPICTURE=<file>
#         -DRECORD=<file> -DINTERRUPT=<path> -DSCRATCH=<directory> -P pictures.cmake -- <args>
#
# The arguments make DATA and PICTURE in the working directory, from RECORD, which is there as record.csv.

cmake_policy(VERSION 3.16)

include("${CMAKE_CURRENT_LIST_DIR}/arguments.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/checks.cmake")

file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
configure_file("${RECORD}" "${SCRATCH}/record.csv" COPYONLY)

function(run) # its arguments: the command
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${SCRATCH}" TIMEOUT 30
        RESULT_VARIABLE status ERROR_VARIABLE stderr OUTPUT_VARIABLE stdout)
    message("${stdout}${stderr}exit status ${status}")
    set(status "${status}" PARENT_SCOPE)
    set(stdout "${stdout}" PARENT_SCOPE)
    set(stderr "${stderr}" PARENT_SCOPE)
endfunction()

# It calls one of the programs in the folder gnuplot
macro(gnuplot kind)
    set(ENV{PATH} "${CMAKE_CURRENT_LIST_DIR}/gnuplot/${kind}:$ENV{PATH}")
    file(WRITE "${SCRATCH}/${PICTURE}" "earlier")
endmacro()

function(must_end_with expected message)
    if(NOT status STREQUAL expected OR NOT stderr MATCHES "^${message}$")
        message(SEND_ERROR "expected exit status ${expected}, and on stderr: ${message}")
    endif()
endfunction()

function(must_be_earlier file)
    file(READ "${SCRATCH}/${file}" found)
    if(NOT found STREQUAL "earlier")
        message(SEND_ERROR "the earlier ${file} has been changed")
    endif()
endfunction()

function(must_not_draw)
    if(EXISTS "${SCRATCH}/${PICTURE}" OR stdout MATCHES "png")
        message(SEND_ERROR "expected no picture, and nothing about one")
    endif()
endfunction()

if(CASE STREQUAL "keeps_the_earlier_picture_if_gnuplot_fails")
    gnuplot(fails)
    run("${PROGRAM}" ${arguments})
    must_end_with(1 "${NAME}: [^\n]*${PICTURE}: gnuplot failed to draw the picture\n")
    must_be_earlier("${PICTURE}")
    if(stdout MATCHES "written[^\n]*png" OR NOT stdout MATCHES "no picture; try:  gnuplot -c ")
        message(SEND_ERROR "expected the command to draw it by hand")
    endif()

elseif(CASE STREQUAL "keeps_the_earlier_picture_if_the_new_one_is_not_whole")
    gnuplot(halves)
    run("${PROGRAM}" ${arguments})
    must_end_with(1 "${NAME}: [^\n]*${PICTURE}: gnuplot failed to draw the picture\n")
    must_be_earlier("${PICTURE}")

elseif(CASE STREQUAL "keeps_the_earlier_picture_if_interrupted")
    gnuplot(hangs)
    run("${INTERRUPT}" 2 default alone drawing "${PROGRAM}" ${arguments})
    must_end_with(130 "")
    must_be_earlier("${PICTURE}")
    file(STRINGS "${SCRATCH}/drawing" gnuplot)
    execute_process(COMMAND sh -c "kill -0 ${gnuplot}" RESULT_VARIABLE ended ERROR_QUIET)
    if(NOT ended)
        execute_process(COMMAND sh -c "kill ${gnuplot}")
        message(SEND_ERROR "gnuplot goes on")
    endif()

elseif(CASE STREQUAL "draws_through_a_link")
    file(CREATE_LINK file.png "${SCRATCH}/${PICTURE}" SYMBOLIC)
    run("${PROGRAM}" ${arguments})
    must_end_with(0 "")
    file(READ "${SCRATCH}/file.png" signature LIMIT 8 HEX)
    if(NOT IS_SYMLINK "${SCRATCH}/${PICTURE}" OR NOT signature STREQUAL "89504e470d0a1a0a")
        message(SEND_ERROR "expected a link to a picture")
    endif()

elseif(CASE STREQUAL "does_not_draw_a_fifo")
    execute_process(COMMAND mkfifo "${SCRATCH}/${DATA}")
    run(sh -c "cat \"$0\" >read.csv & \"$@\" && wait" "${DATA}" "${PROGRAM}" ${arguments})
    must_end_with(0 "")
    must_not_draw()
    file(SIZE "${SCRATCH}/read.csv" size)
    execute_process(COMMAND test -p "${SCRATCH}/${DATA}" RESULT_VARIABLE replaced)
    if(size EQUAL 0 OR replaced)
        message(SEND_ERROR "expected the result in the FIFO")
    endif()

elseif(CASE STREQUAL "does_not_draw_stdout")
    file(CREATE_LINK /dev/fd/1 "${SCRATCH}/${DATA}" SYMBOLIC)
    run("${PROGRAM}" ${arguments})
    must_end_with(0 "")
    must_not_draw()

elseif(CASE STREQUAL "reports_a_full_disk")
    file(WRITE "${SCRATCH}/${DATA}" "earlier")
    run(sh -c "trap '' XFSZ && ulimit -f 0 && exec \"$0\" \"$@\"" "${PROGRAM}" ${arguments})
    must_end_with(1 "${NAME}: [^\n]*${DATA}: cannot write the file\n")
    must_be_earlier("${DATA}")

else()
    message(FATAL_ERROR "no such case: ${CASE}")
endif()
must_leave_nothing_behind()
