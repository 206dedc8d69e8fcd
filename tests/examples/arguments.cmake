# What follows -- on the command line of a script, as the list `arguments`

set(arguments)
math(EXPR last "${CMAKE_ARGC} - 1")
set(ours FALSE)
foreach(i RANGE ${last})
    if(ours)
        list(APPEND arguments "${CMAKE_ARGV${i}}")
    elseif(CMAKE_ARGV${i} STREQUAL "--")
        set(ours TRUE)
    endif()
endforeach()
