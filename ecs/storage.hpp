// All components of one type: a sparse set of owners, and packed beside it their values and
// versions.

#pragma once

#include "ecs/require.hpp"
#include "ecs/sparse_set.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace ecs {

/// What the registry needs to know of a storage whose type it does not know.
class AnyStorage {
public:
    AnyStorage() = default;
    AnyStorage(const AnyStorage&) = delete;
    AnyStorage& operator=(const AnyStorage&) = delete;
    virtual ~AnyStorage() = default;

    /// Removes the entity's component if it has one.
    virtual void forget(Entity entity) = 0;
};

template <class T>
class Storage final : public AnyStorage {
    static_assert(std::is_class_v<T>, "components are structs");

public:
    [[nodiscard]] const SparseSet& owners() const { return owners_; }
    [[nodiscard]] const T& value(std::size_t position) const { return values_[position]; }

    /// Rises at every add, patch and remove; 0 in a storage never used.
    [[nodiscard]] std::uint64_t version() const { return version_; }

    /// The storage's version when the entity's component was last added or patched; 0 when it has
    /// none. No two states of components of one type share a version.
    [[nodiscard]] std::uint64_t version(Entity entity) const {
        return owners_.contains(entity) ? versions_[owners_.find_index(entity)] : 0;
    }

    /// @return null when the entity has none
    [[nodiscard]] const T* try_get(Entity entity) const {
        return owners_.contains(entity) ? &values_[owners_.find_index(entity)] : nullptr;
    }

    void add(Entity entity, T&& value) {
        if (owners_.contains(entity)) misuse(entity, "already has ", component_name<T>());
        owners_.insert(entity);
        values_.push_back(std::move(value));
        versions_.push_back(++version_);
    }

    template <class Function>
    void patch(Entity entity, Function&& function) {
        if (!owners_.contains(entity)) misuse(entity, "has no ", component_name<T>());
        const std::uint32_t position = owners_.find_index(entity);
        versions_[position] = ++version_;
        std::forward<Function>(function)(values_[position]);
    }

    void remove(Entity entity) {
        if (!owners_.contains(entity)) misuse(entity, "has no ", component_name<T>());
        forget(entity);
    }

    void forget(Entity entity) override {
        if (!owners_.contains(entity)) return;
        const std::size_t position = owners_.erase(entity);
        if (position + 1 != values_.size()) values_[position] = std::move(values_.back());
        values_.pop_back();
        versions_[position] = versions_.back();
        versions_.pop_back();
        ++version_;
    }

private:
    SparseSet owners_;
    std::vector<T> values_;
    std::vector<std::uint64_t> versions_;
    std::uint64_t version_ = 0;
};

inline std::size_t next_type_id() {
    static std::atomic<std::size_t> next = 0;
    return next++;
}

/// 0, 1, 2 ... in the order in which a program first uses its component types.
template <class T>
std::size_t type_id() {
    static const std::size_t id = next_type_id();
    return id;
}

} // namespace ecs
