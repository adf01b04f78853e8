// The registry: which entities live, and what components they have.
//
// A component is a struct. It is read through const references and changed through patch(), which
// counts: whoever remembers a version knows later whether anything changed. Misuse (a dead entity,
// a missing component) aborts with a sentence. Order is reproducible: the same calls give the same
// entities, in the same storage order, with the same versions.

#pragma once

#include "ecs/entity.hpp"
#include "ecs/require.hpp"
#include "ecs/storage.hpp"
#include "ecs/view.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace ecs {

class Registry {
public:
    /// @pre fewer than Entity::kIndexMask indices are in use
    Entity create();

    /// Removes all components and ends the entity. An index whose generations are used up is never
    /// used again, so a dead entity stays dead for ever.
    /// @pre alive(entity)
    /// Cost: one look-up per component type.
    void destroy(Entity entity);

    [[nodiscard]] bool alive(Entity entity) const {
        return entity.index() < slots_.size() && slots_[entity.index()] == entity;
    }

    /// @pre alive(entity), and it has no T
    template <class T>
    void add(Entity entity, T value = {}) {
        check_alive(entity);
        storage<T>().add(entity, std::move(value));
    }

    /// @pre the entity has a T. The reference lives until a T is added or removed anywhere.
    template <class T>
    [[nodiscard]] const T& get(Entity entity) const {
        const T* value = try_get<T>(entity);
        if (!value)
            misuse(entity, alive(entity) ? "has no " : "is dead and has no ", component_name<T>());
        return *value;
    }

    /// @return null when the entity has no T; the dead have nothing
    template <class T>
    [[nodiscard]] const T* try_get(Entity entity) const {
        const Storage<T>* found = find_storage<T>();
        return found ? found->try_get(entity) : nullptr;
    }

    /// False for the dead.
    template <class T>
    [[nodiscard]] bool has(Entity entity) const {
        return try_get<T>(entity) != nullptr;
    }

    /// Calls function(T&) and raises the version: the only way to change a component. The function
    /// must not add or remove a T.
    /// @pre the entity has a T
    template <class T, class Function>
    void patch(Entity entity, Function&& function) {
        check_alive(entity);
        storage<T>().patch(entity, std::forward<Function>(function));
    }

    /// @pre the entity has a T
    template <class T>
    void remove(Entity entity) {
        check_alive(entity);
        storage<T>().remove(entity);
    }

    /// The entities that have all of Ts; view.hpp says what may change meanwhile.
    template <class... Ts>
    [[nodiscard]] View<Ts...> view() const {
        return View<Ts...>(find_storage<Ts>()...);
    }

    /// Calls function(entity, const Ts&...) for each entity that has all of Ts.
    template <class... Ts, class Function>
    void each(Function&& function) const {
        view<Ts...>().each(std::forward<Function>(function));
    }

    /// Rises when the entity's T is added or patched, and is never the same for two states of any
    /// T; 0 when it has none.
    template <class T>
    [[nodiscard]] std::uint64_t version(Entity entity) const {
        const Storage<T>* found = find_storage<T>();
        return found ? found->version(entity) : 0;
    }

    /// Rises when any T is added, patched or removed; 0 before the first.
    template <class T>
    [[nodiscard]] std::uint64_t version() const {
        const Storage<T>* found = find_storage<T>();
        return found ? found->version() : 0;
    }

    template <class T>
    [[nodiscard]] std::size_t count() const {
        const Storage<T>* found = find_storage<T>();
        return found ? found->owners().size() : 0;
    }

private:
    void check_alive(Entity entity) const {
        if (!alive(entity)) misuse(entity, "is not alive");
    }

    template <class T>
    [[nodiscard]] const Storage<T>* find_storage() const {
        const std::size_t id = type_id<T>();
        return id < storages_.size() ? static_cast<const Storage<T>*>(storages_[id].get())
                                     : nullptr;
    }

    template <class T>
    Storage<T>& storage() {
        const std::size_t id = type_id<T>();
        if (id >= storages_.size()) storages_.resize(id + 1);
        if (!storages_[id]) storages_[id] = std::make_unique<Storage<T>>();
        return static_cast<Storage<T>&>(*storages_[id]);
    }

    /// The living entity of each index. A free slot holds the index of the next free one with the
    /// generation that its own next entity will have; a slot that is used up holds kNoEntity.
    std::vector<Entity> slots_;
    std::uint32_t first_free_ = kNoEntity.index();
    std::vector<std::unique_ptr<AnyStorage>>
        storages_; ///< by type_id; null for types never added here
};

inline Entity Registry::create() {
    if (first_free_ == kNoEntity.index()) {
        const Entity entity = Entity::from(static_cast<std::uint32_t>(slots_.size()), 0);
        if (slots_.size() >= kNoEntity.index())
            misuse(entity, "cannot be made: all indices are used up");
        slots_.push_back(entity);
        return entity;
    }
    const std::uint32_t index = first_free_;
    first_free_ = slots_[index].index();
    slots_[index] = Entity::from(index, slots_[index].generation());
    return slots_[index];
}

inline void Registry::destroy(Entity entity) {
    check_alive(entity);
    for (const auto& storage : storages_) {
        if (storage) storage->forget(entity);
    }
    if (entity.generation() == kNoEntity.generation()) {
        slots_[entity.index()] = kNoEntity;
        return;
    }
    slots_[entity.index()] = Entity::from(first_free_, entity.generation() + 1);
    first_free_ = entity.index();
}

} // namespace ecs
