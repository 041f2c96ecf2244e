// Edges on a pixel's four sides, as in ASSAO and CACAO (Strugar 2016; AMD 2020): for left, right, above, below, how far no
// edge lies between, 1 none and 0 an edge.
vec2 side_offset(int i) {
    float along = (i & 1) == 0 ? -1.0 : 1.0;
    return i < 2 ? vec2(along, 0.0) : vec2(0.0, along);
}

// Of the neighbours' depths. A slope is no edge: what the other side's step is the opposite of does not count.
vec4 open_by_depth(vec4 depths, float depth) {
    vec4 step = depths - depth, level = min(abs(step), abs(step + step.yxwz));
    return clamp(1.3 - level / (0.04 * depth), 0.0, 1.0);
}

float open_by_normal(vec3 a, vec3 b) { return clamp(dot(a, b) + 0.5, 0.0, 1.0); }
