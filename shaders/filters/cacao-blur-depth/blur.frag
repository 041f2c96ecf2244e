#include "filters/cacao-blur/blur.frag"
