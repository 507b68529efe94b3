// SPDX-License-Identifier: GPL-3.0-or-later
/*  VTK polydata as it is written (XML, base64 inline), read back: points, lines, fields. */
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

struct LineFile
{
    //- By the name of the array: Points, connectivity, offsets, then fields
    std::map<std::string, std::vector<double>> arrays;

    explicit LineFile(const std::string& xml)
    {
        std::size_t at = 0;
        while ((at = xml.find("<DataArray", at)) != std::string::npos)
        {
            const std::size_t close = xml.find('>', at), end = xml.find("</DataArray", close);
            const std::string head(xml.substr(at, close - at));
            const std::string bytes(decoded(xml.substr(close + 1, end - close - 1)));
            arrays[attribute(head, "Name")] = attribute(head, "type") == "Int32"
                ? numbers<std::int32_t>(bytes)
                : numbers<float>(bytes);
            at = end;
        }
        if (arrays.empty()) throw std::runtime_error("no polydata: " + xml);
    }

    const std::vector<double>& of(const std::string& name) const { return arrays.at(name); }

private:

    static std::string attribute(const std::string& head, const std::string& name)
    {
        const std::size_t from = head.find(name + '=') + name.size() + 2;
        return head.substr(from, head.find(head[from - 1], from) - from);
    }

    static std::string decoded(const std::string& text)
    {
        const std::string digits(
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/");
        std::string bytes;
        unsigned bits = 0;
        int n = 0;
        for (const char c : text)
        {
            const std::size_t value = digits.find(c);
            if (value == std::string::npos) continue;
            bits = bits << 6 | unsigned(value);
            if ((n += 6) >= 8) bytes.push_back(char(bits >> (n -= 8) & 0xff));
        }
        return bytes;
    }

    //- After their size in bytes
    template<class T>
    static std::vector<double> numbers(const std::string& bytes)
    {
        std::uint64_t size = 0;
        if (bytes.size() < sizeof(size)) throw std::runtime_error("an array without its size");
        std::memcpy(&size, bytes.data(), sizeof(size));
        if (bytes.size() != sizeof(size) + size) throw std::runtime_error("a size that is wrong");
        std::vector<T> all(size/sizeof(T));
        if (size) std::memcpy(all.data(), bytes.data() + sizeof(size), size);
        return std::vector<double>(all.begin(), all.end());
    }
};
