# Compiles constants of good and bad parameters: the first error of a bad one names its cause.

include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)

set(rest "EPF_STRIBECK_LORENTZIAN,EPF_UPDATE_SATURATED")
set(MOST_LINES 40) # of gcc's whole message, where no quotient of the other parameters leaves its range

function(accepts coeffs)
    compile_constant("${coeffs}")
    if(result OR message)
        message(SEND_ERROR "${coeffs} should compile without a word:\n${message}")
    endif()
endfunction()

# refuses(CAUSE COEFFS [BRIEF])
function(refuses cause coeffs)
    compile_constant("${coeffs}")
    string(REGEX MATCH "[^\n]*error:[^\n]*" first "${message}")
    if(NOT result OR NOT first MATCHES "${cause}")
        message(SEND_ERROR "${coeffs} should be refused as ${cause}, found:\n${message}")
    endif()
    string(REGEX MATCHALL "\n" lines "${message}")
    list(LENGTH lines lines)
    if("${ARGN}" STREQUAL BRIEF AND IS_GNU AND lines GREATER MOST_LINES)
        message(SEND_ERROR "${coeffs}: ${lines} lines, more than ${MOST_LINES}:\n${message}")
    endif()
endfunction()

# all_parameters(NAME END): those of epf_params_check, where END are the weights of the signals, if any
function(all_parameters name end)
    # sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck, update
    accepts("${name}(1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,${rest}${end})")
    accepts("${name}(1e5,63,0,1,1.1,1e-5,8e-6,EPF_STRIBECK_GAUSSIAN,EPF_UPDATE_SATURATED${end})")
    refuses(sigma_0_must_be_positive
        "${name}(0.0f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,${rest}${end})")
    refuses(sigma_1_must_not_be_negative
        "${name}(1e5f,-1.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,${rest}${end})")
    refuses(sigma_2_must_not_be_negative
        "${name}(1e5f,63.0f,-1.0f,1.0f,1.1f,1e-5f,8e-6f,${rest}${end})")
    refuses(f_c_must_be_positive
        "${name}(1e5f,63.0f,0.0f,-1.0f,1.1f,1e-5f,8e-6f,${rest}${end})" BRIEF)
    refuses(f_max_must_be_at_least_f_c
        "${name}(1e5f,63.0f,0.0f,1.0f,0.9f,1e-5f,8e-6f,${rest}${end})" BRIEF)
    refuses(v_s_must_be_positive
        "${name}(1e5f,63.0f,0.0f,1.0f,1.1f,0.0f,8e-6f,${rest}${end})")
    refuses(z_ba_must_be_positive_and_below_z_c
        "${name}(1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,0.0f,${rest}${end})" BRIEF)
    refuses(z_ba_must_be_positive_and_below_z_c
        "${name}(1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,1.1e-5f,${rest}${end})" BRIEF)
    refuses(the_parameters_leave_the_range_of_float
        "${name}(1e5f,63.0f,0.0f,1.0f,1e38f,1e-5f,8e-6f,${rest}${end})")
    refuses(stribeck_must_be_a_form_of_this_build
        "${name}(1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,7,EPF_UPDATE_SATURATED${end})" BRIEF)
    refuses(update_must_be_a_rule_of_this_build
        "${name}(1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,EPF_STRIBECK_GAUSSIAN,1${end})" BRIEF)
endfunction()

all_parameters(EPF_F32_COEFFS "")
set(slide "1e5f,63.0f,0.0f,1.0f,1.1f,1e-5f,8e-6f,${rest}")
foreach(name EPF_Q31_COEFFS EPF_Q15_COEFFS)
    all_parameters(${name} ",1e-7f,1e-7f,1e-4f,1e-5f")
    # lsb_x, lsb_v, lsb_f, lsb_t
    foreach(lsb_x 0.0f 9e-6f 1e-15f)
        refuses(lsb_x_must_be_at_most_z_ba "${name}(${slide},${lsb_x},1e-7f,1e-4f,1e-5f)")
    endforeach()
    foreach(lsb_v -1e-7f 1e-16f 1e4f)
        refuses(lsb_v_must_be_positive "${name}(${slide},1e-7f,${lsb_v},1e-4f,1e-5f)")
    endforeach()
    foreach(lsb_f 2.0f 1e-10f)
        refuses(lsb_f_must_be_at_most_f_max "${name}(${slide},1e-7f,1e-7f,${lsb_f},1e-5f)")
    endforeach()
    foreach(lsb_t 0.0f 1e-12f)
        refuses(lsb_t_must_be_positive "${name}(${slide},1e-7f,1e-7f,1e-4f,${lsb_t})")
    endforeach()
endforeach()
accepts("EPF_Q31_COEFFS(${slide},1e-7f,1e-7f,1e-5f,1e-5f)")
refuses(lsb_f_must_be_at_most_f_max "EPF_Q15_COEFFS(${slide},1e-7f,1e-7f,1e-5f,1e-5f)")
