/*  Named per-particle fields that are sorted together. Only what is added exists.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <string>
#include <vector>
#include "core/backend/launch.hpp"

namespace riprap
{

//- Gathers up to maxFields fields of 4- or 8-byte elements into a new order, in one launch
struct Permute
{
    static constexpr const char* name = "permute";
    static constexpr int maxFields = 20;

    const std::uint32_t* order;
    int fields;
    const void* from[maxFields];
    void* to[maxFields];
    bool wide[maxFields];

    HD void operator()(int i) const
    {
        const std::uint32_t j = order[i];
        for (int f = 0; f < fields; ++f)
        {
            if (wide[f])
                static_cast<std::uint64_t*>(to[f])[i] = static_cast<const std::uint64_t*>(
                    from[f])[j];
            else
                static_cast<std::uint32_t*>(to[f])[i] = static_cast<const std::uint32_t*>(
                    from[f])[j];
        }
    }
};

template<class Backend>
class FieldSet
{
public:

    //- Add a field of elements of T (4 or 8 bytes); returns its index
    template<class T>
    int add(const std::string& name)
    {
        static_assert(sizeof(T) == 4 || sizeof(T) == 8, "elements of 4 or 8 bytes");
        fields_.emplace_back();
        fields_.back().name = name;
        fields_.back().bytes = sizeof(T);
        return int(fields_.size()) - 1;
    }

    //- Memory for n particles. Large sets share one spare array a size of element, so that a
    //  permutation sorts field after field; small ones, and those that ask for it, have a spare for
    //  each field and are sorted in one launch.
    void allocate(Context<Backend>& context, std::size_t n, bool spareForEach = false)
    {
        tight_ = n >= tightFrom && !spareForEach;
        for (Field& f : fields_)
        {
            f.now.allocate(context, n*f.bytes);
            if (!tight_) f.next.allocate(context, n*f.bytes);
            else if (f.bytes == 8) spare8_.allocate(context, n*8);
            else spare4_.allocate(context, n*4);
        }
        n_ = n;
    }

    static constexpr std::size_t tightFrom = 2000000;

    //- Does a permutation bring back the same pointers after every second one (else: not at all
    //  soon)?
    bool alternates() const { return !tight_; }

    //- No more permutations: give the spare memory back
    void releaseSpare()
    {
        for (Field& f : fields_) f.next = Array<Backend, unsigned char>();
        spare8_ = Array<Backend, unsigned char>();
        spare4_ = Array<Backend, unsigned char>();
    }

    std::size_t bytes() const
    {
        std::size_t b = spare8_.bytes() + spare4_.bytes();
        for (const Field& f : fields_) b += f.now.bytes() + f.next.bytes();
        return b;
    }

    template<class T>
    T* data(int field) { return reinterpret_cast<T*>(fields_[field].now.data()); }

    //- Spare of a field that has its own, for a sort by the caller's launch, and what ends it:
    //  spares become the fields
    template<class T>
    T* spare(int field) { return reinterpret_cast<T*>(fields_[field].next.data()); }
    void takeSpares() { for (Field& f : fields_) f.now.swap(f.next); }

    //- Sort every field but those of [skipFrom, skipTo); pointers from data() change
    void permute(Context<Backend>& context, const std::uint32_t* order, int n, int skipFrom = 0,
        int skipTo = 0)
    {
        Permute p{};
        p.order = order;
        for (int k = 0; k < int(fields_.size()); ++k)
        {
            if (k >= skipFrom && k < skipTo) continue;
            Field& f = fields_[k];
            Array<Backend, unsigned char>& next = !tight_ ? f.next
                                                          : (f.bytes == 8 ? spare8_ : spare4_);
            p.from[p.fields] = f.now.data();
            p.to[p.fields] = next.data();
            p.wide[p.fields++] = f.bytes == 8;
            if (p.fields == Permute::maxFields || tight_) { forEach(context, n, p); p.fields = 0; }
            f.now.swap(next);
        }
        if (p.fields) forEach(context, n, p);
    }

    template<class T>
    std::vector<T> download(Context<Backend>& context, int field)
    {
        std::vector<T> host(n_);
        if (n_) context.toHost(host.data(), fields_[field].now.data(), n_*sizeof(T));
        return host;
    }

    template<class T>
    void upload(Context<Backend>& context, int field, const std::vector<T>& host)
    {
        if (!host.empty())
            context.toDevice(fields_[field].now.data(), host.data(), host.size()*sizeof(T));
    }

    struct Info { std::string name; std::size_t bytes; };
    std::vector<Info> info() const
    {
        std::vector<Info> r;
        for (const Field& f : fields_) r.push_back(Info{f.name, f.now.bytes() + f.next.bytes()});
        if (spare8_.bytes() + spare4_.bytes())
            r.push_back(Info{"spare", spare8_.bytes() + spare4_.bytes()});
        return r;
    }

    int fields() const { return int(fields_.size()); }
    int elementBytes(int field) const { return fields_[field].bytes; }
    unsigned char* bytes(int field) { return fields_[field].now.data(); }
    std::size_t size() const { return n_; }

private:

    struct Field
    {
        std::string name;
        int bytes = 0;
        Array<Backend, unsigned char> now, next;
    };
    std::vector<Field> fields_;
    Array<Backend, unsigned char> spare8_, spare4_;
    std::size_t n_ = 0;
    bool tight_ = false;
};

} // namespace riprap
