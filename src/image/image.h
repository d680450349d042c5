/* Dumps image and movie: pictures of particles, bonds, the box and surfaces, with the words of LAMMPS. */
#ifndef TS_IMAGE_IMAGE_H
#define TS_IMAGE_IMAGE_H

#include "dump/dump.h"
#include "render/colour_map.h"
#include "render/picture.h"

/* Columns of the dump: what colours and sizes of the particles are made of. */
enum { TS_IMAGE_COLOUR, TS_IMAGE_DIAMETER, TS_IMAGE_COLUMNS };

/* Colour of values that are no numbers: magenta. */
#define TS_IMAGE_NAN 0xff00ffu

struct ts_image_surface;
struct ts_image_clip;
struct ts_image_film;
struct ts_image_slice;
struct ts_image_arrows;
struct ts_image_contacts;
struct ts_image_region;

/* Sources of a colour or a size other than numbers of particles or bonds. */
enum ts_image_by {
	TS_IMAGE_NONE,
	TS_IMAGE_TYPE,
	TS_IMAGE_ELEMENT,
	TS_IMAGE_ATOM,
	TS_IMAGE_NUMBER,
	TS_IMAGE_VALUE
};

enum ts_image_axes { TS_AXES_NO, TS_AXES_YES, TS_AXES_LOWERLEFT, TS_AXES_CENTER };

/* Settings of types, from 1; made when the first one is changed. */
struct ts_image_types {
	struct ts_colour *colour; /* [n + 1]; NULL: those of ts_colour_of_type */
	double *diameter;	  /* [n + 1] length; NaN: not set; NULL: none is set */
	double *opacity;	  /* [n + 1]; NULL: 1 */
	size_t n;
};

/* Arguments of keywords that have several. */
struct ts_image_size {
	int64_t width, height; /* pixels */
};
struct ts_image_view {
	struct ts_number theta, phi; /* degrees */
};
struct ts_image_center {
	int dynamic;		  /* 0: of the box at the definition; 1: of that of the frame */
	struct ts_number part[3]; /* fractions of the box */
};
struct ts_image_up {
	struct ts_number part[3];
};
struct ts_image_lines {
	int shown;	 /* enum ts_image_axes for the axes, else 0 or 1 */
	double length;	 /* of axes, fraction of the lengths of the box */
	double diameter; /* fraction of the shortest length of the box */
};
struct ts_image_occlusion {
	bool on;
	int64_t seed;
	double strength;
};
struct ts_image_legend {
	bool on;
	const char *title[2]; /* at the right and at the left edge; NULL: the name of the quantity */
};
struct ts_image_bond {
	const char *colour, *width; /* as written */
	enum ts_image_by colour_by, width_by;
	double diameter;	   /* with TS_IMAGE_NUMBER, length */
	struct ts_ref_input input; /* with TS_IMAGE_VALUE */
	struct ts_table values;
};

/* First member of the states of both styles. */
struct ts_image {
	struct ts_dump_common common;
	/* arguments as words; those of keywords are read into the structs below by init */
	const char *quantity[TS_IMAGE_COLUMNS];
	struct ts_words bond_words, size_words, view_words, center_words, up_words, box_words, axes_words,
		subbox_words, ssao_words, legend_words;
	struct ts_number zoom;
	double persp, shiny, depthcue, adiam;
	bool atoms, fsaa;
	bool unless_empty; /* no picture of the box alone; set by who makes the dump */

	struct ts_image_size size;
	struct ts_image_view view;
	struct ts_image_center center;
	struct ts_image_up up;
	struct ts_image_lines box, axes, subbox;
	struct ts_image_occlusion ssao;
	struct ts_image_bond bond;
	struct ts_image_legend legend;
	struct ts_words surface_words;
	struct ts_image_surface *surface; /* [nsurfaces] image_surfaces.h */
	size_t nsurfaces;
	/* image_clip.h, image_slice.h, image_film.h, image_arrow.h, image_contact.h, image_region.h */
	struct ts_words clip_words, slice_words, film_words, arrow_words, contact_words, region_words;
	struct ts_image_clip *clip;
	struct ts_image_slice *slice;
	struct ts_image_film *film;
	struct ts_image_arrows *arrows;
	struct ts_image_contacts *contacts;
	struct ts_image_region *region;
	size_t nclips, nslices, nfilms, narrows, ncontacts, nregions;
	double first_box[2][3]; /* lower and upper corner of the box at the definition; saved */
	bool placed;		/* first_box is set; saved */

	/* settings of dump_modify */
	struct ts_image_types atom_types, bond_types;
	struct ts_palette palette;
	struct ts_colour_map atom_map, bond_map, surface_map, field_map, contact_map;
	struct ts_colour ground, box_colour;
	bool gradient;
	struct ts_colour ground_top;
	struct ts_lights lights;
	double framerate, bitrate; /* of movies: frames per second; kbit/s, 0: chosen by the encoder */
	bool modified;		   /* the defaults of these are set */

	/* of the present frame */
	double range[2][2];	  /* of the values of atoms and of bonds that colours belong to */
	double contact_range[2];  /* of the forces of all keywords contact */
	unsigned char *drawn;	  /* [particles] whether the particle is drawn */
	struct ts_colour *colour; /* [particles] of those drawn */
	double *diameter;	  /* [particles] of those drawn, length */
	size_t drawn_capacity, colour_capacity, diameter_capacity;
	struct ts_scene scene;
	struct ts_picture picture;
	bool told_nan, told_radius, told_view; /* warnings are given once */
};

/* ---- image_args.c: tables of both styles */

extern const struct ts_arg ts_image_args[];
extern const struct ts_arg_group ts_image_groups[];
extern const struct ts_saved ts_image_saved[];
extern const char *const ts_image_text[];

/* ---- image_words.c: arguments and defaults */

/* In init: reads the words of all keywords, resolves the columns. */
enum ts_status ts_image_read(struct ts_instance *self, struct tsim *sim);
/* Slot `modify`: keywords of dump_modify. */
enum ts_status ts_image_modify(struct ts_instance *self, struct tsim *sim, struct ts_words words,
			       size_t *used);
/* Reads `lo hi style delta N entries`, or `lo hi name`, after the keyword `what`; *used: the number of these words. */
enum ts_status ts_image_read_map(struct ts_instance *self, struct tsim *sim, const char *what,
				 struct ts_words words, struct ts_colour_map *map, size_t *used);
/* Sets the defaults of the settings of dump_modify, once. */
void ts_image_set_defaults(struct ts_image *s);
/* Finds a colour of this word; fails with a suggestion. */
enum ts_status ts_image_find_colour(struct tsim *sim, const struct ts_image *s, const struct ts_word *word,
				    struct ts_colour *out);

/* Warns once of values that are drawn in magenta. */
void ts_image_warn_nan(struct ts_instance *self, struct tsim *sim, const char *what);

/* ---- parts of a frame, added to s->scene */

enum ts_status ts_image_add_particles(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_image_add_bonds(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_image_add_box(struct ts_instance *self, struct tsim *sim);
enum ts_status ts_image_add_surfaces(struct ts_instance *self, struct tsim *sim);
/* After the picture is drawn. */
void ts_image_add_legends(struct ts_image *s);
/* In init: reads the words of the keywords mesh, voxel and wall. */
enum ts_status ts_image_read_surfaces(struct ts_instance *self, struct tsim *sim);
/* Colour of an element of a surface in the present frame. */
struct ts_colour ts_image_element_colour(const struct ts_image_surface *s, size_t element);
void ts_image_release_surfaces(struct ts_image *s);
/* Colour of a type of atoms or bonds. */
struct ts_colour ts_image_type_colour(const struct ts_image_types *types, double type);
/* 1, or that of dump_modify atrans. */
double ts_image_type_opacity(const struct ts_image_types *types, double type);
/* Diameter of a type; NaN: not set. */
double ts_image_type_diameter(const struct ts_image_types *types, double type);

/* ---- image_frame.c */

/* Directions, centre and scale of the camera at this step. *valid: the view is possible; if not, variables of the
 * script are the cause, and a warning has been given. */
enum ts_status ts_image_camera(struct ts_instance *self, struct tsim *sim, struct ts_camera *out,
			       bool *valid);
/* Draws the present state. *drawn: false if there is no valid view, or nothing in it (unless_empty). */
enum ts_status ts_image_draw(struct ts_instance *self, struct tsim *sim, bool *drawn);
void ts_image_release(struct ts_instance *self);

/* ---- image_price.c */

/* Memory of the pixels of a picture while it is drawn, bytes. */
double ts_image_memory(const struct ts_image *s);
/* At the first frame of a run: warns if it has very many, and how much they are, each of `bytes` (0: not told). */
void ts_image_warn_frames(struct ts_instance *self, struct tsim *sim, double bytes);

#endif
