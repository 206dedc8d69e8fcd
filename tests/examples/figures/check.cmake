# Runs epf_figures: it must succeed, and the tables in README.md must be those that it prints.
#
#   cmake -DPROGRAM=<path> -DREADME=<path> -DSCRATCH=<directory> -DDRAWS=<bool> -P check.cmake
#
#   DRAWS  if true, gnuplot is there, and draws every figure

cmake_policy(VERSION 3.16)

file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
set(arguments --out "${SCRATCH}")
if(NOT DRAWS)
    list(APPEND arguments --no-pictures)
endif()
execute_process(COMMAND "${PROGRAM}" ${arguments}
    RESULT_VARIABLE status OUTPUT_VARIABLE printed ERROR_VARIABLE errors)
message("${printed}${errors}")
if(NOT status STREQUAL "0" OR NOT errors STREQUAL "")
    message(SEND_ERROR "exit status ${status}")
endif()

# The rows of all tables, less those that stand above the claims. To CMake a semicolon or a bracket in a line
# would be part of a list.
function(rows text variable)
    string(REGEX REPLACE "[;[]|]" "_" text "\n${text}")
    string(REGEX MATCHALL "\n[|][^\n]*" found "${text}")
    list(FILTER found EXCLUDE REGEX "^\n([|] figure [|] claim|[|]---[|]---[|]---[|]---[|]---[|])")
    set(${variable} "${found}" PARENT_SCOPE)
endfunction()

file(READ "${README}" readme)
rows("${printed}" printed_rows)
rows("${readme}" readme_rows)
foreach(row IN LISTS readme_rows)
    if(NOT row IN_LIST printed_rows)
        message(SEND_ERROR "README.md tells what was not printed: ${row}")
    endif()
endforeach()
foreach(row IN LISTS printed_rows)
    if(NOT row IN_LIST readme_rows)
        message(SEND_ERROR "README.md does not tell: ${row}")
    endif()
endforeach()
if(NOT readme_rows STREQUAL printed_rows)
    message(SEND_ERROR "the rows in README.md are not those that were printed, in their order")
endif()
list(LENGTH printed_rows count)
if(count EQUAL 0)
    message(SEND_ERROR "nothing was claimed")
endif()

foreach(figure 2 3 4 5 6 7 8 fidelity)
    if(NOT EXISTS "${SCRATCH}/figure_${figure}.csv")
        message(SEND_ERROR "there is no figure_${figure}.csv")
    endif()
    if(DRAWS)
        file(READ "${SCRATCH}/figure_${figure}.png" signature LIMIT 8 HEX)
        if(NOT signature STREQUAL "89504e470d0a1a0a")
            message(SEND_ERROR "figure_${figure}.png is not a PNG picture")
        endif()
    endif()
endforeach()
