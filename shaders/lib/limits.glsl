// Into [0,1], leaving NaN as it is: it must be seen and counted, not turned into a plausible number.
float limited_visibility(float v) { return v < 0.0 ? 0.0 : (v > 1.0 ? 1.0 : v); }
