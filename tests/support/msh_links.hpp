#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace pcvt::testing {

/// A node of an MSH file and the node of which a link makes it the image.
struct MshLink {
    int slave;
    int master;
};

/// The links in $Periodic, by the dimension of their entities.
inline std::map<int, std::vector<MshLink>> msh_links(const std::string& msh) {
    std::map<int, std::vector<MshLink>> links;
    const std::size_t begin = msh.find("$Periodic\n");
    if (begin == std::string::npos) return links;
    std::istringstream text(msh.substr(begin));
    std::string word;
    int n_entities = 0;
    text >> word >> n_entities;
    for (int e = 0; e < n_entities; ++e) {
        int dimension = 0;
        int n_numbers = 0;
        int n_links = 0;
        text >> dimension >> word >> word >> n_numbers;
        for (int k = 0; k < n_numbers; ++k) text >> word;
        text >> n_links;
        for (int k = 0; k < n_links; ++k) {
            MshLink link{};
            text >> link.slave >> link.master;
            links[dimension].push_back(link);
        }
    }
    return links;
}

inline int n_msh_nodes(const std::string& msh) {
    std::istringstream text(msh.substr(msh.find("$Nodes\n")));
    std::string word;
    int n = 0;
    text >> word >> word >> n;
    return n;
}

/// The number of nodes that links leave, where all of them count: by brute force.
inline int n_united(int n_nodes, const std::vector<MshLink>& links) {
    std::vector<int> orbit(static_cast<std::size_t>(n_nodes) + 1);
    std::iota(orbit.begin(), orbit.end(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [slave, master] : links) {
            const int least = std::min(orbit[slave], orbit[master]);
            changed = changed || orbit[slave] != least || orbit[master] != least;
            orbit[slave] = least;
            orbit[master] = least;
        }
    }
    return static_cast<int>(std::set<int>(orbit.begin() + 1, orbit.end()).size());
}

/// The number of nodes that links leave to a program that keeps one link a node, the last one in a
/// list, and follows it from node to node; -1 if links run in a circle.
inline int n_left(int n_nodes, const std::vector<MshLink>& links) {
    std::map<int, int> master_of;
    for (const auto& [slave, master] : links) master_of[slave] = master;
    for (const auto& [first, second] : master_of) {
        int v = first;
        for (int n_steps = 0; master_of.count(v) > 0; ++n_steps) {
            if (n_steps > n_nodes) return -1;
            v = master_of.at(v);
        }
    }
    return n_nodes - static_cast<int>(master_of.size());
}

/// Expects that each program finds the orbits of an MSH file: one that unites all links, one that
/// keeps the first, the last or any link of each node, and one that links only curves (in space,
/// surfaces).
inline void expect_orbits(const std::string& msh, int n_orbits) {
    const int n = n_msh_nodes(msh);
    std::vector<MshLink> all;
    const auto by_dimension = msh_links(msh);
    for (const auto& [dimension, links] : by_dimension) {
        all.insert(all.end(), links.begin(), links.end());
    }
    EXPECT_EQ(n_united(n, all), n_orbits);
    EXPECT_EQ(n_left(n, all), n_orbits);
    EXPECT_EQ(n_left(n, {all.rbegin(), all.rend()}), n_orbits);
    std::mt19937 random(1);
    for (int k = 0; k < 5; ++k) {
        std::shuffle(all.begin(), all.end(), random);
        EXPECT_EQ(n_left(n, all), n_orbits);
    }
    if (by_dimension.empty()) return;
    EXPECT_EQ(n_left(n, by_dimension.rbegin()->second), n_orbits) << "of the largest dimension";
}

}  // namespace pcvt::testing
