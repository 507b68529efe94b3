// SPDX-License-Identifier: GPL-3.0-or-later

#include "csvFile.H"
#include "OSspecific.H"

#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace Foam
{

static std::string bare(std::string text)
{
    const char* blank = " \t\r\"";
    text.erase(0, text.find_first_not_of(blank));
    text.erase(text.find_last_not_of(blank) + 1);
    return text;
}


static std::vector<std::string> split(const std::string& line)
{
    std::vector<std::string> parts;
    std::stringstream stream(line);
    for (std::string part; std::getline(stream, part, ',');) parts.push_back(bare(part));
    return parts;
}

} // namespace Foam


Foam::csvFile::csvFile(checkedDictionary& dict, const Time& time)
:
    dict_(dict.dict())
{
    dict.found("file");
    file_ = dict_.get<fileName>("file");
    file_.expand();
    if (!file_.isAbsolute()) file_ = time.globalPath()/file_;

    std::ifstream in(file_);
    if (!isFile(file_) || !in)
    {
        FatalIOErrorInFunction(dict_) << "Entry file: there is no " << file_ << exit(FatalIOError);
    }

    std::string line;
    std::getline(in, line);
    head_ = split(line);
    for (label number = 2; std::getline(in, line); ++number)
    {
        if (bare(line).empty()) continue;
        rows_.push_back(split(line));
        lines_.push_back(number);
        if (rows_.back().size() != head_.size())
        {
            fail
            (
                size() - 1,
                std::to_string(rows_.back().size()) + " values, not " + std::to_string(head_.size())
            );
        }
    }
}


Foam::label Foam::csvFile::column(const std::string& name) const
{
    for (std::size_t i = 0; i < head_.size(); ++i)
    {
        if (head_[i] == name) return i;
    }
    return -1;
}


Foam::scalar Foam::csvFile::number(label row, label column) const
{
    // Not OpenFOAM's reader, which traps at nan and at what no double holds
    const std::string& typed = text(row, column);
    char* end = nullptr;
    std::fenv_t traps;
    std::feholdexcept(&traps);
    const scalar value = std::strtod(typed.c_str(), &end);
    std::fesetenv(&traps);

    if (typed.empty() || *end || !std::isfinite(value)) fail(row, "'" + typed + "' is no number");
    return value;
}


void Foam::csvFile::fail(label row, const std::string& what) const
{
    FatalIOErrorInFunction(dict_) << "Entry file: line " << (row < 0 ? 1 : lines_[row]) << " of "
                                  << file_ << ": " << what.c_str() << exit(FatalIOError);
}
