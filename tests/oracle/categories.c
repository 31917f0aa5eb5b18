/* The table of categories. */
#include "oracle/categories.h"

#include "oracle/generators.h"

/* Exact mode rounds once, to the float. Two colors that the fragment stage adds in float have three roundings.
 * Compatible mode is OSMesa's arithmetic, which on ordinary scenes is this near. Its bounds on the others
 * come with the recomputation in double of lanes that leave the range where float is safe. Until then they are
 * measured only. */
/* clang-format off */
#define ORDINARY {0.5001, 2.3e-5}
#define MEASURED {0.5001, 0}
#define SUM_OF_TWO(compatible) {1.5, compatible}

const struct oracle_category oracle_categories[] = {
        {"1 light", generate_lights, 1, ORDINARY},
        {"8 lights", generate_lights, 8, ORDINARY},
        {"1 positional light", generate_positional, 1, ORDINARY},
        {"8 attenuated lights", generate_attenuated, 8, ORDINARY},
        {"local viewer", generate_local_viewer, 2, ORDINARY},
        {"2 spots", generate_spots, 2, ORDINARY},
        {"8 lights of every kind", generate_every_kind, 8, ORDINARY},
        {"lights placed by another matrix", generate_lights_of_other_matrix, 2, ORDINARY},
        {"shininess 0", generate_shininess, 0, MEASURED},
        {"shininess fractional", generate_shininess, -1, ORDINARY},
        {"shininess 1", generate_shininess, 1, ORDINARY},
        {"shininess 128", generate_shininess, 128, ORDINARY},

        {"spot exponent 0", generate_spot_exponent, 0, ORDINARY},
        {"spot exponent 1", generate_spot_exponent, 1, ORDINARY},
        {"spot exponent 64", generate_spot_exponent, 64, ORDINARY},
        {"spot exponent 128", generate_spot_exponent, 128, ORDINARY},
        {"spot cutoff 0", generate_spot_cutoff, 0, MEASURED},
        {"spot cutoff 1", generate_spot_cutoff, 1, ORDINARY},
        {"spot cutoff 45", generate_spot_cutoff, 45, ORDINARY},
        {"spot cutoff 60", generate_spot_cutoff, 60, ORDINARY},
        {"spot cutoff 90", generate_spot_cutoff, 90, ORDINARY},
        {"spot cutoff 180", generate_spot_cutoff, 180, ORDINARY},
        {"exactly on the edge of a cone of 0", generate_cone_edge, 0, MEASURED},
        {"exactly on the edge of a cone of 45", generate_cone_edge, 45, MEASURED},
        {"exactly on the edge of a cone of 60", generate_cone_edge, 60, MEASURED},
        {"exactly on the edge of a cone of 90", generate_cone_edge, 90, MEASURED},
        {"directional spots", generate_directional_spot, 0, ORDINARY},
        {"spot direction 0, cutoff 60", generate_zero_spot_direction, 60, MEASURED},
        {"spot direction 0, cutoff 90", generate_zero_spot_direction, 90, MEASURED},

        {"attenuation coefficients of 1e-44", generate_attenuation, 1e-44, MEASURED},
        {"attenuation coefficients of 1e-20", generate_attenuation, 1e-20, MEASURED},
        {"attenuation coefficients of 1e20", generate_attenuation, 1e20, MEASURED},
        {"attenuation coefficients of 1e38", generate_attenuation, 1e38, MEASURED},
        {"attenuation coefficients 0", generate_attenuation, 0, MEASURED},
        {"light at the vertex", generate_light_at_vertex, 1, MEASURED},
        {"light at the vertex, no constant attenuation", generate_light_at_vertex, 0, MEASURED},
        {"distance 0", generate_distance, 0, MEASURED},
        {"distance 1e-30", generate_distance, 1e-30, MEASURED},
        {"distance 1e-20", generate_distance, 1e-20, MEASURED},
        {"distance 1e-15", generate_distance, 1e-15, MEASURED},
        {"distance 1e-7", generate_distance, 1e-7, MEASURED},
        {"distance 1e18", generate_distance, 1e18, MEASURED},
        {"distance 3e19", generate_distance, 3e19, MEASURED},
        {"distance 1e30", generate_distance, 1e30, MEASURED},

        {"light w 1e-30", generate_light_w, 1e-30, MEASURED},
        {"light w 1e30", generate_light_w, 1e30, MEASURED},
        {"light w -1", generate_light_w, -1, MEASURED},
        {"light w 1e-40", generate_light_w, 1e-40, MEASURED},
        {"vertex w not 1", generate_vertex_w, 1, MEASURED},
        {"vertex w negative", generate_vertex_w, -1, MEASURED},
        {"directional light of length 1e-30", generate_direction_length, 1e-30, MEASURED},
        {"directional light of length 1e30", generate_direction_length, 1e30, MEASURED},
        {"directional light of length 1e-40", generate_direction_length, 1e-40, MEASURED},

        {"normals not unit", generate_normals, -1, ORDINARY},
        {"normals 0", generate_normals, 0, MEASURED},
        {"normals of 1e-40", generate_normals, 1e-40, MEASURED},
        {"normals of 1e-30", generate_normals, 1e-30, MEASURED},
        {"normals of 1e30", generate_normals, 1e30, MEASURED},
        {"GL_NORMALIZE, normals not unit", generate_normalized_normals, -1, ORDINARY},
        {"GL_NORMALIZE, normals 0", generate_normalized_normals, 0, MEASURED},
        {"GL_NORMALIZE, normals of 1e-40", generate_normalized_normals, 1e-40, MEASURED},
        {"GL_NORMALIZE, normals of 1e-30", generate_normalized_normals, 1e-30, MEASURED},
        {"GL_NORMALIZE, normals of 1e30", generate_normalized_normals, 1e30, MEASURED},

        {"GL_RESCALE_NORMAL, scale about 1", generate_rescaled, 0, ORDINARY},
        {"GL_RESCALE_NORMAL, scale 1e-10", generate_rescaled, 1e-10, MEASURED},
        {"GL_RESCALE_NORMAL, scale 1e-5", generate_rescaled, 1e-5, MEASURED},
        {"GL_RESCALE_NORMAL, scale 1e5", generate_rescaled, 1e5, MEASURED},
        {"GL_RESCALE_NORMAL, scale 1e10", generate_rescaled, 1e10, MEASURED},
        {"GL_RESCALE_NORMAL, scale 1e18", generate_rescaled, 1e18, MEASURED},
        {"modelview scaled to 0.1", generate_scaled, 0.1, ORDINARY},
        {"modelview mirrored", generate_scaled, -0.1, ORDINARY},
        {"modelview scaled to 1e-4", generate_scaled, 1e-4, MEASURED},
        {"modelview scaled to 1e-9", generate_scaled, 1e-9, MEASURED},
        {"modelview sheared", generate_sheared, 0.7, ORDINARY},
        {"modelview of condition 1e3", generate_sheared, 1e-3, MEASURED},
        {"modelview of condition 1e6", generate_sheared, 1e-6, MEASURED},
        {"modelview singular by shear", generate_sheared, 0, MEASURED},
        {"modelview singular, one axis 0", generate_collapsed, 1, MEASURED},
        {"modelview singular, two axes 0", generate_collapsed, 2, MEASURED},
        {"modelview singular, three axes 0", generate_collapsed, 3, MEASURED},
        {"world 1e3 away", generate_large_world, 1e3, MEASURED},
        {"world 1e6 away", generate_large_world, 1e6, MEASURED},

        {"viewer at 1e-25", generate_viewer_distance, 1e-25, MEASURED},
        {"viewer at 1e25", generate_viewer_distance, 1e25, MEASURED},
        {"vertex at the eye", generate_viewer_distance, 0, MEASURED},
        {"half vector of length 1e-3", generate_half_vector, 1e-3, MEASURED},
        {"half vector of length 1e-7", generate_half_vector, 1e-7, MEASURED},
        {"half vector 0", generate_half_vector, 0, MEASURED},

        {"two-sided", generate_two_sided, 2, ORDINARY},
        {"color material", generate_color_material, 0, ORDINARY},
        {"separate specular color", generate_separate_specular, 2, SUM_OF_TWO(2.3e-5)},
        {"colors outside [0,1]", generate_colors_out_of_range, 2, SUM_OF_TWO(0)},

        {"light position not finite", generate_not_finite_light, 0, MEASURED},
        {"spot direction not finite", generate_not_finite_light, 1, MEASURED},
        {"ambient light not finite", generate_not_finite_light, 2, MEASURED},
        {"diffuse light not finite", generate_not_finite_light, 3, MEASURED},
        {"specular light not finite", generate_not_finite_light, 4, MEASURED},
        {"attenuation not finite", generate_not_finite_attenuation, 0, MEASURED},
        {"material not finite", generate_not_finite_material, 0, MEASURED},
        {"normals not finite", generate_not_finite_normal, 0, MEASURED},
        {"positions not finite", generate_not_finite_position, 0, MEASURED},
};

/* clang-format on */

const int oracle_category_count = (int)(sizeof oracle_categories / sizeof oracle_categories[0]);
