/*  demStability: where riprap's DEM fails, found by bisection, beside theory.

        demStability [-csv FILE] [limits|energy|laws]...

    All scenes are small and run on the CPU in double precision through createDemScene. See the header comment of each experiment.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "demResults.hpp"

#include <cstdio>
#include <cstring>
#include <exception>
#include <map>

int main(int argc, char** argv)
{
    using namespace riprap;
    const std::map<std::string, void (*)(DemResults&)> tests {{"limits", contactLimits}, {"energy", energy}, {"laws", laws}};
    std::string csv;
    std::vector<std::string> chosen;
    for (int i = 1; i < argc; ++i)
    {
        if (!std::strcmp(argv[i], "-csv") && i + 1 < argc) csv = argv[++i];
        else if (tests.count(argv[i])) chosen.push_back(argv[i]);
        else
        {
            std::fprintf(stderr, "demStability: '%s' is none of -csv FILE, limits, energy, laws\n", argv[i]);
            return 2;
        }
    }
    if (chosen.empty()) chosen = {"limits", "energy", "laws"};
    try
    {
        DemResults results(csv);
        for (const std::string& name : chosen) tests.at(name)(results);
        results.write();
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "demStability: %s\n", e.what());
        return 1;
    }
    return 0;
}
