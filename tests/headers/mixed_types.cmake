# A contact or coefficients of the other fixed-point variant do not compile: in C with
# -Werror=incompatible-pointer-types, in C++ without any flag.

include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)

set(strict_C -std=c99 -x c -fsyntax-only -Werror=incompatible-pointer-types)
set(strict_CXX -std=c++11 -x c++ -fsyntax-only)
set(reason_C "incompatible pointer type|-Wincompatible-pointer-types")
set(reason_CXX "cannot convert|no matching function")

function(takes_only variant other call)
    compile(${CMAKE_CURRENT_LIST_DIR}/mixed_types.h -DTYPE=${variant} "-DCALL=${call}")
    if(result OR message)
        message(SEND_ERROR "${call} of ${variant} should compile:\n${message}")
    endif()
    compile(${CMAKE_CURRENT_LIST_DIR}/mixed_types.h -DTYPE=${other} "-DCALL=${call}")
    if(NOT result OR NOT message MATCHES "error:" OR NOT message MATCHES "${reason_${LANGUAGE}}")
        message(SEND_ERROR "${call} of ${other} should be refused for its type:\n${message}")
    endif()
endfunction()

foreach(variants "q31;q15" "q15;q31")
    list(GET variants 0 variant)
    foreach(call "coeffs_init(coeffs, params, lsb)" "fss(coeffs, 1)" "alpha(coeffs, 1, 1)"
            "init(ep, ep->coeffs)" "reset(ep, 1)" "set_velocity(ep, 1)" "advance(ep, 1)"
            "update(ep, 1, 1)" "force(ep, 1)" "step(ep, 1, 1, 1)" "output(ep)" "z(ep)")
        takes_only(${variants} "(void)epf_${variant}_${call}")
    endforeach()
    takes_only(${variants} "epf_${variant}_t right\; epf_${variant}_init(&right, coeffs)")
endforeach()
