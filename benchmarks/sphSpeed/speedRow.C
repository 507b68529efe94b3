// SPDX-License-Identifier: GPL-3.0-or-later

#include "speedRow.hpp"
#include "workCount.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <stdexcept>

namespace riprap
{

namespace
{

std::string show(double v)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", v);
    return text;
}

std::string today()
{
    const std::time_t now = std::time(nullptr);
    char text[16];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

//- No quotes are needed in the file
std::string plain(std::string s)
{
    for (char& c : s) if (c == ',' || c == '"' || c == '\n') c = ';';
    return s;
}

//- Neighbours in a GPU's list, which holds those in the skin as well (defaults: skinRatio in
//  src/solvers/sph/parts/sphSetting.hpp)
double listed(const SpeedOptions& o, const SpeedRow& r)
{
    const double skin = o.skin >= 0 ? o.skin
                                    : (o.integrator == "symplectic" ? 0.16 : 0.12);
    return r.gpu ? r.neighbours*std::pow(1 + skin, o.dimensions) : 0;
}

//- Does a smaller value mean better?
bool smaller(const std::string& column)
{
    return column.rfind("time", 0) == 0 || column.rfind("bytes", 0) == 0;
}

//- Each goal, what was measured and whether that is enough
std::string goalsReached(
    const SpeedOptions& o, const std::vector<std::pair<std::string, std::string>>& columns)
{
    std::string r;
    for (const auto& g : o.goals)
    {
        const auto found = std::find_if(
            columns.begin(), columns.end(), [&](const auto& c) { return c.first == g.first; });
        if (found == columns.end())
            throw std::invalid_argument("-goal: there is no column '" + g.first + "'");
        const double value = std::stod(found->second);
        const bool less = smaller(g.first), reached = less ? value <= g.second : value >= g.second;
        r += (r.empty() ? "" : "; ") + g.first + " " + show(value) + (less ? " <= " : " >= ")
            + show(g.second) + (reached ? " yes" : " NO");
    }
    return r;
}

} // namespace

std::vector<std::pair<std::string, std::string>> SpeedRow::columns(const SpeedOptions& o) const
{
    const int passes = passesPerStep(o.integrator);
    const double rate = fluid/seconds, pairs = rate*passes*neighbours;
    const double operations = operationsPerPair(o)*neighbours + operationsPerParticle(o);
    const double moved = bytesPerParticleStep(o, listed(o, *this), interval);
    // the least time that each limit allows a particle-step
    const double byArithmetic = operations/limits.fma, byBandwidth = moved/limits.triad;
    const double byGather = limits.gather > 0 ? passes*neighbours/limits.gather : 0;
    // what stays in the last-level cache is not bound by memory
    const bool cached = memory < (gpu ? 4e7 : 1.6e7);
    const double least = std::max({byArithmetic, cached ? 0 : byBandwidth, byGather});
    const char* bound = least == byArithmetic ? "arithmetic"
                                              : (least == byGather ? "gather" : "bandwidth");
    std::string perKernel;
    for (const KernelInfo& k : kernels)
        perKernel += (perKernel.empty() ? "" : " ") + k.name + "=" + show(1e6*k.seconds) + "x"
            + show(k.launches*1e-6);

    return {{"date", today()}, {"name", plain(o.name)},
        {"scene", "damBreak" + std::to_string(o.dimensions) + "D"},
        {"fluid", std::to_string(fluid)}, {"walls", std::to_string(walls)},
        {"neighbours", show(neighbours)}, {"device", plain(device)},
        {"threads", std::to_string(threads)}, {"precision", wordOf(o.precision)},
        {"integrator", o.integrator}, {"terms", wordOf(o.terms)},
        {"wallModel", o.walls}, {"ratio", show(o.ratio)},
        {"start", o.atRest ? "atRest" : "inMotion"}, {"developed", show(developed)},
        {"timeStep", show(timeStep)}, {"steps", std::to_string(steps)},
        {"repeats", std::to_string(o.repeat)}, {"time", show(1e6*seconds)},
        {"spread", show(spread)}, {"timeCpu", show(1e6*cpuSeconds)},
        {"particleSteps", show(rate)}, {"passesPerStep", std::to_string(passes)},
        {"particlePasses", show(rate*passes)}, {"pairs", show(pairs)},
        {"rebuildInterval", show(interval)}, {"bytes", show(bytes)},
        {"bytesWithLists", show(bytesWithLists)}, {"memory", show(memory)},
        {"operations", show(operations)}, {"bytesMoved", show(moved)},
        {"triad", show(limits.triad)}, {"fma", show(limits.fma)}, {"gather", show(limits.gather)},
        {"ofArithmetic", show(byArithmetic/seconds*fluid)},
        {"ofBandwidth", show(byBandwidth/seconds*fluid)},
        {"ofGather", show(byGather/seconds*fluid)}, {"bound", bound}, {"kernels", perKernel},
        {"version", plain(o.version)}, {"note", plain(o.note)}};
}

void appendCsv(const SpeedOptions& o, const SpeedRow& r)
{
    if (o.csv.empty()) return;
    auto columns = r.columns(o);
    columns.emplace_back("goals", goalsReached(o, columns));
    const bool isNew = !std::ifstream(o.csv).good();
    std::ofstream out(o.csv, std::ios::app);
    if (!out) throw std::runtime_error("cannot write " + o.csv);
    const auto line = [&](auto text)
    {
        for (std::size_t k = 0; k < columns.size(); ++k) out << (k ? "," : "") << text(columns[k]);
        out << '\n';
    };
    if (isNew) line([](const auto& c) { return c.first; });
    line([](const auto& c) { return c.second; });
}

void printHeader()
{
    std::printf(
        "%-14s %9s %9s %6s %-7s %-10s %-8s %10s %10s %6s %9s %9s %9s %5s %6s %6s  %-16s %s\n",
        "case", "fluid", "walls", "nb", "prec", "integrator", "terms", "us/step", "cpu us", "+-%",
        "p-steps/s", "passes/s", "pairs/s", "reb", "B", "+list", "of limit", "goals");
}

void printRow(const SpeedOptions& o, const SpeedRow& r)
{
    const auto columns = r.columns(o);
    const auto get = [&](const char* name)
    {
        for (const auto& c : columns) if (c.first == name) return c.second;
        return std::string();
    };
    const std::string bound = get("bound");
    const std::string of = bound == "arithmetic"
        ? get("ofArithmetic")
        : (bound == "gather" ? get("ofGather") : get("ofBandwidth"));
    std::printf("%-14s %9zu %9zu %6.1f %-7s %-10s %-8s %10.1f %10.1f %6.1f %9.3g %9.3g %9.3g %5.1f "
                "%6.0f %6.0f  %4.2f %-11s %s\n",
        o.name.c_str(), r.fluid, r.walls, r.neighbours, wordOf(o.precision), o.integrator.c_str(),
        wordOf(o.terms), 1e6*r.seconds, 1e6*r.cpuSeconds, 100*r.spread,
        std::stod(get("particleSteps")), std::stod(get("particlePasses")), std::stod(get("pairs")),
        r.interval, r.bytes, r.bytesWithLists, std::stod(of), bound.c_str(),
        goalsReached(o, columns).c_str());
    for (const KernelInfo& k : r.kernels)
        std::printf("    %-20s %10.2f us/step %8.2f launches/step\n", k.name.c_str(),
            1e6*k.seconds, 1e-6*k.launches);
    std::fflush(stdout);
}

} // namespace riprap
