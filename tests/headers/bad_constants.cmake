# Compiles constants.c with good and bad parameters: the bad ones must be refused as "not constant".

set(rest "EPF_STRIBECK_LORENTZIAN,EPF_UPDATE_SATURATED")

function(compile coeffs)
    string(REGEX REPLACE "^EPF_(.*)_COEFFS.*" "epf_\\1_coeffs_t" type "${coeffs}")
    string(TOLOWER "${type}" type)
    execute_process(
        COMMAND ${COMPILER} -std=c99 -Wall -Wextra -Wpedantic -fsyntax-only -I${INCLUDE_DIR}
            "-DTYPE=${type}" "-DCOEFFS=${coeffs}" ${SOURCE}
        RESULT_VARIABLE result ERROR_VARIABLE message)
    set(result ${result} PARENT_SCOPE)
    set(message "${message}" PARENT_SCOPE)
endfunction()

function(accepts coeffs)
    compile("${coeffs}")
    if(result OR message)
        message(FATAL_ERROR "${coeffs} should compile without a word:\n${message}")
    endif()
endfunction()

function(refuses coeffs)
    compile("${coeffs}")
    if(NOT result OR NOT message MATCHES "error: initializer element is not")
        message(FATAL_ERROR "${coeffs} should be refused as not constant:\n${message}")
    endif()
endfunction()

# sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck, update
accepts("EPF_F32_COEFFS(1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,${rest})")
accepts("EPF_F32_COEFFS(1e5,63,0,1,1.1,1e-5,8e-6,EPF_STRIBECK_GAUSSIAN,EPF_UPDATE_SATURATED)")
refuses("EPF_F32_COEFFS(0.0f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,${rest})")
refuses("EPF_F32_COEFFS(1e5f,-1.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,${rest})")
refuses("EPF_F32_COEFFS(1e5f,63.0f,-1.0f,1.0f,1.1f,1e-5f,8e-6f,${rest})")
refuses("EPF_F32_COEFFS(1e5f,63.0f,0.0f,-1.0f,1.1f,1e-5f,8e-6f,${rest})")
refuses("EPF_F32_COEFFS(1e5f,63.0f,0.0f,1.0f,0.9f,1e-5f,8e-6f,${rest})")
refuses("EPF_F32_COEFFS(1e5f,63.0f,0.0f,1.0f,1.1f,0.0f,8e-6f,${rest})")
refuses("EPF_F32_COEFFS(1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,0.0f,${rest})")
refuses("EPF_F32_COEFFS(1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,1.1e-5f,${rest})")
refuses("EPF_F32_COEFFS(1e5f,63.0f,0.0f,1.0f,1e38f,1e-5f,8e-6f,${rest})")
refuses("EPF_F32_COEFFS(1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,7,EPF_UPDATE_SATURATED)")
refuses("EPF_F32_COEFFS(1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,EPF_STRIBECK_GAUSSIAN,1)")

# the same, then lsb_x, lsb_v, lsb_f, lsb_t
set(slide "1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,${rest}")
foreach(variant Q31 Q15)
    accepts("EPF_${variant}_COEFFS(${slide},1e-7f,1e-7f,1e-4f,1e-5f)")
    refuses("EPF_${variant}_COEFFS(1e5f,63.0f,0.0f,1.0f,0.9f,1e-5f,8e-6f,${rest},1e-7f,1e-7f,1e-4f,1e-5f)")
    refuses("EPF_${variant}_COEFFS(${slide},0.0f,1e-7f,1e-4f,1e-5f)")
    refuses("EPF_${variant}_COEFFS(${slide},9e-6f,1e-7f,1e-4f,1e-5f)")
    refuses("EPF_${variant}_COEFFS(${slide},1e-15f,1e-7f,1e-4f,1e-5f)")
    refuses("EPF_${variant}_COEFFS(${slide},1e-7f,-1e-7f,1e-4f,1e-5f)")
    refuses("EPF_${variant}_COEFFS(${slide},1e-7f,1e-7f,2.0f,1e-5f)")
    refuses("EPF_${variant}_COEFFS(${slide},1e-7f,1e-7f,1e-10f,1e-5f)")
    refuses("EPF_${variant}_COEFFS(${slide},1e-7f,1e-7f,1e-4f,0.0f)")
endforeach()
accepts("EPF_Q31_COEFFS(${slide},1e-7f,1e-7f,1e-5f,1e-5f)")
refuses("EPF_Q15_COEFFS(${slide},1e-7f,1e-7f,1e-5f,1e-5f)")
