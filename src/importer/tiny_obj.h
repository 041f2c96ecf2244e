#pragma once

// The one door to tinyobjloader, in the form of double precision: a city far from its origin keeps its
// details.
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>
