// Alchemy's estimator (McGuire et al. 2011): max(0, n·v + z β)/(v·v + ε), z negative. Without ε a tap of the pixel itself
// is 0/0: it obscures nothing.
float alchemy_obscurance(vec3 v, vec3 normal, float z, float beta, float epsilon) {
    float height = max(0.0, dot(v, normal) + z * beta);
    return height > 0.0 ? height / (dot(v, v) + epsilon) : 0.0;
}
