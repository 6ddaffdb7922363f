#pragma once
// The one door to toml++: declarations only. What it is made of is compiled once, in toml.cpp (two files that
// each carried the whole parser took 20 s of every build).
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>
