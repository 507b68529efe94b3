/*  A page of the user's guide, for tests of what it says of models: their words, and the rows of
    their entries.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>
#include <gtest/gtest.h>

namespace riprap
{

class Guide
{
    std::string text_;

    static std::vector<std::string> split(const std::string& s, char at)
    {
        std::vector<std::string> parts;
        std::stringstream in(s);
        for (std::string part; std::getline(in, part, at);)
        {
            const auto first = part.find_first_not_of(" `{}"), last = part.find_last_not_of(" `{}");
            parts.push_back(first == std::string::npos ? ""
                                                       : part.substr(first, last - first + 1));
        }
        return parts;
    }

    //- What a row says of an entry
    struct Row { std::string otherwise, meaning; };

    //- Those that name it in their first cell, alone or among others
    std::vector<Row> rows(const std::string& entry) const
    {
        std::vector<Row> all;
        std::stringstream in(text_);
        for (std::string line; std::getline(in, line);)
        {
            if (line.rfind("| `", 0) != 0) continue;
            const std::vector<std::string> cells = split(line.substr(1), '|');
            if (cells.size() < 3) continue;
            // `dictionary` { `entry` }
            const auto brace = cells[0].rfind('{');
            const std::vector<std::string> names = split(
                brace == std::string::npos ? cells[0] : cells[0].substr(brace + 1), ',');
            const std::vector<std::string> defaults = split(cells[1], ',');
            for (std::size_t k = 0; k < names.size(); ++k)
                if (names[k] == entry)
                    all.push_back({defaults.size() == names.size() ? defaults[k] : "", cells[2]});
        }
        return all;
    }

    //- Is it a number, yes or no, or the word for what is required? Other texts explain themselves
    static bool isPlain(const std::string& s)
    {
        static const std::regex plain("yes|no|none|must be there|[-+.0-9e]+");
        return std::regex_match(s, plain);
    }

    static bool says(const std::string& otherwise, double value, bool required, bool yesNo)
    {
        if (required || otherwise == "must be there") return required == (otherwise[0] == 'm');
        if (yesNo) return otherwise == (value != 0 ? "yes" : "no");
        return otherwise == "none" ? value == 0 : std::atof(otherwise.c_str()) == value;
    }

public:

    //- By its path; empty where RIPRAP_DIR is not set
    explicit Guide(const std::string& page)
    {
        const char* root = std::getenv("RIPRAP_DIR");
        if (!root) return;
        std::ifstream in(std::string(root) + "/" + page);
        text_.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
        EXPECT_FALSE(text_.empty()) << page;
    }

    bool empty() const { return text_.empty(); }

    void expectWord(const std::string& word) const
    { EXPECT_NE(text_.find("`" + word + "`"), std::string::npos) << word; }

    void expectWords(const std::vector<std::string>& words) const
    { for (const std::string& w : words) expectWord(w); }

    //- The default and the unit of an entry, as far as rows of its name tell them
    template<class Entry>
    void expectEntry(const Entry& e) const
    {
        expectWord(e.name);
        bool claimed = false, agrees = false, united = false, hasUnit = false;
        std::string said;
        for (const Row& row : rows(e.name))
        {
            if (isPlain(row.otherwise))
            {
                claimed = true;
                agrees = agrees || says(row.otherwise, e.otherwise, e.required, e.yesNo);
                said += " '" + row.otherwise + "'";
            }
            const std::string meaning = std::regex_replace(
                std::regex_replace(row.meaning, std::regex("²"), "2"), std::regex("³"), "3");
            // not the text of a link
            static const std::regex unit("\\[[^\\]]+\\](?!\\()");
            united = united || std::regex_search(meaning, unit);
            hasUnit = hasUnit || meaning.find("[" + std::string(e.unit) + "]") != std::string::npos;
        }
        EXPECT_TRUE(!claimed || agrees) << e.name << ": the guide has the default" << said;
        if (*e.unit && united)
        {
            EXPECT_TRUE(hasUnit) << e.name << " [" << e.unit << "]";
        }
    }
};

} // namespace riprap
