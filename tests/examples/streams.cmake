# Runs epf_replay where its result or what it prints goes elsewhere than to an ordinary file, or where
# there is no room for it. Every CASE is a property that must hold.
#
#   cmake -DCASE=<see below> -DPROGRAM=<path> -DSCRATCH=<directory> -DRECORD=<file> -DEXPECTED=<file>
#         -P streams.cmake -- <args>
#
# The arguments replay RECORD, whose result is EXPECTED.

cmake_policy(VERSION 3.16)

include("${CMAKE_CURRENT_LIST_DIR}/arguments.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/checks.cmake")

file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
configure_file("${RECORD}" "${SCRATCH}/record.csv" COPYONLY)
file(READ "${EXPECTED}" expected)

# A stream with a name in SCRATCH, whose replacement, should it come to that, does no harm elsewhere
file(CREATE_LINK /dev/fd/1 "${SCRATCH}/stdout.csv" SYMBOLIC)

function(run) # its arguments: those of execute_process, after the command
    execute_process(COMMAND ${command} ${ARGN} WORKING_DIRECTORY "${SCRATCH}" TIMEOUT 30
        RESULTS_VARIABLE status ERROR_VARIABLE stderr OUTPUT_VARIABLE stdout)
    message("${stdout}${stderr}exit status ${status}")
    set(status "${status}" PARENT_SCOPE)
    set(stdout "${stdout}" PARENT_SCOPE)
    set(stderr "${stderr}" PARENT_SCOPE)
endfunction()

function(must_succeed)
    list(REMOVE_DUPLICATES status)
    if(NOT status STREQUAL "0" OR NOT stderr STREQUAL "")
        message(SEND_ERROR "expected success, and nothing on stderr")
    endif()
endfunction()

function(must_fail message)
    if(NOT status STREQUAL "1" OR NOT stderr MATCHES "^epf_replay: ${message}[^\n]*\n$")
        message(SEND_ERROR "expected exit status 1, and one line on stderr: ${message}")
    endif()
endfunction()

function(must_begin text beginning)
    string(FIND "${text}" "${beginning}" place)
    if(NOT place EQUAL 0)
        message(SEND_ERROR "expected first of all:\n${beginning}\nfound:\n${text}")
    endif()
endfunction()

function(must_be file text)
    file(READ "${SCRATCH}/${file}" found)
    if(NOT found STREQUAL text)
        message(SEND_ERROR "${file}: expected:\n${text}\nfound:\n${found}")
    endif()
endfunction()

function(must_be_link name)
    if(NOT IS_SYMLINK "${SCRATCH}/${name}")
        message(SEND_ERROR "${name} was a symbolic link")
    endif()
endfunction()

set(command "${PROGRAM}" ${arguments} --out)

if(CASE STREQUAL "fifo_is_written_through")
    execute_process(COMMAND mkfifo "${SCRATCH}/fifo")
    run(fifo COMMAND sh -c "cat fifo && cat >/dev/null") # and the summary, or it breaks a pipe
    must_succeed()
    must_begin("${stdout}" "${expected}")
    execute_process(COMMAND test -p "${SCRATCH}/fifo" RESULT_VARIABLE replaced)
    if(replaced)
        message(SEND_ERROR "the FIFO was replaced")
    endif()

elseif(CASE STREQUAL "link_to_a_file_stays_a_link")
    file(WRITE "${SCRATCH}/file.csv" "earlier")
    file(CREATE_LINK file.csv "${SCRATCH}/link.csv" SYMBOLIC)
    run(link.csv)
    must_succeed()
    must_be_link(link.csv)
    must_be(file.csv "${expected}")

elseif(CASE STREQUAL "link_to_nothing_yet_stays_a_link")
    file(MAKE_DIRECTORY "${SCRATCH}/folder")
    file(CREATE_LINK folder/second.csv "${SCRATCH}/first.csv" SYMBOLIC)
    file(CREATE_LINK "${SCRATCH}/folder/third.csv" "${SCRATCH}/folder/second.csv" SYMBOLIC)
    file(CREATE_LINK ../file.csv "${SCRATCH}/folder/third.csv" SYMBOLIC)
    run(first.csv)
    must_succeed()
    must_be_link(first.csv)
    must_be_link(folder/second.csv)
    must_be_link(folder/third.csv)
    must_be(file.csv "${expected}")

elseif(CASE STREQUAL "stdout_gets_the_result_before_the_summary")
    run(stdout.csv)
    must_succeed()
    must_be_link(stdout.csv)
    must_begin("${stdout}" "${expected}record ")

elseif(CASE STREQUAL "stdout_in_a_file_gets_the_result_before_the_summary")
    run(stdout.csv OUTPUT_FILE both.txt)
    must_succeed()
    must_be_link(stdout.csv)
    file(READ "${SCRATCH}/both.txt" both)
    must_begin("${both}" "${expected}record ")

elseif(CASE STREQUAL "file_without_a_name_is_written_through")
    set(no_name "exec 3<>gone.csv && rm gone.csv")
    set(command sh -c "${no_name} && \"$@\" --out /dev/fd/3 >summary.txt && cat <&3"
        sh "${PROGRAM}" ${arguments})
    run()
    must_succeed()
    must_begin("${stdout}" "${expected}")

elseif(CASE STREQUAL "full_stdout_is_reported")
    run(file.csv OUTPUT_FILE /dev/full)
    must_fail("stdout: cannot write")
    must_be(file.csv "${expected}")

elseif(CASE STREQUAL "full_stdout_is_reported_by_help")
    set(command "${PROGRAM}" --help)
    run(OUTPUT_FILE /dev/full)
    must_fail("stdout: cannot write")

elseif(CASE STREQUAL "closed_stdout_is_reported")
    set(command sh -c "exec \"$@\" >&-" sh ${command})
    run(file.csv)
    must_fail("stdout: cannot write")

elseif(CASE STREQUAL "full_device_is_reported")
    run(stdout.csv OUTPUT_FILE /dev/full)
    must_fail("stdout.csv: cannot write")

elseif(CASE STREQUAL "full_disk_is_reported")
    file(WRITE "${SCRATCH}/file.csv" "earlier")
    set(command sh -c "trap '' XFSZ && ulimit -f 0 && exec \"$@\"" sh ${command})
    run(file.csv)
    must_fail("file.csv: cannot write")
    must_be(file.csv "earlier")

elseif(CASE STREQUAL "progress_is_a_line_on_a_terminal_and_then_removed")
    set(ENV{PROGRAM} "${PROGRAM}")
    list(JOIN arguments " " words)
    set(command script -qec) # gives it a terminal
    run("\"$PROGRAM\" ${words} --out stdout.csv" /dev/null)
    must_succeed()
    if(stdout MATCHES "row [0-9]")
        message(SEND_ERROR "progress is shown between the rows of the result")
    endif()
    run("\"$PROGRAM\" ${words} --out file.csv" /dev/null)
    must_succeed()
    if(NOT stdout MATCHES "^row 1\r     \rrecord ")
        message(SEND_ERROR "expected a line of progress, removed")
    endif()

else()
    message(FATAL_ERROR "no such case: ${CASE}")
endif()
must_leave_nothing_behind()
