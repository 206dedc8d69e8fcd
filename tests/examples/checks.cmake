# What the scripts that run a program check alike.

function(must_be_picture file)
    file(READ "${file}" signature LIMIT 8 HEX)
    if(NOT signature STREQUAL "89504e470d0a1a0a")
        message(SEND_ERROR "${file} is not a PNG picture")
    endif()
endfunction()

function(must_leave_nothing_behind)
    file(GLOB left "${SCRATCH}/*.tmp")
    if(left)
        message(SEND_ERROR "left behind: ${left}")
    endif()
endfunction()
