# One static library per room. Sources are found by pattern (checked again at every build), so that adding a
# file touches one place.
#
#   aoscore_room(<name> ROOMS <rooms it may include>… LIBRARIES <external targets>…)
add_library(aoscore_options INTERFACE)
target_include_directories(aoscore_options INTERFACE ${CMAKE_SOURCE_DIR}/src)
target_compile_options(aoscore_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                       -Wold-style-cast -Wcast-qual -Woverloaded-virtual -Wextra-semi
                       $<$<BOOL:${AOSCORE_WERROR}>:-Werror>)
# GCC 12 sees overlaps in std::string's operator+ that are not there (its bug 105651).
target_compile_options(aoscore_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# GCC 12's SLP vectoriser drops the rounding of (double)(float)x on neighbouring components; tests/core shows it.
target_compile_options(aoscore_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
# Contracting a*b+c into one rounding differs between machines; results must not.
target_compile_options(aoscore_options INTERFACE -ffp-contract=off)
if(AOSCORE_SANITIZE)
    target_compile_options(aoscore_options INTERFACE -fsanitize=${AOSCORE_SANITIZE} -fno-omit-frame-pointer
                           -fno-sanitize-recover=undefined
                           # GCC 12 sees uninitialised members in std::function once it is instrumented.
                           -Wno-maybe-uninitialized)
    target_link_options(aoscore_options INTERFACE -fsanitize=${AOSCORE_SANITIZE})
endif()

function(aoscore_room name)
    cmake_parse_arguments(ROOM "" "" "ROOMS;LIBRARIES" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_library(aoscore_${name} STATIC ${sources})
    set_property(GLOBAL APPEND PROPERTY AOSCORE_ROOMS ${name})
    list(TRANSFORM ROOM_ROOMS PREPEND aoscore_)
    target_link_libraries(aoscore_${name} PUBLIC aoscore_options ${ROOM_ROOMS} ${ROOM_LIBRARIES})
endfunction()

# aoscore_library(<name> LOADED_BY <source of a room> ROOMS … LIBRARIES …): all sources of this folder in aoscore-<name>.so
# beside the programs, which the source named loads when it is first needed. Where a digest of code counts that source, it
# counts these, too. The rooms must come before it.
function(aoscore_library name)
    cmake_parse_arguments(LIBRARY "" "LOADED_BY" "ROOMS;LIBRARIES" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_library(aoscore_${name} MODULE ${sources})
    set_target_properties(aoscore_${name} PROPERTIES PREFIX "" OUTPUT_NAME aoscore-${name} CXX_VISIBILITY_PRESET hidden
                          LIBRARY_OUTPUT_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
    set_property(GLOBAL APPEND PROPERTY AOSCORE_LIBRARIES aoscore_${name})
    set_property(GLOBAL APPEND PROPERTY AOSCORE_LOADED "${LIBRARY_LOADED_BY}=${name}")
    list(TRANSFORM LIBRARY_ROOMS PREPEND aoscore_)
    set_target_properties(${LIBRARY_ROOMS} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(aoscore_${name} PRIVATE aoscore_options ${LIBRARY_ROOMS} ${LIBRARY_LIBRARIES})
endfunction()

# aoscore_compile_together(target folder… [APART file…]): gives the compiler the sources of each folder (. for the target's
# own) twelve at a time, so that it reads headers and fills in templates once for the twelve. That is most of what a cold
# build does. A digest of code then counts all twelve (code_digest.cmake): name folders that artifacts use as a whole or not
# at all, keep APART the files of which that is not true and those that aoscore_code_digests names, and gather files that
# the same artifacts use by aoscore_compile_group. code/ in the build folder lists the sources of each kind. Names in a
# unit's anonymous namespaces must differ. CMake's own unity builds write the source tree's path into what is compiled, and
# no compiler cache could serve two trees.
function(aoscore_compile_together target)
    if(NOT AOSCORE_TOGETHER)
        return()
    endif()
    cmake_parse_arguments(TOGETHER "" "" "APART" ${ARGN})
    list(TRANSFORM TOGETHER_APART PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    foreach(folder IN LISTS TOGETHER_UNPARSED_ARGUMENTS)
        cmake_path(ABSOLUTE_PATH folder NORMALIZE OUTPUT_VARIABLE path)
        string(REGEX REPLACE "/$" "" path ${path})
        file(GLOB sources ${path}/*.cpp)
        list(REMOVE_ITEM sources ${TOGETHER_APART})
        cmake_path(GET path FILENAME name)
        aoscore_compile_group(${target} ${name} ${sources})
    endforeach()
endfunction()

# aoscore_compile_group(target name file…): does the same for these files of one folder or several; `name` is that of the
# units.
function(aoscore_compile_group target name)
    if(NOT AOSCORE_TOGETHER)
        return()
    endif()
    set(sources ${ARGN})
    list(TRANSFORM sources REPLACE "^([^/].*)$" "${CMAKE_CURRENT_SOURCE_DIR}/\\1")
    get_target_property(all ${target} SOURCES)
    list(REMOVE_ITEM all ${sources})
    list(TRANSFORM sources REPLACE "^${CMAKE_SOURCE_DIR}/src/(.+)$" "#include \"\\1\"\n")
    while(NOT sources STREQUAL "")
        list(LENGTH sources count)
        list(SUBLIST sources 0 12 twelve)
        list(REMOVE_ITEM sources ${twelve})
        set(unit ${CMAKE_CURRENT_BINARY_DIR}/together_${name}_${count}.cpp)
        string(JOIN "" content ${twelve})
        file(CONFIGURE OUTPUT ${unit} CONTENT "${content}" @ONLY)
        list(APPEND all ${unit})
    endwhile()
    set_target_properties(${target} PROPERTIES SOURCES "${all}")
endfunction()

# aoscore_compile_quickly(target): for what nobody waits for while it runs, but everybody while it is compiled.
function(aoscore_compile_quickly target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# aoscore_link_code(target room…): gives a program that holds the store the digests of the code that fills it. They
# are an object of the program's own, as they are computed from the rooms' archives.
function(aoscore_link_code target)
    set(rooms ${ARGN})
    while(NOT rooms STREQUAL "")
        list(POP_FRONT rooms room)
        if(room STREQUAL aoscore_store)
            target_link_libraries(${target} PRIVATE aoscore_code)
            return()
        endif()
        get_target_property(used ${room} LINK_LIBRARIES)
        list(FILTER used INCLUDE REGEX "^aoscore_[a-z]+$")
        list(REMOVE_ITEM used aoscore_options aoscore_gltf)
        list(APPEND rooms ${used})
        list(REMOVE_DUPLICATES rooms)
    endwhile()
endfunction()

# Has what a program may load built with it.
function(aoscore_build_libraries target)
    get_property(libraries GLOBAL PROPERTY AOSCORE_LIBRARIES)
    if(libraries)
        add_dependencies(${target} ${libraries})
    endif()
endfunction()

#   aoscore_program(<name> ROOMS <rooms it may include>… LIBRARIES <external targets>…): all sources of this folder in one
#   program.
function(aoscore_program name)
    cmake_parse_arguments(PROGRAM "" "" "ROOMS;LIBRARIES" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_executable(${name} ${sources})
    list(TRANSFORM PROGRAM_ROOMS PREPEND aoscore_)
    target_link_libraries(${name} PRIVATE aoscore_options ${PROGRAM_ROOMS} ${PROGRAM_LIBRARIES})
    aoscore_link_code(${name} ${PROGRAM_ROOMS})
    aoscore_build_libraries(${name})
endfunction()

#   aoscore_test(<name> ROOMS <rooms under test>… LIBRARIES <external targets>…): all of tests/<name>/*.cpp in
#   one program; each of its cases is a test of its own, in a folder of its own.
function(aoscore_test name)
    cmake_parse_arguments(TEST "" "" "ROOMS;LIBRARIES" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_executable(test_${name} ${sources})
    list(TRANSFORM TEST_ROOMS PREPEND aoscore_)
    target_link_libraries(test_${name} PRIVATE aoscore_test_support ${TEST_ROOMS} ${TEST_LIBRARIES}
                          GTest::gtest_main GTest::gmock)
    aoscore_link_code(test_${name} ${TEST_ROOMS})
    aoscore_build_libraries(test_${name})
    aoscore_compile_quickly(test_${name})
    gtest_discover_tests(test_${name} TEST_PREFIX "${name}: " DISCOVERY_MODE PRE_TEST
                         DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600 LABELS ${name})
endfunction()
