// A set of entities in a packed array, with constant-time insert, erase and look-up.
//
// The sparse side maps an entity's index to its position in the packed side. It comes in pages,
// made when first needed, so that a set of a few entities with high indices stays small. Source: P.
// Briggs and L. Torczon, "An Efficient Representation for Sparse Sets", 1993.

#pragma once

#include "ecs/entity.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ecs {

class SparseSet {
public:
    static constexpr std::uint32_t kAbsent = 0xFFFFFFFFU;

    [[nodiscard]] std::size_t size() const { return packed_.size(); }

    /// Insertion order, but for the holes that erase() filled. @pre position < size()
    [[nodiscard]] Entity operator[](std::size_t position) const { return packed_[position]; }

    [[nodiscard]] bool contains(Entity entity) const {
        const std::uint32_t position = find_index(entity);
        return position != kAbsent && packed_[position] == entity;
    }

    /// The position held by the entity's index, or kAbsent. The generation is not looked at: use it
    /// for living entities, which share their index with nobody.
    [[nodiscard]] std::uint32_t find_index(Entity entity) const {
        const std::uint32_t page = entity.index() / kPageSize;
        if (page >= pages_.size() || !pages_[page]) return kAbsent;
        return (*pages_[page])[entity.index() % kPageSize];
    }

    /// Appends. @pre the entity's index is not in the set
    void insert(Entity entity) {
        slot(entity) = static_cast<std::uint32_t>(packed_.size());
        packed_.push_back(entity);
    }

    /// Puts the last entity in the place of the erased one.
    /// @pre contains(entity)
    /// @return the position that was filled; equal to the new size() when the last one was erased
    std::size_t erase(Entity entity) {
        std::uint32_t& erased = slot(entity);
        const std::size_t position = erased;
        const Entity last = packed_.back();
        packed_[position] = last;
        packed_.pop_back();
        slot(last) = static_cast<std::uint32_t>(position);
        erased = kAbsent;
        return position;
    }

private:
    static constexpr std::uint32_t kPageSize = 4096;
    using Page = std::array<std::uint32_t, kPageSize>;

    std::uint32_t& slot(Entity entity) {
        const std::uint32_t page = entity.index() / kPageSize;
        if (page >= pages_.size()) pages_.resize(page + 1U);
        if (!pages_[page]) {
            pages_[page] = std::make_unique<Page>();
            pages_[page]->fill(kAbsent);
        }
        return (*pages_[page])[entity.index() % kPageSize];
    }

    std::vector<Entity> packed_;
    std::vector<std::unique_ptr<Page>> pages_;
};

} // namespace ecs
