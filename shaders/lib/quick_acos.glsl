// Arc cosine as games compute it: a line times the root of 1 - |x| (Lagarde, Inverse trigonometric functions GPU
// optimization for AMD GCN architecture, 2014), that root by halving the exponent of its float (Drobot, Low Level
// Optimizations for GCN, 2014). The angle is off by up to .06.
float halved_exponent_root(float x) { return intBitsToFloat(0x1fbd1df5 + (floatBitsToInt(x) >> 1)); }

float quick_acos(float x) {
    float size = abs(x);
    float angle = (1.57079632679 - 0.156583 * size) * halved_exponent_root(max(1.0 - size, 0.0));
    return x < 0.0 ? 3.14159265359 - angle : angle;
}
