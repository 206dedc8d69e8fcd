# The figures of the paper, and the plant that they are made with. Included by CMakeLists.txt.

set(plant "${PROJECT_SOURCE_DIR}/examples/plant")
set(figures "${PROJECT_SOURCE_DIR}/examples/figures")

epf_add_test_as(plant_test figures/plant_test.c
    "${plant}/contact.c" "${plant}/drive.c" "${plant}/encoder.c" "${plant}/friction.c" "${plant}/larger.c"
    "${plant}/noise.c" "${plant}/rules.c" "${plant}/slide.c" "${plant}/trigger.c")
target_include_directories(plant_test PRIVATE "${plant}")

add_executable(claims_test figures/claims_test.c "${figures}/claims.c" "${figures}/errors.c"
    "${figures}/regimes.c" "${figures}/tables.c" "${figures}/track.c")
target_include_directories(claims_test PRIVATE "${figures}")
target_link_libraries(claims_test PRIVATE epf_test_support examples_common examples_plant)
epf_own_warnings(claims_test)
epf_test_flags(claims_test)
epf_run_test(claims_test)
add_test(NAME claims_say_what_fails COMMAND claims_test)
set_tests_properties(claims_say_what_fails PROPERTIES
    PASS_REGULAR_EXPRESSION "\n[|] 9 [|] above its limit [|] 1 N [|] <= 1 [|] FAILS [|]\n")
add_test(NAME claims_say_how_many_fail COMMAND claims_test)
set_tests_properties(claims_say_how_many_fail PROPERTIES
    PASS_REGULAR_EXPRESSION "(^|\n)[^\n]*: 2 of 4 claims do not hold\n")

add_executable(fidelity_test figures/fidelity_test.c "${figures}/fidelity_costs.c")
target_include_directories(fidelity_test PRIVATE "${figures}")
target_link_libraries(fidelity_test PRIVATE epf_test_support examples_common)
epf_own_warnings(fidelity_test)
epf_test_flags(fidelity_test)
epf_run_test(fidelity_test)

# ---- every claim holds, and README.md tells all of them as they are printed ------------------------

set(draws OFF)
if(EPF_GNUPLOT)
    set(draws ON)
endif()
set(check_figures "${CMAKE_COMMAND}"
    "-DPROGRAM=$<TARGET_FILE:epf_figures>"
    "-DREADME=${figures}/README.md"
    "-DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/scratch/figures"
    "-DDRAWS=${draws}")
add_test(NAME figures_hold_as_the_readme_tells
    COMMAND ${check_figures} -P "${CMAKE_CURRENT_SOURCE_DIR}/figures/check.cmake")
set_tests_properties(figures_hold_as_the_readme_tells PROPERTIES LABELS examples TIMEOUT 300)

# Writes what is printed into the tables of README.md
add_custom_target(figures_update
    COMMAND ${check_figures} -DUPDATE=ON -P "${CMAKE_CURRENT_SOURCE_DIR}/figures/check.cmake"
    DEPENDS epf_figures VERBATIM)

# ---- the command line ------------------------------------------------------------------------------

example_test(figures_make_one PROGRAM epf_figures STATUS 0 STDOUT "^[|] 5 .*\n4 claims, 0 fail\n$"
    MADE figure_5.csv ARGS --figure 5 --no-pictures)
example_test(figures_do_without_gnuplot PROGRAM epf_figures STATUS 0 NO_GNUPLOT TRUE
    STDOUT "no picture; try:  gnuplot -c .*4 claims, 0 fail\n$" MADE figure_2.csv ARGS --figure 2)
example_test(figures_help PROGRAM epf_figures STATUS 0 STDOUT "^usage: epf_figures" ARGS --help)
example_test(figures_refuse_a_number PROGRAM epf_figures STATUS 2
    STDERR "^epf_figures: command line: --figure: expected .*, found \"9\"" ARGS --figure 9)
example_test(figures_refuse_no_folder PROGRAM epf_figures STATUS 1
    STDERR "^epf_figures: none/figure_2.csv: cannot write" ARGS --figure 2 --out none)

# ---- files that are in use, streams, full disks, interrupts -----------------------------------------

if(UNIX)
    # A link that stands where a file of figure 5 goes leads to a file that is read, or is written, too
    function(figures_spare name link to)
        example_test(figures_spare_${name} PROGRAM epf_figures STATUS 2 LINK ${link} TO "${to}"
            STDERR "^epf_figures: command line: expected a file of its own for each purpose, found one twice"
            ARGS --figure 5 ${ARGN})
    endfunction()
    figures_spare(their_script figure_5.csv "${figures}/figure_5.gp" --no-pictures)
    figures_spare(the_script_of_another figure_5.csv "${figures}/figure_2.gp" --no-pictures)
    figures_spare(their_style figure_5.csv "${figures}/style.gp" --no-pictures)
    figures_spare(the_baseline figure_5.csv "${PROJECT_SOURCE_DIR}/tests/bench/baseline.csv" --no-pictures)
    figures_spare(their_data figure_5.png figure_5.csv)
    example_test(figures_spare_each_other PROGRAM epf_figures STATUS 2 LINK figure_7.csv TO figure_2.csv
        STDERR "^epf_figures: command line: expected a file of its own for each purpose, found one twice"
        ARGS --no-pictures)

    foreach(signal SIGHUP:1 SIGINT:2 SIGTERM:15)
        string(REGEX MATCH "(.*):(.*)" signal ${signal})
        math(EXPR status "128 + ${CMAKE_MATCH_2}")
        example_test(figures_leave_nothing_behind_after_${CMAKE_MATCH_1}
            PROGRAM interrupt STATUS ${status} ARGS ${CMAKE_MATCH_2} default alone *.tmp
            "$<TARGET_FILE:epf_figures>" --figure fidelity --no-pictures)
    endforeach()
endif()
if(EXISTS /dev/full)
    example_test(figures_refuse_picture_to_stream PROGRAM epf_figures STATUS 2
        LINK figure_5.png TO /dev/full
        STDERR "^epf_figures: command line: expected an ordinary file for the picture, found .*figure_5.png"
        ARGS --figure 5)
endif()
foreach(case IN LISTS picture_cases)
    picture_test(figures ${case} epf_figures figure_5.csv figure_5.png --figure 5)
endforeach()
