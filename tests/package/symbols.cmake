# What the library links with, and that it has no data: cmake -DNM=... -DLIBRARY=... -P symbols.cmake
#
# A list of what is allowed rather than of what is not: a heap, stdio, libm or double-precision
# routine is one of those that nobody thought of.

set(allowed
    "epf_[a-z0-9_]+"
    "mem(set|cpy)"               # structure copies; every freestanding compiler needs them
    "_GLOBAL_OFFSET_TABLE_"      # position-independent code
    "__aeabi_mem(set|cpy|clr)[48]?"
    # products and shifts of 64 bits in q31, where the core has none
    "__aeabi_(lmul|llsl|llsr)" "__(mul|ashl|lshr)di3"
    # single precision in software
    "__aeabi_(fadd|fsub|frsub|fmul|fdiv|fcmp[a-z]+|cfcmp[a-z]+|cfrcmple|f2u?iz|u?i2f)"
    "__(add|sub|mul|div)sf3" "__(eq|ne|lt|le|gt|ge|unord)sf2" "__fix(uns)?sfsi" "__float(un)?sisf")

function(require_allowed needed)
    foreach(pattern IN LISTS allowed)
        if(needed MATCHES "^${pattern}$")
            return()
        endif()
    endforeach()
    message(SEND_ERROR "the library needs ${needed}, which is not on the list")
endfunction()

execute_process(COMMAND ${NM} ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(result OR NOT symbols MATCHES " T epf_f32_step")
    message(FATAL_ERROR "${NM} ${LIBRARY} lists no epf_f32_step: is it the library?")
endif()

string(REPLACE "\n" ";" symbols "${symbols}")
foreach(symbol IN LISTS symbols)
    if(symbol MATCHES " U (.*)$")
        require_allowed("${CMAKE_MATCH_1}")
    elseif(symbol MATCHES " [bBdDgGsScC] (.*)$")
        message(SEND_ERROR "the library has data in RAM: ${CMAKE_MATCH_1}")
    endif()
endforeach()
