#pragma once

#include <random>
#include <string>

/// Spoils a file in one of the ways in which files get spoiled.
std::string mutate(std::string bytes, std::mt19937& random);
