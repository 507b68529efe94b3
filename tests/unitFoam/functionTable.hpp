// SPDX-License-Identifier: GPL-3.0-or-later
/*  Tables that function objects write, as numbers: postProcessing/NAME/TIME/TABLE.dat. */
#pragma once

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct FunctionTable
{
    // lines that begin with #, but for the last: without it, and blanks at their ends
    std::vector<std::string> comments;
    std::vector<std::string> columns;       // of that: the first is Time
    std::vector<std::vector<double>> rows;

    //- Brackets around vectors are left out: (a_x a_y a_z) are three columns
    explicit FunctionTable(const std::string& text)
    {
        std::istringstream in(text);
        std::string line;
        while (std::getline(in, line))
        {
            if (line.empty()) throw std::runtime_error("an empty line: " + text);
            if (line[0] == '#')
            {
                const std::size_t from = line.find_first_not_of("# "),
                                  to = line.find_last_not_of(' ');
                comments.push_back(from > to ? "" : line.substr(from, to + 1 - from));
                continue;
            }
            rows.emplace_back();
            for (const std::string& w : words(line)) rows.back().push_back(std::stod(w));
        }
        if (comments.empty()) throw std::runtime_error("no table: " + text);
        columns = words(comments.back());
        comments.pop_back();
    }

    //- A number of a row; of the last
    double at(std::size_t row, const std::string& column) const
    {
        const auto c = std::find(columns.begin(), columns.end(), column);
        if (c == columns.end()) throw std::runtime_error("no column " + column);
        return rows.at(row).at(c - columns.begin());
    }

    double last(const std::string& column) const { return at(rows.size() - 1, column); }

private:

    static std::vector<std::string> words(std::string line)
    {
        for (char& c : line)
            if (c == '(' || c == ')') c = ' ';
        std::istringstream in(line);
        std::vector<std::string> all;
        std::string w;
        while (in >> w) all.push_back(w);
        return all;
    }
};
