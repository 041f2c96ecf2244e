// The drawn triangle, told from all others by instance and place in its mesh.
uniform int u_instance;
uniform int u_first_triangle;
uint triangle_id() { return uint(u_first_triangle + gl_PrimitiveID) + uint(u_instance) * 2246822519u; }
