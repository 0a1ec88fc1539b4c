#pragma once
#include <string>
#include <vector>

#include "bench/draw/contest.hpp"
#include "raster/fast.hpp"
#include "raster/renderer.hpp"

/// What is measured, as values.
namespace twofold::bench {

/// twofold under one preset.
struct OurEntry {
    std::string name;
    Preset preset = Preset::nv17;
    FastOptions options{};
    Pipeline pipeline = Pipeline::fast;
    bool baseline = false;  ///< in a process of its own that is told to use plain x86-64
};

/// A peer. The driver "limit" is the program of that name.
struct PeerEntry {
    std::string name;
    std::string driver;
    std::string drawing{};
    int threads = 1;
};

/// One drawing, who draws it and who is compared with whom.
struct Work {
    std::string title;
    std::string drawing;
    int squares = 0;  ///< n for the sphere of 12 n^2 triangles; 0: a quad
    int size = 1024;  ///< pixels along an edge
    std::vector<OurEntry> ours;
    std::vector<PeerEntry> peers;
    std::vector<Duel> duels;
    int most_rounds = 1000;
};

inline constexpr int sphere_2k = 13, sphere_20k = 41, sphere_200k = 129;

std::vector<Work> all_works();

/// The few that show within a minute whether something has become slow.
std::vector<Work> quick_works();

}  // namespace twofold::bench
