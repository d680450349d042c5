/* Movies: pictures that the program ffmpeg, which must be on the PATH, encodes while they are made. It is started directly,
 * without a shell, and reads the pixels from a pipe; it writes only to the file that is named.
 *
 * The file is written under a temporary name and appears when the movie is complete. */
#ifndef TS_IO_MOVIE_H
#define TS_IO_MOVIE_H

#include "base/process.h"
#include "io/replace.h"

/* Zero-initialise, then set `rate` and perhaps `bitrate`. */
struct ts_movie {
	double rate;	 /* frames a second of the movie */
	int64_t bitrate; /* kbit/s; 0: what the encoder chooses */
	/* set by these functions */
	uint32_t width, height; /* of all frames, pixels */
	int64_t frames;
	struct ts_feed ffmpeg;
	struct ts_replace file;
};

/* Whether the ending of the name is that of a movie (mp4, mkv, avi ...), and the list of them for messages. */
bool ts_movie_is_name(const char *path);
#define TS_MOVIE_ENDINGS ".mp4, .m4v, .mov, .mkv, .webm, .avi, .wmv, .mpg, .mpeg or .gif"

/* Why no movie can be made here: there is no ffmpeg, or -sandbox is on. NULL: it can. */
const char *ts_movie_obstacle(struct tsim *sim);

/* Adds a frame; rgb as for ts_png_write. The first one starts ffmpeg, the others must have its size. Fails with the words of
 * ffmpeg if that has ended, e.g. as the disk is full. With -explain nothing is started. A widths or height that is odd is
 * made even by repeating the last column or row, since most codecs need that. */
enum ts_status ts_movie_add(struct ts_movie *movie, struct tsim *sim, const struct ts_place *where,
			    const char *path, uint32_t width, uint32_t height, const unsigned char *rgb);
/* Completes the file. Fails if ffmpeg does not succeed; then there is no file. No effect without frames. */
enum ts_status ts_movie_end(struct ts_movie *movie);
/* Ends without a file. No effect after ts_movie_end. */
void ts_movie_abandon(struct ts_movie *movie);

#endif
