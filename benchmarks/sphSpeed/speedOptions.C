// SPDX-License-Identifier: GPL-3.0-or-later

#include "speedOptions.hpp"

#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

namespace riprap
{

namespace
{

template<class T>
using Words = std::vector<std::pair<const char*, T>>;

const Words<TermSet> termWords{
    {"minimal", TermSet::minimal}, {"paper", TermSet::paper}, {"delta", TermSet::delta}};
const Words<PrecisionKind> precisionWords{
    {"mixed", PrecisionKind::mixed}, {"double", PrecisionKind::doubled}};
const Words<std::string> integratorWords
{{"leapfrog", "leapfrog"}, {"symplectic", "symplectic"}};
const Words<std::string> wallWords{
    {"stationary", "stationary"}, {"extrapolated", "extrapolated"}};
const Words<DeviceKind> deviceWords
{{"auto", DeviceKind::automatic}, {"cpu", DeviceKind::cpu}, {"gpu", DeviceKind::gpu}};

template<class T>
T valueOf(const Words<T>& words, const std::string& word)
{
    std::string valid;
    for (const auto& w : words)
    {
        if (word == w.first) return w.second;
        valid += std::string(" ") + w.first;
    }
    throw std::invalid_argument("'" + word + "' is none of" + valid);
}

template<class T>
const char* wordIn(const Words<T>& words, T value)
{
    for (const auto& w : words) if (w.second == value) return w.first;
    return "";
}

double number(const std::string& text)
{
    std::size_t used = 0;
    double value = 0;
    try { value = std::stod(text, &used); } catch (const std::exception&) { used = 0; }
    if (used == 0 || used != text.size())
        throw std::invalid_argument("'" + text + "' is no number");
    return value;
}

//- "20000,1e6" or "20000 1e6"
std::vector<double> numbers(std::string text)
{
    for (char& c : text) if (c == ',') c = ' ';
    std::istringstream in(text);
    std::vector<double> r;
    for (std::string word; in >> word;) r.push_back(number(word));
    if (r.empty()) throw std::invalid_argument("an empty list of numbers");
    return r;
}

struct Switch { const char* what; std::function<void(const std::string&)> read; };

} // namespace

const char* wordOf(TermSet v) { return wordIn(termWords, v); }
const char* wordOf(PrecisionKind v) { return wordIn(precisionWords, v); }
const char* wordOf(DeviceKind v) { return wordIn(deviceWords, v); }

SpeedOptions readSpeedOptions(int argc, char** argv)
{
    SpeedOptions o;
    const auto goal = [&](const std::string& text)
    {
        std::istringstream in(text);
        for (std::string g; std::getline(in, g, ',');)
        {
            const std::size_t equals = g.find('=');
            if (equals == std::string::npos) throw std::invalid_argument("a goal is COLUMN=VALUE");
            o.goals.emplace_back(g.substr(0, equals), number(g.substr(equals + 1)));
        }
    };
    const std::map<std::string, Switch> switches{
        {"-name",
            {"TEXT      the case's name in the table", [&](const std::string& s) { o.name = s; }}},
        {"-dim",
            {"2|3        dimensions (2)",
                [&](const std::string& s) { o.dimensions = int(number(s)); }}},
        {"-particles",
            {"N,N,... wanted numbers of fluid particles (20000)",
                [&](const std::string& s) { o.particles = numbers(s); }}},
        {"-precision",
            {"mixed|double (mixed)",
                [&](const std::string& s) { o.precision = valueOf(precisionWords, s); }}},
        {"-device",
            {"auto|cpu|gpu (auto)",
                [&](const std::string& s) { o.device = valueOf(deviceWords, s); }}},
        {"-ratio",
            {"H        smoothing length in spacings: 1.25: 20 (2D), 65 (3D) neighbours; 1.7: 160 "
             "(3D)",
                [&](const std::string& s) { o.ratio = number(s); }}},
        {"-integrator",
            {"leapfrog|symplectic (leapfrog)",
                [&](const std::string& s) { o.integrator = valueOf(integratorWords, s); }}},
        {"-walls",
            {"stationary|extrapolated (extrapolated)",
                [&](const std::string& s) { o.walls = valueOf(wallWords, s); }}},
        {"-terms",
            {"minimal|paper|delta (minimal)",
                [&](const std::string& s) { o.terms = valueOf(termWords, s); }}},
        {"-skin",
            {"S          skin in support radii; < 0: the solver's choice (-1)",
                [&](const std::string& s) { o.skin = number(s); }}},
        {"-atRest",
            {"0|1      start at rest instead of in motion (0)",
                [&](const std::string& s) { o.atRest = number(s) != 0; }}},
        {"-develop",
            {"N       steps before the first timed one (300)",
                [&](const std::string& s) { o.develop = int(number(s)); }}},
        {"-steps",
            {"N         steps a repeat; 0: as many as take -seconds (0)",
                [&](const std::string& s) { o.steps = int(number(s)); }}},
        {"-seconds",
            {"S       length of a repeat (0.3)",
                [&](const std::string& s) { o.seconds = number(s); }}},
        {"-repeat",
            {"N        repeats, of which the median counts (7)",
                [&](const std::string& s) { o.repeat = int(number(s)); }}},
        {"-kernels",
            {"0|1     seconds of each kernel, in a repeat of its own (0)",
                [&](const std::string& s) { o.kernels = number(s) != 0; }}},
        {"-csv", {"FILE        append the rows", [&](const std::string& s) { o.csv = s; }}},
        {"-note",
            {"TEXT       column note of the rows", [&](const std::string& s) { o.note = s; }}},
        {"-version",
            {"TEXT    column version of the rows", [&](const std::string& s) { o.version = s; }}},
        {"-goal",
            {"COLUMN=V,... what columns should reach, or stay below if it is a time or bytes",
                goal}}};
    for (int i = 1; i < argc; i += 2)
    {
        const auto found = switches.find(argv[i]);
        if (found == switches.end() || i + 1 == argc)
        {
            std::string text = found == switches.end()
                ? "unknown option '" + std::string(argv[i]) + "'"
                : std::string(argv[i]) + " lacks its value";
            for (const auto& s : switches) text += "\n    " + s.first + " " + s.second.what;
            throw std::invalid_argument(text);
        }
        try { found->second.read(argv[i + 1]); }
        catch (const std::invalid_argument& e)
        {
            throw std::invalid_argument(std::string(argv[i]) + ": " + e.what());
        }
    }
    if (o.dimensions != 2 && o.dimensions != 3) throw std::invalid_argument("-dim: 2 or 3");
    if (o.repeat < 1 || o.steps < 0 || o.develop < 0 || !(o.seconds > 0))
        throw std::invalid_argument("-repeat, -steps, -develop and -seconds must not be negative");
    return o;
}

} // namespace riprap
