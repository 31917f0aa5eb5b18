/* The table of categories. */
#include "oracle/categories.h"

#include "oracle/generators.h"

/* Exact mode rounds once, to the float. Compatible mode is OSMesa's arithmetic, which on ordinary scenes is this near;
 * vertices that leave the range where float is safe are lit in double. Large worlds and nearly singular matrices may be
 * this far off. */
/* clang-format off */
#define ORDINARY {0.5001, 2.3e-5}
#define EXTREME {0.5001, 3e-5}
#define ILL_CONDITIONED {0.5001, 1e-4}

const struct oracle_category oracle_categories[] = {
        {"1 light", generate_lights, 1, ORDINARY},
        {"8 lights", generate_lights, 8, ORDINARY},
        {"1 positional light", generate_positional, 1, ORDINARY},
        {"8 attenuated lights", generate_attenuated, 8, ORDINARY},
        {"local viewer", generate_local_viewer, 2, ORDINARY},
        {"2 spots", generate_spots, 2, ORDINARY},
        {"8 lights of every kind", generate_every_kind, 8, ORDINARY},
        {"lights placed by another matrix", generate_lights_of_other_matrix, 2, ORDINARY},
        {"shininess 0", generate_shininess, 0, EXTREME},
        {"shininess fractional", generate_shininess, -1, ORDINARY},
        {"shininess 1", generate_shininess, 1, ORDINARY},
        {"shininess 128", generate_shininess, 128, ORDINARY},

        {"spot exponent 0", generate_spot_exponent, 0, ORDINARY},
        {"spot exponent 1", generate_spot_exponent, 1, ORDINARY},
        {"spot exponent 64", generate_spot_exponent, 64, ORDINARY},
        {"spot exponent 128", generate_spot_exponent, 128, ORDINARY},
        {"spot cutoff 0", generate_spot_cutoff, 0, EXTREME},
        {"spot cutoff 1", generate_spot_cutoff, 1, ORDINARY},
        {"spot cutoff 45", generate_spot_cutoff, 45, ORDINARY},
        {"spot cutoff 60", generate_spot_cutoff, 60, ORDINARY},
        {"spot cutoff 90", generate_spot_cutoff, 90, ORDINARY},
        {"spot cutoff 180", generate_spot_cutoff, 180, ORDINARY},
        {"exactly on the edge of a cone of 0", generate_cone_edge, 0, EXTREME},
        {"exactly on the edge of a cone of 45", generate_cone_edge, 45, EXTREME},
        {"exactly on the edge of a cone of 60", generate_cone_edge, 60, EXTREME},
        {"exactly on the edge of a cone of 90", generate_cone_edge, 90, EXTREME},
        {"directional spots", generate_directional_spot, 0, ORDINARY},
        {"spot direction 0, cutoff 60", generate_zero_spot_direction, 60, EXTREME},
        {"spot direction 0, cutoff 90", generate_zero_spot_direction, 90, EXTREME},

        {"attenuation coefficients of 1e-44", generate_attenuation, 1e-44, EXTREME},
        {"attenuation coefficients of 1e-20", generate_attenuation, 1e-20, EXTREME},
        {"attenuation coefficients of 1e20", generate_attenuation, 1e20, EXTREME},
        {"attenuation coefficients of 1e38", generate_attenuation, 1e38, EXTREME},
        {"attenuation coefficients 0", generate_attenuation, 0, EXTREME},
        {"light at the vertex", generate_light_at_vertex, 1, EXTREME},
        {"light at the vertex, no constant attenuation", generate_light_at_vertex, 0, EXTREME},
        {"distance 0", generate_distance, 0, EXTREME},
        {"distance 1e-30", generate_distance, 1e-30, EXTREME},
        {"distance 1e-20", generate_distance, 1e-20, EXTREME},
        {"distance 1e-15", generate_distance, 1e-15, EXTREME},
        {"distance 1e-7", generate_distance, 1e-7, EXTREME},
        {"distance 1e18", generate_distance, 1e18, EXTREME},
        {"distance 3e19", generate_distance, 3e19, EXTREME},
        {"distance 1e30", generate_distance, 1e30, EXTREME},

        {"light w 1e-30", generate_light_w, 1e-30, EXTREME},
        {"light w 1e30", generate_light_w, 1e30, EXTREME},
        {"light w -1", generate_light_w, -1, EXTREME},
        {"light w 1e-40", generate_light_w, 1e-40, EXTREME},
        {"vertex w not 1", generate_vertex_w, 1, EXTREME},
        {"vertex w negative", generate_vertex_w, -1, EXTREME},
        {"vertex w 0", generate_vertex_w, 0, EXTREME},
        {"directional light of length 1e-30", generate_direction_length, 1e-30, EXTREME},
        {"directional light of length 1e30", generate_direction_length, 1e30, EXTREME},
        {"directional light of length 1e-40", generate_direction_length, 1e-40, EXTREME},

        {"normals not unit", generate_normals, -1, ORDINARY},
        {"normals 0", generate_normals, 0, EXTREME},
        {"normals of 1e-40", generate_normals, 1e-40, EXTREME},
        {"normals of 1e-30", generate_normals, 1e-30, EXTREME},
        {"normals of 1e30", generate_normals, 1e30, EXTREME},
        {"GL_NORMALIZE, normals not unit", generate_normalized_normals, -1, ORDINARY},
        {"GL_NORMALIZE, normals 0", generate_normalized_normals, 0, EXTREME},
        {"GL_NORMALIZE, normals of 1e-40", generate_normalized_normals, 1e-40, EXTREME},
        {"GL_NORMALIZE, normals of 1e-30", generate_normalized_normals, 1e-30, EXTREME},
        {"GL_NORMALIZE, normals of 1e30", generate_normalized_normals, 1e30, EXTREME},

        {"GL_RESCALE_NORMAL, scale about 1", generate_rescaled, 0, ORDINARY},
        {"GL_RESCALE_NORMAL, scale 1e-10", generate_rescaled, 1e-10, EXTREME},
        {"GL_RESCALE_NORMAL, scale 1e-5", generate_rescaled, 1e-5, EXTREME},
        {"GL_RESCALE_NORMAL, scale 1e5", generate_rescaled, 1e5, EXTREME},
        {"GL_RESCALE_NORMAL, scale 1e10", generate_rescaled, 1e10, EXTREME},
        {"GL_RESCALE_NORMAL, scale 1e18", generate_rescaled, 1e18, EXTREME},
        {"modelview scaled to 0.1", generate_scaled, 0.1, ORDINARY},
        {"modelview mirrored", generate_scaled, -0.1, ORDINARY},
        {"modelview scaled to 1e-4", generate_scaled, 1e-4, EXTREME},
        {"modelview scaled to 1e-9", generate_scaled, 1e-9, EXTREME},
        {"modelview sheared", generate_sheared, 0.7, ORDINARY},
        {"modelview of condition 1e3", generate_sheared, 1e-3, EXTREME},
        {"modelview of condition 1e6", generate_sheared, 1e-6, ILL_CONDITIONED},
        {"modelview singular by shear", generate_sheared, 0, EXTREME},
        {"modelview singular, one axis 0", generate_collapsed, 1, EXTREME},
        {"modelview singular, two axes 0", generate_collapsed, 2, EXTREME},
        {"modelview singular, three axes 0", generate_collapsed, 3, EXTREME},
        {"world 1e3 away", generate_large_world, 1e3, EXTREME},
        {"world 1e6 away", generate_large_world, 1e6, ILL_CONDITIONED},

        {"viewer at 1e-25", generate_viewer_distance, 1e-25, EXTREME},
        {"viewer at 1e25", generate_viewer_distance, 1e25, EXTREME},
        {"vertex at the eye", generate_viewer_distance, 0, EXTREME},
        {"half vector of length 1e-3", generate_half_vector, 1e-3, EXTREME},
        {"half vector of length 1e-7", generate_half_vector, 1e-7, EXTREME},
        {"half vector 0", generate_half_vector, 0, EXTREME},

        {"two-sided", generate_two_sided, 2, ORDINARY},
        {"color material", generate_color_material, 0, ORDINARY},
        {"separate specular color", generate_separate_specular, 2, ORDINARY},
        {"colors outside [0,1]", generate_colors_out_of_range, 2, EXTREME},

        {"light position not finite", generate_not_finite_light, 0, EXTREME},
        {"spot direction not finite", generate_not_finite_light, 1, EXTREME},
        {"ambient light not finite", generate_not_finite_light, 2, EXTREME},
        {"diffuse light not finite", generate_not_finite_light, 3, EXTREME},
        {"specular light not finite", generate_not_finite_light, 4, EXTREME},
        {"attenuation not finite", generate_not_finite_attenuation, 0, EXTREME},
        {"material not finite", generate_not_finite_material, 0, EXTREME},
        {"normals not finite", generate_not_finite_normal, 0, EXTREME},
        {"positions not finite", generate_not_finite_position, 0, EXTREME},
};

/* clang-format on */

const int oracle_category_count = (int)(sizeof oracle_categories / sizeof oracle_categories[0]);
