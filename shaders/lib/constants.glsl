const float kPi = 3.14159265358979;
const float kTwoPi = 6.28318530717959;
const float kHalfPi = 1.5707963267949;
