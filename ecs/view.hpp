// The entities that have all of some component types.
//
// The type with the fewest components drives: its owners are walked in storage order and looked up
// in the other types. While a view is walked
// - any component may be patched, and any type that is not viewed may be added or removed;
// - the entity at hand may lose its viewed components or be destroyed; the walk goes on with the
// entity that
//   takes its place;
// - viewed types must not be added to any entity, nor removed from another one: the order would
// change under
//   the walk. Collect such entities first. Aborts where it is noticed.
// References to a component die when its type is added or removed anywhere.

#pragma once

#include "ecs/storage.hpp"

#include <array>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>

namespace ecs {

/// A walk over a sparse set that survives the erasure of the entity it stands at.
class Cursor {
public:
    explicit Cursor(const SparseSet& set) : set_(&set), end_(set.size()) {}

    [[nodiscard]] bool done() const { return position_ >= end_; }
    /// @pre !done(), and the set is as it was when the cursor came here
    [[nodiscard]] Entity entity() const { return (*set_)[position_]; }
    [[nodiscard]] std::size_t position() const { return position_; }

    /// @param visited what entity() was
    void advance(Entity visited) {
        if (set_->size() == end_) {
            ++position_;
        } else { // the last entity stands in the place of the erased one now: stay
            check_erasure(*set_, end_, visited);
            end_ = set_->size();
        }
    }

private:
    /// Takes values: a cursor whose address never escapes lives in registers.
    static void check_erasure(const SparseSet& set, std::size_t size_before, Entity visited) {
        if (set.size() + 1 != size_before || set.contains(visited))
            misuse(visited, "was being visited while the viewed components of others came or went");
    }

    const SparseSet* set_;
    std::size_t end_;
    std::size_t position_ = 0;
};

/// A short-lived range of entities: `for (ecs::Entity entity : registry.view<A, B>())`.
template <class... Ts>
class View {
    static_assert(sizeof...(Ts) > 0, "a view needs a component type");

public:
    class Iterator {
    public:
        using value_type = Entity;
        using difference_type = std::ptrdiff_t;
        using iterator_category = std::input_iterator_tag;

        Iterator(const View& view, const SparseSet& driver) : view_(&view), cursor_(driver) {
            find_member();
        }

        Entity operator*() const { return entity_; }
        Iterator& operator++() {
            cursor_.advance(entity_);
            find_member();
            return *this;
        }
        void operator++(int) { ++*this; }
        bool operator==(std::default_sentinel_t /*end*/) const { return cursor_.done(); }

    private:
        void find_member() {
            for (; !cursor_.done(); cursor_.advance(entity_)) {
                entity_ = cursor_.entity();
                if (view_->contains(entity_)) return;
            }
        }

        const View* view_;
        Cursor cursor_;
        Entity entity_;
    };

    /// @param storages null for a type that the registry has never held: the view is empty then
    explicit View(const Storage<Ts>*... storages) : storages_(storages...) {
        if ((!storages || ...)) return;
        const std::array<const SparseSet*, sizeof...(Ts)> sets = {&storages->owners()...};
        for (std::size_t i = 1; i < sets.size(); ++i) {
            if (sets[i]->size() < sets[driver_]->size()) driver_ = i;
        }
        driving_set_ = sets[driver_];
    }

    [[nodiscard]] Iterator begin() const {
        return {*this, driving_set_ ? *driving_set_ : empty_set()};
    }
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }

    [[nodiscard]] bool contains(Entity entity) const {
        return driving_set_
               && (std::get<const Storage<Ts>*>(storages_)->owners().contains(entity) && ...);
    }

    /// Calls function(entity, const Ts&...) for each entity.
    template <class Function>
    void each(Function&& function) const {
        if (!driving_set_) return;
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            ((driver_ == I && (walk<I>(function, std::index_sequence<I...>()), true)) || ...);
        }
        (std::index_sequence_for<Ts...>());
    }

private:
    template <std::size_t Driver, class Function, std::size_t... I>
    void walk(Function& function, std::index_sequence<I...> /*types*/) const {
        Cursor cursor(*driving_set_);
        while (!cursor.done()) {
            const Entity entity = cursor.entity();
            std::array<std::size_t, sizeof...(I)> at = {};
            at[Driver] = cursor.position();
            if (((I == Driver || (at[I] = find<I>(entity)) != SparseSet::kAbsent) && ...))
                function(entity, std::get<I>(storages_)->value(at[I])...);
            cursor.advance(entity);
        }
    }

    template <std::size_t I>
    [[nodiscard]] std::size_t find(Entity entity) const {
        return std::get<I>(storages_)->owners().find_index(entity);
    }

    static const SparseSet& empty_set() {
        static const SparseSet empty;
        return empty;
    }

    std::tuple<const Storage<Ts>*...> storages_;
    const SparseSet* driving_set_ = nullptr;
    std::size_t driver_ = 0;
};

} // namespace ecs
