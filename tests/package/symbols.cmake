# What the library links with, and that it has no data: cmake -DNM=... -DLIBRARY=... -P symbols.cmake
#
# A list of what is allowed rather than of what is not: a heap, stdio, libm or double-precision
# routine is one of those that nobody thought of. A call of memset or memcpy hides a loop: without
# optimisation compilers make some for structures, so a host build may define HOSTED to allow them.

set(everywhere "epf_[a-z0-9_]+" "_GLOBAL_OFFSET_TABLE_") # the latter: position-independent code
if(HOSTED)
    list(APPEND everywhere "mem(set|cpy)")
endif()
# single precision in software
set(floats
    "__aeabi_(fadd|fsub|frsub|fmul|fdiv|fcmp[a-z]+|cfcmp[a-z]+|cfrcmple|f2u?iz|u?i2f)"
    "__(add|sub|mul|div)sf3" "__(eq|ne|lt|le|gt|ge|unord)sf2" "__fix(uns)?sfsi" "__float(un)?sisf")
foreach(file coeffs f32 params)
    set(allowed_${file} ${everywhere} ${floats})
endforeach()
set(allowed_q31 ${everywhere} "__aeabi_llsr" "__lshrdi3") # a shift of 64 bits, where the core has none
set(allowed_q15 ${everywhere})

function(require_allowed file needed)
    foreach(pattern IN LISTS allowed_${file})
        if(needed MATCHES "^${pattern}$")
            return()
        endif()
    endforeach()
    message(SEND_ERROR "${file} needs ${needed}, which is not on its list")
endfunction()

execute_process(COMMAND ${NM} ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
foreach(function epf_f32_step epf_q31_step epf_q15_step)
    if(result OR NOT symbols MATCHES " T ${function}")
        message(FATAL_ERROR "${NM} ${LIBRARY} lists no ${function}: is it the library?")
    endif()
endforeach()

string(REPLACE "\n" ";" symbols "${symbols}")
foreach(symbol IN LISTS symbols)
    if(symbol MATCHES "^([a-z0-9]+)\\.c\\.o(bj)?:$")
        set(file ${CMAKE_MATCH_1})
    elseif(symbol MATCHES " U (.*)$")
        require_allowed("${file}" "${CMAKE_MATCH_1}")
    elseif(symbol MATCHES " [bBdDgGsScC] (.*)$")
        message(SEND_ERROR "the library has data in RAM: ${CMAKE_MATCH_1}")
    endif()
endforeach()
