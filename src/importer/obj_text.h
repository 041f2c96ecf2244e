#pragma once

#include <string>
#include <vector>

namespace aoscore::importer {

/// The statements of an OBJ file made fit for tinyobjloader.
struct ObjText {
    std::string statements;              ///< one statement a line: continued lines joined, without mtllib
    std::vector<std::string> libraries;  ///< the words after each mtllib, in their order
    std::size_t curves = 0;              ///< curves and surfaces of free form, which are no polygons
};

/// Prepares the text of an OBJ file. tinyobjloader would read a word that is no number as 0, and does not
/// know lines that a backslash continues. Coordinates and indices that are no numbers throw file_error with
/// their line, as does UTF-16.
ObjText prepare_obj(std::string text);

}  // namespace aoscore::importer
