#include "engine/script/schema_parts.hpp"

#include <algorithm>
#include <iterator>

namespace script {

using engine::Field;
using engine::FieldType;

std::vector<Field> joined(std::vector<Field> fields, std::vector<Field> more) {
    std::move(more.begin(), more.end(), std::back_inserter(fields));
    return fields;
}

Field name_field(const std::string& what) {
    return {
        .name = "name",
        .type = FieldType::name,
        .text = "What rules, messages and files call this " + what
                + "; unique in the level. Without it a name is made up, and a reload may take it "
                  "for another one.",
    };
}

Field position_field(Numbers fallback) {
    return {
        .name = "position",
        .type = FieldType::vector,
        .text = "Where it is: x, y (up), z.",
        .fallback = std::move(fallback),
        .unit = "m",
        .range = kWorld};
}

} // namespace script
