// What a point of a light gives a surface, were nothing between: the cosine between the two. Of a triangle that is
// turned away from a light which still reaches the smooth surface that it stands for, that of the smooth one.

float given_by(vec3 facet, vec3 shaded, vec3 to_light) {
    vec3 direction = normalize(to_light);
    float cosine = dot(facet, direction);
    return cosine > 0.0 ? cosine : max(dot(shaded, direction), 0.0);
}
