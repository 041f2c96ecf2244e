#pragma once

namespace aoscore {

/// How long work takes by its size: a fixed time and a time for each unit, fitted to what was measured
/// (linear least squares, of which each observation halves the weight of those before). Before the first two
/// are told apart by sizes, a guess of both holds them: small pictures, whose time is mostly fixed, say
/// little about large ones.
struct Pace {
    double fixed_s = 0, unit_s = 0;  ///< the guess
    // Sums over observations: of weights, sizes, times and their products.
    double count = 0, sizes = 0, squares = 0, seconds = 0, products = 0;

    void observe(double size, double took_s);
    /// At least 0.
    double predicted_s(double size) const;
};

}  // namespace aoscore
