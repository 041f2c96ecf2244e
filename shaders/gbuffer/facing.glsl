// The picture is drawn upside down, which turns the winding round, as a mirrored mesh does (glTF 2.0, "Instantiation").
uniform mat4 u_view_from_mesh;
bool is_front() { return gl_FrontFacing == (determinant(mat3(u_view_from_mesh)) < 0.0); }
