# The library aoscore_code answers code_digest() of src/store/code_digest.h.
#
#   aoscore_code_digests(<kind>=<source under src/>…): for each kind of artifact the source of the function that
#   makes it. Its link closure is what GNU ld takes from the rooms' archives for this source's object; the headers
#   are followed from there, and libraries that are loaded (see code_digest.cmake).
function(aoscore_code_digests)
    find_program(AOSCORE_LD NAMES ld.bfd ld REQUIRED)
    get_property(rooms GLOBAL PROPERTY AOSCORE_ROOMS)
    get_property(loaded GLOBAL PROPERTY AOSCORE_LOADED)
    set(entries "")
    foreach(entry IN LISTS ARGN)
        string(REGEX MATCH "^([a-z_]+)=(([a-z]+)/(.+))$" matched ${entry})
        list(APPEND entries
             "${CMAKE_MATCH_1}=${CMAKE_MATCH_2}=${CMAKE_BINARY_DIR}/src/${CMAKE_MATCH_3}/CMakeFiles/aoscore_${CMAKE_MATCH_3}.dir/${CMAKE_MATCH_4}.o")
    endforeach()
    list(TRANSFORM rooms REPLACE "(.+)" "$<TARGET_FILE:aoscore_\\1>" OUTPUT_VARIABLE archives)
    list(TRANSFORM rooms PREPEND aoscore_ OUTPUT_VARIABLE targets)
    set(inputs ${CMAKE_BINARY_DIR}/code/inputs.cmake)
    file(GENERATE OUTPUT ${inputs} CONTENT "set(entries \"${entries}\")\nset(loaded \"${loaded}\")\nset(archives \"${archives}\")\nset(source_dir ${CMAKE_SOURCE_DIR}/src)\nset(object_dir ${CMAKE_BINARY_DIR}/src)\nset(linker ${AOSCORE_LD})\nset(folder ${CMAKE_BINARY_DIR}/code)\n")
    set(output ${CMAKE_BINARY_DIR}/code/code_digest.cpp)
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -D INPUTS=${inputs} -P ${CMAKE_SOURCE_DIR}/cmake/code_digest.cmake
        DEPENDS ${targets} ${inputs} ${CMAKE_SOURCE_DIR}/cmake/code_digest.cmake
        COMMENT "Digesting the code that makes artifacts")
    add_library(aoscore_code OBJECT ${output})
    target_link_libraries(aoscore_code PRIVATE aoscore_options fmt::fmt)
endfunction()
