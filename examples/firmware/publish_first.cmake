# Breaks a copy of the library, to see that torn.c finds it: the index of the operating point is
# published before the point is written.
#
#     cmake -DSOURCES=<folder> -DCOPIES=<folder> -P publish_first.cmake

set(published "\n *[*][(]volatile uint8_t [*][)]&ep->published = aside;")
set(found FALSE)
file(GLOB sources ${SOURCES}/*.c ${SOURCES}/*.h)
foreach(source IN LISTS sources)
    file(READ ${source} text)
    # to where `aside` is known
    string(REGEX REPLACE "( aside = [^;]*;)(.*)(${published})" "\\1\\3\\2" broken "${text}")
    if(NOT broken STREQUAL text)
        set(found TRUE)
    endif()
    get_filename_component(name ${source} NAME)
    file(WRITE ${COPIES}/${name} "${broken}")
endforeach()
if(NOT found)
    message(FATAL_ERROR "no source in \"${SOURCES}\" publishes an operating point as expected here")
endif()
