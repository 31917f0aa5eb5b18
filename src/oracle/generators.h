/* The generators behind categories.c. Each fills a scene; what its parameter is stands with it. */
#ifndef ORACLE_GENERATORS_H
#define ORACLE_GENERATORS_H

#include "oracle/random.h"
#include "oracle/scene.h"

/* Multiplies the components of a vector. */
void oracle_multiply(float *v, int count, float factor);

/* generate_ordinary.c */
void generate_lights(struct random *r, struct oracle_scene *s, double count);
void generate_positional(struct random *r, struct oracle_scene *s, double count);
void generate_attenuated(struct random *r, struct oracle_scene *s, double count);
void generate_local_viewer(struct random *r, struct oracle_scene *s, double count);
void generate_spots(struct random *r, struct oracle_scene *s, double count);
void generate_every_kind(struct random *r, struct oracle_scene *s, double count);
void generate_lights_of_other_matrix(struct random *r, struct oracle_scene *s, double count);
void generate_shininess(struct random *r, struct oracle_scene *s, double value);

/* generate_light.c */
void generate_spot_exponent(struct random *r, struct oracle_scene *s, double exponent);
void generate_spot_cutoff(struct random *r, struct oracle_scene *s, double cutoff);
void generate_cone_edge(struct random *r, struct oracle_scene *s, double cutoff);
void generate_near_cone_edge(struct random *r, struct oracle_scene *s, double degrees);
void generate_directional_spot(struct random *r, struct oracle_scene *s, double unused);
void generate_zero_spot_direction(struct random *r, struct oracle_scene *s, double cutoff);
void generate_attenuation(struct random *r, struct oracle_scene *s, double magnitude);
void generate_distance(struct random *r, struct oracle_scene *s, double d);
void generate_light_at_vertex(struct random *r, struct oracle_scene *s, double constant);
void generate_light_w(struct random *r, struct oracle_scene *s, double w);
void generate_vertex_w(struct random *r, struct oracle_scene *s, double sign);
void generate_direction_length(struct random *r, struct oracle_scene *s, double length);

/* generate_geometry.c */
void generate_normals(struct random *r, struct oracle_scene *s, double length);
void generate_normalized_normals(struct random *r, struct oracle_scene *s, double length);
void generate_rescaled(struct random *r, struct oracle_scene *s, double scale);
void generate_uniform_scale(struct random *r, struct oracle_scene *s, double scale);
void generate_scaled(struct random *r, struct oracle_scene *s, double least);
void generate_sheared(struct random *r, struct oracle_scene *s, double left);
void generate_condition(struct random *r, struct oracle_scene *s, double condition);
void generate_collapsed(struct random *r, struct oracle_scene *s, double axes);
void generate_large_world(struct random *r, struct oracle_scene *s, double offset);
void generate_viewer_distance(struct random *r, struct oracle_scene *s, double d);
void generate_half_vector(struct random *r, struct oracle_scene *s, double length);

/* generate_color.c */
void generate_two_sided(struct random *r, struct oracle_scene *s, double count);
void generate_color_material(struct random *r, struct oracle_scene *s, double unused);
void generate_separate_specular(struct random *r, struct oracle_scene *s, double count);
void generate_colors_out_of_range(struct random *r, struct oracle_scene *s, double count);
void generate_not_finite_light(struct random *r, struct oracle_scene *s, double which);
void generate_not_finite_attenuation(struct random *r, struct oracle_scene *s, double unused);
void generate_not_finite_material(struct random *r, struct oracle_scene *s, double unused);
void generate_not_finite_normal(struct random *r, struct oracle_scene *s, double unused);
void generate_not_finite_position(struct random *r, struct oracle_scene *s, double unused);

#endif
