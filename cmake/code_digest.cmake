# Writes code_digest.cpp, and for every kind of artifact a list of its sources. INPUTS sets `entries`
# (kind=source=object), `loaded` (source=folder of the library that it loads), `archives`, `source_dir`, `object_dir`, `linker` and `folder`.
cmake_minimum_required(VERSION 3.25)
include(${INPUTS})

# sources_of(room source out): the sources of this room that its archive may mean, relative to source_dir. An archive
# knows base names alone: where two sources share one, both count. Of sources that were compiled together, all count.
function(sources_of room source out)
    if(source MATCHES "^together_")
        file(STRINGS ${object_dir}/${room}/${source} found)
        list(TRANSFORM found REPLACE "^#include \"([^\"]+)\"$" "\\1")
    else()
        file(GLOB_RECURSE found RELATIVE ${source_dir} ${source_dir}/${room}/*.cpp)
        list(FILTER found INCLUDE REGEX "/${source}$")
    endif()
    if(found STREQUAL "")
        message(FATAL_ERROR "no source of ${room}/${source}")
    endif()
    set(${out} ${found} PARENT_SCOPE)
endfunction()

# taken_sources(object out): the sources whose objects the linker takes for this one, relative to source_dir.
function(taken_sources object out)
    execute_process(COMMAND ${linker} -r -o ${folder}/closure.o -Map=${folder}/closure.map ${object}
                            --start-group ${archives} --end-group RESULT_VARIABLE status ERROR_VARIABLE message)
    file(REMOVE ${folder}/closure.o)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${linker} cannot tell the link closure of ${object}: ${message}")
    endif()
    file(STRINGS ${folder}/closure.map lines REGEX "libaoscore_[a-z]+\\.a\\(")
    list(TRANSFORM lines REPLACE ".*libaoscore_([a-z]+)\\.a\\(([^)]*)\\.o\\).*" "\\1/\\2")
    list(REMOVE_DUPLICATES lines)
    set(sources "")
    foreach(line IN LISTS lines)
        string(REGEX MATCH "^([a-z]+)/(.*)$" matched ${line})
        sources_of(${CMAKE_MATCH_1} ${CMAKE_MATCH_2} found)
        list(APPEND sources ${found})
    endforeach()
    set(${out} ${sources} PARENT_SCOPE)
endfunction()

# add_headers(list): adds the headers of our own that these include, and what those include.
function(add_headers list)
    set(all ${${list}})
    set(rest ${all})
    while(NOT rest STREQUAL "")
        list(POP_FRONT rest file)
        file(STRINGS ${source_dir}/${file} includes REGEX "^#include \"")
        list(TRANSFORM includes REPLACE "^#include \"([^\"]+)\".*" "\\1")
        foreach(header IN LISTS includes)
            if(NOT header IN_LIST all AND EXISTS ${source_dir}/${header})
                list(APPEND all ${header})
                list(APPEND rest ${header})
            endif()
        endforeach()
    endwhile()
    set(${list} ${all} PARENT_SCOPE)
endfunction()

# add_loaded(list): adds the sources of the libraries that these load.
function(add_loaded list)
    set(all ${${list}})
    foreach(pair IN LISTS loaded)
        string(REGEX MATCH "^(.+)=(.+)$" matched ${pair})
        if(CMAKE_MATCH_1 IN_LIST all)
            file(GLOB_RECURSE sources RELATIVE ${source_dir} ${source_dir}/${CMAKE_MATCH_2}/*.cpp)
            list(APPEND all ${sources})
        endif()
    endforeach()
    set(${list} ${all} PARENT_SCOPE)
endfunction()

set(rows "")
foreach(entry IN LISTS entries)
    string(REPLACE "=" ";" entry ${entry})
    list(GET entry 0 kind)
    list(GET entry 1 source)
    list(GET entry 2 object)
    taken_sources(${object} files)
    list(APPEND files ${source})
    add_loaded(files)
    add_headers(files)
    list(REMOVE_DUPLICATES files)
    list(SORT files)
    set(all "")
    foreach(file IN LISTS files)
        file(SHA256 ${source_dir}/${file} digest)
        string(APPEND all "${file} ${digest}\n")
    endforeach()
    string(SHA256 digest "${all}")
    string(SUBSTRING ${digest} 0 32 digest)
    string(REPLACE ";" "\n" text "${files}")
    file(WRITE ${folder}/${kind}.txt "${text}\n")
    string(APPEND rows "    {\"${kind}\", \"${digest}\"},\n")
endforeach()

file(CONFIGURE OUTPUT ${folder}/code_digest.cpp CONTENT [[
#include "store/code_digest.h"

#include "core/error.h"

#include <string>
#include <utility>

namespace aoscore {

std::string_view code_digest(std::string_view kind) {
    static constexpr std::pair<std::string_view, std::string_view> kDigests[] = {
@rows@    };
    for (const auto& [known, digest] : kDigests) {
        if (known == kind) return digest;
    }
    throw internal_error("no code makes such artifacts", std::string(kind));
}

}  // namespace aoscore
]] @ONLY)
