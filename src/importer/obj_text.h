#pragma once

#include <string>
#include <vector>

namespace aoscore::importer {

/// The statements of an OBJ file made fit for tinyobjloader.
struct ObjText {
    std::string statements;              ///< one a line: continued lines joined, without mtllib
    std::vector<std::string> libraries;  ///< what follows each mtllib, in their order
    std::size_t curves = 0;              ///< curves and surfaces of free form, which are no polygons
};

/// Takes the text of an OBJ file. tinyobjloader would read what is no number as 0, and does not know lines
/// that go on behind a backslash. Coordinates and indices that are no numbers throw file_error with their
/// line, as does UTF-16.
ObjText prepare_obj(std::string text);

}  // namespace aoscore::importer
