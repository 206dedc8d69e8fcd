# Builds user.c against the library in one WAY, and runs it.

file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
file(COPY ${USER} DESTINATION ${SCRATCH})

function(run)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${SCRATCH}
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(result)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "${command}\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

# install_epf(BUILD CONFIG)
function(install_epf build config)
    run(${CMAKE_COMMAND} --install ${build} --prefix ${SCRATCH}/installed --config ${config})
    # the tree must be whole wherever it is moved to
    file(RENAME ${SCRATCH}/installed ${SCRATCH}/moved)
endfunction()

# A project of the user's around the lines that bring the library in
function(build_project lines)
    file(WRITE ${SCRATCH}/CMakeLists.txt "cmake_minimum_required(VERSION 3.16)
project(user C)
${lines}
add_executable(user user.c)
target_link_libraries(user PRIVATE epf::epf)
")
    run(${CMAKE_COMMAND} -S . -B build -G ${GENERATOR} -DCMAKE_C_COMPILER=${COMPILER}
        -DCMAKE_BUILD_TYPE=Release ${ARGN})
    run(${CMAKE_COMMAND} --build build)
    run(${SCRATCH}/build/user)
endfunction()

# As a part of another project epf must bring nothing but its library
set(nothing_else "
if(TARGET epf_under_test OR TARGET epf_replay OR CMAKE_C_FLAGS OR CMAKE_C_STANDARD OR BUILD_TESTING)
    message(FATAL_ERROR \"epf changed the project around it\")
endif()
get_property(options DIRECTORY PROPERTY COMPILE_OPTIONS)
get_target_property(usage epf INTERFACE_COMPILE_OPTIONS)
get_target_property(own epf COMPILE_OPTIONS)
if(options OR usage OR own MATCHES \"-W\")
    message(FATAL_ERROR \"epf passes on flags: \${options} \${usage} \${own}\")
endif()")

# The same user's program with the flags of pkg-config, where that is there
function(run_with_pkg_config)
    find_program(PKG_CONFIG NAMES pkg-config pkgconf)
    if(PKG_CONFIG)
        file(GLOB_RECURSE pc ${SCRATCH}/moved/epf.pc)
        get_filename_component(folder ${pc} DIRECTORY)
        set(ENV{PKG_CONFIG_PATH} ${folder})
        run(${PKG_CONFIG} --cflags --libs "epf = ${VERSION}")
        separate_arguments(flags UNIX_COMMAND "${output}")
        run(${COMPILER} user.c -o user ${flags})
        run(${SCRATCH}/user)
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

if(WAY STREQUAL "find_package")
    install_epf(${EPF_BINARY_DIR} ${CONFIG})
    build_project("find_package(epf ${VERSION} CONFIG REQUIRED)"
        -DCMAKE_PREFIX_PATH=${SCRATCH}/moved)
elseif(WAY STREQUAL "add_subdirectory")
    build_project("add_subdirectory(\"${EPF_SOURCE_DIR}\" epf)${nothing_else}")
elseif(WAY STREQUAL "fetch_content")
    build_project("include(FetchContent)
FetchContent_Declare(epf SOURCE_DIR \"${EPF_SOURCE_DIR}\")
FetchContent_MakeAvailable(epf)${nothing_else}")
elseif(WAY STREQUAL "one_form_and_rule")
    # what the library was built with comes with it: otherwise the user's program would not link
    run(${CMAKE_COMMAND} -S ${EPF_SOURCE_DIR} -B epf -G ${GENERATOR} -DCMAKE_C_COMPILER=${COMPILER}
        -DCMAKE_BUILD_TYPE=Release
        -DEPF_STRIBECK_ONLY=EPF_STRIBECK_LORENTZIAN -DEPF_UPDATE_ONLY=EPF_UPDATE_SATURATED)
    run(${CMAKE_COMMAND} --build epf --config Release)
    install_epf(epf Release)
    build_project("find_package(epf ${VERSION} CONFIG REQUIRED)"
        -DCMAKE_PREFIX_PATH=${SCRATCH}/moved)
    run_with_pkg_config()
elseif(WAY STREQUAL "copied_files")
    file(COPY ${EPF_SOURCE_DIR}/include/epf ${EPF_SOURCE_DIR}/src DESTINATION ${SCRATCH})
    file(GLOB sources ${SCRATCH}/src/*.c)
    run(${COMPILER} -I. user.c ${sources} -o user)
    run(${SCRATCH}/user)
elseif(WAY STREQUAL "pkg_config")
    install_epf(${EPF_BINARY_DIR} ${CONFIG})
    run_with_pkg_config()
else()
    message(FATAL_ERROR "no such way: ${WAY}")
endif()
message(STATUS "${output}")
