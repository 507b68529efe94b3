// SPDX-License-Identifier: GPL-3.0-or-later
/*  source csv;  file "points.csv";     // in the case; first line: x,y,z or x,y,z,u,v,w or x,y,z,u,v,w,p */

#include "addToRunTimeSelectionTable.H"
#include "particleSource.H"
#include "OSspecific.H"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace Foam
{

class csvSource
:
    public particleSource
{
    DynamicList<point> position_;
    DynamicList<vector> velocity_;
    DynamicList<scalar> pressure_;

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

    static void fail(const dictionary& dict, const fileName& file, label line, const std::string& what)
    {
        FatalIOErrorInFunction(dict)
            << "Entry file: line " << line << " of " << file << ": " << what.c_str() << exit(FatalIOError);
    }

public:

    TypeName("csv");

    csvSource(checkedDictionary& dict, const Time& time)
    {
        dict.found("file");
        fileName file(dict.dict().get<fileName>("file"));
        file.expand();
        if (!file.isAbsolute()) file = time.path()/file;

        std::ifstream in(file);
        if (!isFile(file) || !in)
        {
            FatalIOErrorInFunction(dict.dict())
                << "Entry file: there is no " << file << exit(FatalIOError);
        }

        std::string line;
        std::getline(in, line);
        const auto head = split(line);
        const std::vector<std::string> all{"x", "y", "z", "u", "v", "w", "p"};
        const bool known = head.size() == 3 || head.size() == 6 || head.size() == 7;
        if (!known || !std::equal(head.begin(), head.end(), all.begin()))
        {
            fail(dict.dict(), file, 1,
                "the header is '" + bare(line) + "', not x,y,z or x,y,z,u,v,w or x,y,z,u,v,w,p");
        }

        for (label number = 2; std::getline(in, line); ++number)
        {
            if (bare(line).empty()) continue;
            const auto parts = split(line);
            if (parts.size() != head.size())
            {
                fail(dict.dict(), file, number, std::to_string(parts.size()) + " values, not "
                    + std::to_string(head.size()));
            }
            scalar v[7] = {0, 0, 0, 0, 0, 0, 0};
            for (std::size_t i = 0; i < parts.size(); ++i)
            {
                if (!readScalar(parts[i].c_str(), v[i]))
                {
                    fail(dict.dict(), file, number, "'" + parts[i] + "' is no number");
                }
            }
            position_.append(point(v[0], v[1], v[2]));
            if (head.size() > 3) velocity_.append(vector(v[3], v[4], v[5]));
            if (head.size() > 6) pressure_.append(v[6]);
        }
    }

    virtual void place
    (
        const particlePacking& packing,
        const boundBox&,
        pointField& position,
        vectorField& velocity
    ) const
    {
        position = pointField(position_);
        velocity = vectorField(velocity_);
        for (point& p : position) p = packing.inPlane(p);
    }

    virtual scalarField pressure() const { return scalarField(pressure_); }

    virtual scalar estimate(const particlePacking&) const { return position_.size(); }

    virtual bool regular() const { return false; }
};

defineTypeNameAndDebug(csvSource, 0);
addToRunTimeSelectionTable(particleSource, csvSource, dictionary);

} // namespace Foam
