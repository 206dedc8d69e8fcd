# Breaks a copy of the library, to see that torn.c finds it: the index of the operating point is
# published before the point is written.
#
#     cmake -DSOURCES=<folder> -DCOPIES=<folder> -P publish_first.cmake

# In the fixed-point variants
set(fixed_order "prepare_point[(]ep->coeffs, v, point_aside[(]ep[)][)];(.*)publish_point[(]ep[)];")
set(fixed_broken "publish_point(ep);\\1prepare_point(ep->coeffs, v, &ep->points[ep->published]);")

# In f32.c: to where `aside` is known
set(f32_order "( aside = [^;]*;)(.*)(\n *[*][(]volatile uint8_t [*][)]&ep->published = aside;)")
set(f32_broken "\\1\\3\\2")

set(found 0)
file(GLOB sources ${SOURCES}/*.c ${SOURCES}/*.h)
foreach(source IN LISTS sources)
    file(READ ${source} text)
    string(REGEX REPLACE "${fixed_order}" "${fixed_broken}" broken "${text}")
    string(REGEX REPLACE "${f32_order}" "${f32_broken}" broken "${broken}")
    if(NOT broken STREQUAL text)
        math(EXPR found "${found} + 1")
    endif()
    get_filename_component(name ${source} NAME)
    file(WRITE ${COPIES}/${name} "${broken}")
endforeach()
if(NOT found EQUAL 3)
    message(FATAL_ERROR "\"${SOURCES}\": expected 3 sources that publish an operating point, found ${found}")
endif()
