#include "engine/scene/gltf_primitive.hpp"

#include <cmath>

namespace scene {

namespace {

constexpr glm::vec3 kUp = {0.0F, 1.0F, 0.0F};

/// In doubles, so that neither large nor small triangles lose their direction.
glm::dvec3 area_vector(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return 0.5 * glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
}

glm::vec3 unit_or_up(const glm::dvec3& vector) {
    const double length = glm::length(vector);
    return std::isnormal(length) ? glm::vec3(vector / length) : kUp;
}

template <class T>
void gather(std::vector<T>& values, const std::vector<std::uint32_t>& indices) {
    if (values.empty()) return;
    std::vector<T> gathered;
    gathered.reserve(indices.size());
    for (const std::uint32_t index : indices)
        gathered.push_back(values[index]);
    values = std::move(gathered);
}

/// One normal per corner of a triangle list whose corners are its vertices.
/// @param deltas empty, or offsets of the positions
std::vector<glm::vec3>
flat_normals(const std::vector<glm::vec3>& positions, const std::vector<glm::vec3>& deltas) {
    const auto corner = [&](std::size_t i) {
        return deltas.empty() ? positions[i] : positions[i] + deltas[i];
    };
    std::vector<glm::vec3> normals(positions.size(), kUp);
    for (std::size_t i = 0; i + 2 < positions.size(); i += 3)
        normals[i] = normals[i + 1] = normals[i + 2] =
            unit_or_up(area_vector(corner(i), corner(i + 1), corner(i + 2)));
    return normals;
}

} // namespace

std::optional<ListMode> list_indices(int mode, const std::vector<std::uint32_t>& indices) {
    const std::size_t count = indices.size();
    ListMode list{Topology::triangles, {}};
    const auto line = [&](std::size_t a, std::size_t b) {
        list.indices.insert(list.indices.end(), {indices[a], indices[b]});
    };
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        list.indices.insert(list.indices.end(), {indices[a], indices[b], indices[c]});
    };
    switch (mode) {
    case 0:
        return ListMode{Topology::points, indices};
    case 1:
        list.topology = Topology::lines;
        list.indices.assign(
            indices.begin(), indices.end() - static_cast<std::ptrdiff_t>(count % 2));
        return list;
    case 2:
    case 3:
        list.topology = Topology::lines;
        for (std::size_t i = 1; i < count; ++i)
            line(i - 1, i);
        if (mode == 2 && count > 2) line(count - 1, 0);
        return list;
    case 4:
        list.indices.assign(
            indices.begin(), indices.end() - static_cast<std::ptrdiff_t>(count % 3));
        return list;
    case 5:
        for (std::size_t i = 0; i + 2 < count; ++i)
            triangle(i, i + 1 + i % 2, i + 2 - i % 2);
        return list;
    case 6:
        for (std::size_t i = 1; i + 1 < count; ++i)
            triangle(i, i + 1, 0);
        return list;
    default:
        return std::nullopt;
    }
}

void make_flat(PrimitiveData& data) {
    gather(data.positions, data.indices);
    gather(data.uvs, data.indices);
    gather(data.influences, data.indices);
    data.normals = flat_normals(data.positions, {});
    for (MorphTarget& target : data.morph_targets) {
        gather(target.position_deltas, data.indices);
        target.normal_deltas = flat_normals(data.positions, target.position_deltas);
        for (std::size_t i = 0; i < data.normals.size(); ++i)
            target.normal_deltas[i] -= data.normals[i];
    }
    for (std::size_t i = 0; i < data.indices.size(); ++i)
        data.indices[i] = static_cast<std::uint32_t>(i);
}

std::size_t mend_normals(PrimitiveData& data) {
    std::size_t mended = 0;
    std::vector<char> lost(data.normals.size());
    bool any_lost = false;
    for (std::size_t i = 0; i < data.normals.size(); ++i) {
        const glm::dvec3 normal(data.normals[i]);
        const double length = glm::length(normal);
        if (!(std::abs(length - 1.0) <= 0.05)) ++mended;
        if (std::isfinite(length) && length > 1e-6) {
            data.normals[i] = glm::vec3(normal / length);
        } else {
            lost[i] = 1;
            any_lost = true;
        }
    }
    if (!any_lost) return mended;

    std::vector<glm::dvec3> sums(data.normals.size());
    if (data.topology == Topology::triangles) {
        for (std::size_t i = 0; i + 2 < data.indices.size(); i += 3) {
            const std::uint32_t* corner = &data.indices[i];
            const glm::dvec3 area = area_vector(
                data.positions[corner[0]], data.positions[corner[1]], data.positions[corner[2]]);
            for (int k = 0; k < 3; ++k)
                sums[corner[k]] += area;
        }
    }
    for (std::size_t i = 0; i < data.normals.size(); ++i)
        if (lost[i] != 0) data.normals[i] = unit_or_up(sums[i]);
    return mended;
}

} // namespace scene
