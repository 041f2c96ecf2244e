#include "filters/cacao-blur/join.frag"
