#include "io/movie.h"

#include <errno.h>
#include <inttypes.h>
#include <string.h>

#include "base/files_peers.h"
#include "io/textfile.h"

#include "base/banned.h"

enum coding {
	PLANES,	   /* 4:2:0, which all players know */
	FEW_RATES, /* the same with the rates of television alone: MPEG-1 */
	PALETTE	   /* 256 colours for each frame */
};

static const struct format {
	const char *ending, *muxer;
	enum coding coding;
} formats[] = {
	{ ".mp4", "mp4", PLANES },	{ ".m4v", "mp4", PLANES },     { ".mov", "mov", PLANES },
	{ ".mkv", "matroska", PLANES }, { ".webm", "webm", PLANES },   { ".avi", "avi", PLANES },
	{ ".wmv", "asf", PLANES },	{ ".mpg", "mpeg", FEW_RATES }, { ".mpeg", "mpeg", FEW_RATES },
	{ ".gif", "gif", PALETTE },
};

static const struct format *format_of(const char *path)
{
	for (size_t k = 0; k < sizeof formats / sizeof *formats; k++)
		if (ts_ends_with(path, formats[k].ending))
			return &formats[k];
	return NULL;
}

bool ts_movie_is_name(const char *path)
{
	return format_of(path) != NULL;
}

const char *ts_movie_obstacle(struct tsim *sim)
{
	struct ts_str path = { 0 };
	bool found;

	if (ts_files_closed(&sim->files))
		return "movies are made by the program ffmpeg, and -sandbox allows no other programs";
	found = ts_process_find("ffmpeg", &path);
	ts_str_release(&path);
	return found ? NULL
		     : "movies are made by the program ffmpeg, which is not on the PATH: install it (apt-get "
		       "install ffmpeg), or write frames as pictures";
}

/* What ffmpeg has printed last. */
static const char *last_words(const struct ts_movie *m)
{
	return m->ffmpeg.said + strspn(m->ffmpeg.said, " ");
}

static enum ts_status report_failure(struct ts_movie *m, int status)
{
	const char *said = last_words(m);

	return ts_fail(&m->file.sim->error, TS_IO, &m->file.where,
		       "movie '%s': ffmpeg failed after %" PRId64 " frame%s with exit status %d%s%s",
		       ts_str_text(&m->file.path), m->frames, m->frames == 1 ? "" : "s", status,
		       *said ? ": " : ", without a message", said);
}

/* Filters: an even size, or a palette for each frame. */
static const char *filter_of(const struct ts_movie *m, const struct format *format, char *text, size_t n)
{
	const uint32_t right = m->width % 2, below = m->height % 2;

	if (format->coding == PALETTE)
		return "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1";
	snprintf(text, n,
		 "pad=%" PRIu32 ":%" PRIu32 ",fillborders=right=%" PRIu32 ":bottom=%" PRIu32 ":mode=smear",
		 m->width + right, m->height + below, right, below);
	return right || below ? text : "null";
}

/* Frames a second in the file; where it is more than the rate of the movie, frames are repeated. */
static double rate_in_file(const struct ts_movie *m, const struct format *format)
{
	static const double rates[] = { 24, 25, 30, 50, 60 };
	size_t k = 0;

	if (format->coding != FEW_RATES)
		return m->rate;
	while (k < 4 && rates[k] < m->rate)
		k++;
	return rates[k];
}

static int start_ffmpeg(struct ts_movie *m, const struct format *format, const char *file)
{
	char size[32], rate[32], own_rate[32], bits[32], filter[128];
	const char *words[40] = {
		"ffmpeg", "-nostdin",	 "-hide_banner", "-loglevel",
		"error",  "-f",		 "rawvideo",	 "-pixel_format",
		"rgb24",  "-video_size", size,		 "-framerate",
		rate,	  "-i",		 "pipe:0",	 "-an",
		"-r",	  own_rate,	 "-vf",		 filter_of(m, format, filter, sizeof filter)
	};
	size_t n = 20;

	snprintf(size, sizeof size, "%" PRIu32 "x%" PRIu32, m->width, m->height);
	snprintf(rate, sizeof rate, "%.9g", m->rate);
	snprintf(own_rate, sizeof own_rate, "%.9g", rate_in_file(m, format));
	snprintf(bits, sizeof bits, "%" PRId64 "k", m->bitrate);
	if (format->coding != PALETTE) {
		words[n++] = "-pix_fmt";
		words[n++] = "yuv420p";
	}
	if (m->bitrate > 0) {
		words[n++] = "-b:v";
		words[n++] = bits;
	}
	words[n++] = "-f";
	words[n++] = format->muxer;
	words[n++] = "-y";
	words[n++] = file;
	return ts_feed_start(&m->ffmpeg, words);
}

/* The absolute path of the file: the working folder may change before the movie is complete. */
static enum ts_status begin_file(struct ts_movie *m, struct tsim *sim, const struct ts_place *where,
				 const char *path)
{
	struct ts_str whole = { 0 };
	enum ts_status status = TS_OK;

	if (ts_files_resolve_name(path, &whole) != 0)
		status = ts_textfile_write_failed(&sim->error, &sim->files, where, path);
	else
		status = ts_replace_begin(&m->file, sim, where, ts_str_text(&whole));
	ts_str_release(&whole);
	return status;
}

static enum ts_status begin(struct ts_movie *m, struct tsim *sim, const struct ts_place *where,
			    const char *path)
{
	const struct format *format = format_of(path);
	const char *obstacle = ts_movie_obstacle(sim);
	struct ts_str file = { 0 };
	int code;

	if (!format)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "movie '%s': expected a name that ends in " TS_MOVIE_ENDINGS, path);
	if (obstacle)
		return ts_fail(&sim->error, TS_STATE, where, "movie '%s': %s", path, obstacle);
	TS_TRY(begin_file(m, sim, where, path));
	ts_str_addf(&file, "file:%s", ts_str_text(&m->file.temporary));
	code = file.failed ? ENOMEM : start_ffmpeg(m, format, ts_str_text(&file));
	ts_str_release(&file);
	if (!code)
		return TS_OK;
	ts_replace_abandon(&m->file);
	return ts_fail(&sim->error, TS_IO, where, "movie '%s': cannot start ffmpeg: %s", path,
		       strerror(code));
}

struct frame {
	struct ts_movie *movie;
	struct tsim *sim;
	const struct ts_place *where;
	const char *path;
	const unsigned char *rgb;
};

static int add(void *frame)
{
	const struct frame *f = frame;
	struct ts_movie *m = f->movie;

	if (m->frames == 0)
		TS_TRY(begin(m, f->sim, f->where, f->path));
	if (ts_feed_write(&m->ffmpeg, f->rgb, 3 * (size_t)m->width * m->height) != 0) {
		const enum ts_status status = report_failure(m, ts_feed_end(&m->ffmpeg));

		ts_movie_abandon(m);
		return status;
	}
	return TS_OK;
}

enum ts_status ts_movie_add(struct ts_movie *m, struct tsim *sim, const struct ts_place *where,
			    const char *path, uint32_t width, uint32_t height, const unsigned char *rgb)
{
	struct frame frame = { m, sim, where, path, rgb };
	enum ts_status status = TS_OK;

	if (m->frames == 0) {
		m->width = width;
		m->height = height;
	}
	if (width != m->width || height != m->height)
		return ts_fail(&sim->error, TS_STATE, where,
			       "movie '%s': a frame has %" PRIu32 " x %" PRIu32
			       " pixels, those before it %" PRIu32 " x %" PRIu32 ": end the dump before",
			       path, width, height, m->width, m->height);
	if (!sim->reading.explain)
		status = (enum ts_status)ts_peers_by_first(&sim->files, add, &frame);
	if (status != TS_OK && sim->error.status == TS_OK) /* it is another rank that writes */
		return ts_fail(&sim->error, status, where, "movie '%s': writing failed", path);
	m->frames += status == TS_OK;
	return status;
}

/* Some versions end with the exit status 0 though the disk was full ("Error writing trailer of ..."). */
static bool has_failed(const struct ts_movie *m, int status)
{
	return status != 0 || strstr(m->ffmpeg.said, "Error ");
}

static int end(void *movie)
{
	struct ts_movie *m = movie;
	enum ts_status status;
	int code = ts_feed_end(&m->ffmpeg);
	if (*last_words(m) && !has_failed(m, code))
		ts_warn(&m->file.sim->log, &m->file.where, "movie '%s': ffmpeg says: %s",
			ts_str_text(&m->file.path), last_words(m));
	status = has_failed(m, code) ? report_failure(m, code) : ts_replace_commit(&m->file, false);
	ts_movie_abandon(m);
	return status;
}

enum ts_status ts_movie_end(struct ts_movie *m)
{
	if (m->file.file)
		return (enum ts_status)ts_peers_apart(&m->file.sim->files, end, m);
	m->frames = 0;
	return TS_OK;
}

void ts_movie_abandon(struct ts_movie *m)
{
	ts_feed_kill(&m->ffmpeg);
	ts_replace_abandon(&m->file);
	m->frames = 0;
}
