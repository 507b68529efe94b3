/*  picStability: where the particle-in-cell solver fails.

        picStability -csv FILE [step|blend|particles|tolerance|levels]...

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <vector>
#include "experiments.hpp"

int main(int argc, char** argv)
{
    using namespace riprap;
    const std::map<std::string, void (*)(PicRows&)> known
    {{"step", step}, {"blend", blend}, {"particles", particles}, {"tolerance", tolerance}, {"levels", levels}};
    try
    {
        std::string csv;
        std::vector<std::string> wanted;
        for (int k = 1; k < argc; ++k)
        {
            const std::string word = argv[k];
            if (word == "-csv" && k + 1 < argc) csv = argv[++k];
            else if (known.count(word)) wanted.push_back(word);
            else throw std::invalid_argument("'" + word + "' is none of step, blend, particles, tolerance, levels, -csv FILE");
        }
        if (csv.empty()) throw std::invalid_argument("-csv FILE is needed");
        if (wanted.empty()) for (const auto& k : known) wanted.push_back(k.first);
        PicRows rows(csv);
        for (const std::string& w : wanted) known.at(w)(rows);
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "picStability: %s\n", e.what());
        return 1;
    }
    return 0;
}
