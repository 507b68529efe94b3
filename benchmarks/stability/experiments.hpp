/*  What the stability programs share: the front end

        PROGRAM [-csv FILE] [FLAG]... [EXPERIMENT]...        (all experiments where none is named)

    and bisection. A table is made of the name of the CSV file, and has write().

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace riprap
{

template<class Table>
int runExperiments(int argc, char** argv, const std::string& program,
    const std::vector<std::pair<std::string, std::function<void(Table&)>>>& experiments,
    const std::map<std::string, bool*>& flags = {})
{
    std::string csv, words = "-csv FILE";
    for (const auto& f : flags) words += ", " + f.first;
    for (const auto& e : experiments) words += ", " + e.first;
    std::vector<std::string> chosen;
    for (int i = 1; i < argc; ++i)
    {
        const std::string word = argv[i];
        const auto flag = flags.find(word);
        if (word == "-csv" && i + 1 < argc) csv = argv[++i];
        else if (flag != flags.end()) *flag->second = true;
        else if (std::any_of(experiments.begin(), experiments.end(),
                     [&](const auto& e) { return e.first == word; }))
            chosen.push_back(word);
        else
        {
            std::fprintf(
                stderr, "%s: '%s' is none of %s\n", program.c_str(), argv[i], words.c_str());
            return 2;
        }
    }
    try
    {
        Table table(csv);
        for (const auto& e : experiments)
            if (chosen.empty() || std::find(chosen.begin(), chosen.end(), e.first) != chosen.end())
                e.second(table);
        table.write();
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "%s: %s\n", program.c_str(), e.what());
        return 1;
    }
    return 0;
}

//- The largest x in [low, high] for which good(x), assuming one crossing; low if none is good, high
//  if all are
template<class Good>
double bisect(double low, double high, double tolerance, const Good& good)
{
    if (!good(low)) return low;
    if (good(high)) return high;
    while (high - low > tolerance)
    {
        const double middle = 0.5*(low + high);
        (good(middle) ? low : high) = middle;
    }
    return 0.5*(low + high);
}

//- The bound between good and bad, to 3 %, where good lies below it or above; the end where all are
//  good, 0 or 1e9 where none is
template<class Good>
double bisectRatio(double low, double high, bool goodBelow, const Good& good)
{
    if (good(goodBelow ? high : low)) return goodBelow ? high : low;
    if (!good(goodBelow ? low : high)) return goodBelow ? 0 : 1e9;
    while (high > 1.03*low)
    {
        const double middle = std::sqrt(low*high);
        (good(middle) == goodBelow ? low : high) = middle;
    }
    return goodBelow ? low : high;
}

} // namespace riprap
