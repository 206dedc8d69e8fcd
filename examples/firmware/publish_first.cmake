# Breaks a copy of the library, to see that torn.c finds it: the index of the operating point is
# published before the point is written.
#
#     cmake -DSOURCES=<folder> -DCOPIES=<folder> -P publish_first.cmake

set(published "\n *[*][(]volatile uint8_t [*][)]&ep->published = aside;")
file(GLOB sources ${SOURCES}/*.c ${SOURCES}/*.h)
foreach(source IN LISTS sources)
    file(READ ${source} text)
    # to where `aside` is known
    string(REGEX REPLACE "( aside = [^;]*;)(.*)(${published})" "\\1\\3\\2" text "${text}")
    get_filename_component(name ${source} NAME)
    file(WRITE ${COPIES}/${name} "${text}")
endforeach()
