/*  sphStability: where riprap's SPH fails, found by bisection, beside theory.

        sphStability [-csv FILE] [-quick] [acoustic|viscous|force|tensile|passage]...

    All scenes are 2D, small, and run on the CPU through createSphScene. See the header comment of each experiment.
*/
#include "resultTable.hpp"

#include <cstdio>
#include <cstring>
#include <map>

using namespace riprap;

int main(int argc, char** argv)
{
    const std::map<std::string, void (*)(ResultTable&, bool)> tests
    {
        {"acoustic", acoustic}, {"viscous", viscous}, {"force", impactForce}, {"tensile", tensile}, {"passage", passage}
    };
    std::string csv;
    std::vector<std::string> chosen;
    bool quick = false;
    for (int i = 1; i < argc; ++i)
    {
        if (!std::strcmp(argv[i], "-csv") && i + 1 < argc) csv = argv[++i];
        else if (!std::strcmp(argv[i], "-quick")) quick = true;
        else if (tests.count(argv[i])) chosen.push_back(argv[i]);
        else
        {
            std::fprintf(stderr, "sphStability: '%s' is none of -csv FILE, -quick, acoustic, viscous, force, tensile, passage\n", argv[i]);
            return 1;
        }
    }
    if (chosen.empty()) chosen = {"acoustic", "viscous", "force", "tensile", "passage"};
    try
    {
        ResultTable table(csv);
        for (const std::string& name : chosen) tests.at(name)(table, quick);
        table.write();
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "sphStability: %s\n", e.what());
        return 1;
    }
    return 0;
}
