/*  couplingStability: where water and solids in one scene fail, found by bisection, beside theory.

        couplingStability [-csv FILE] [density|step|bonds|leak]...

    The scene is stirredBlock.hpp; see experiments.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "experiments.hpp"

#include <cstdio>
#include <cstring>
#include <exception>
#include <map>

int main(int argc, char** argv)
{
    using namespace riprap;
    const std::map<std::string, void (*)(CouplingRows&)> tests {{"density", density}, {"step", step}, {"bonds", bonds}, {"leak", leak}};
    std::string csv;
    std::vector<std::string> chosen;
    for (int i = 1; i < argc; ++i)
    {
        if (!std::strcmp(argv[i], "-csv") && i + 1 < argc) csv = argv[++i];
        else if (tests.count(argv[i])) chosen.push_back(argv[i]);
        else
        {
            std::fprintf(stderr, "couplingStability: '%s' is none of -csv FILE, density, step, bonds, leak\n", argv[i]);
            return 2;
        }
    }
    if (chosen.empty()) chosen = {"density", "step", "bonds", "leak"};
    try
    {
        CouplingRows rows(csv);
        for (const std::string& name : chosen) tests.at(name)(rows);
        rows.write();
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "couplingStability: %s\n", e.what());
        return 1;
    }
    return 0;
}
