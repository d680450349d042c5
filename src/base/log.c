#include "base/log.h"

#include <errno.h>
#include <stdarg.h>
#include <string.h>
#include <sys/ioctl.h>

#include "base/clock.h"
#include "base/mkdirs.h"
#include "base/str.h"

#include "base/banned.h"

/* Output less than BURST seconds after the last is part of it. */
static void note_output(struct ts_log *log)
{
	static const double BURST = 1;
	double now;

	if (!log->progress)
		return;
	now = ts_clock();
	if (now - log->spoke > BURST)
		log->seldom = log->spoke > 0 && now - log->spoke > log->patience;
	log->spoke = now;
}

static void erase_progress_line(struct ts_log *log)
{
	if (log->progress_shown)
		fputs("\r\033[K", log->screen);
	log->progress_shown = false;
}

static void record_write_error(struct ts_log *log)
{
	if (!log->trouble)
		log->trouble = errno ? errno : EIO;
}

static void call_back(struct ts_log *log, enum ts_log_level level, const char *text)
{
	if (log->sink && level != TS_LOG_SETTING)
		log->sink(log->sink_data, level, text);
	if (log->copy && level != TS_LOG_PROGRESS)
		log->copy(log->copy_data, level, text);
}

static void call_back_formatted(struct ts_log *log, const char *format, va_list args)
{
	struct ts_str text = { 0 };
	va_list again;

	va_copy(again, args);
	ts_str_vaddf(&text, format, again);
	va_end(again);
	call_back(log, TS_LOG_TEXT, ts_str_text(&text));
	ts_str_release(&text);
}

static void write_to_streams(struct ts_log *log, bool screen, bool file, const char *format, va_list args)
{
	va_list again;

	if (log->quiet)
		return;
	if (screen && (log->sink || log->copy))
		call_back_formatted(log, format, args);
	if (screen && log->screen) {
		note_output(log);
		erase_progress_line(log);
		va_copy(again, args);
		if (vfprintf(log->screen, format, again) < 0)
			record_write_error(log);
		va_end(again);
	}
	if (file && log->file && vfprintf(log->file, format, args) < 0)
		record_write_error(log);
}

void ts_log(struct ts_log *log, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	write_to_streams(log, true, true, format, args);
	va_end(args);
}

void ts_log_screen(struct ts_log *log, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	write_to_streams(log, true, false, format, args);
	va_end(args);
}

void ts_log_file(struct ts_log *log, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	write_to_streams(log, false, true, format, args);
	va_end(args);
}

static bool keeps_settings(const struct ts_log *log)
{
	return log->file && log->echo_file && !log->quiet;
}

bool ts_log_wants_settings(const struct ts_log *log)
{
	return keeps_settings(log) || log->copy;
}

void ts_log_setting(struct ts_log *log, const char *line)
{
	if (keeps_settings(log))
		ts_log_file(log, "%s\n", line);
	call_back(log, TS_LOG_SETTING, line);
}

void ts_warn(struct ts_log *log, const struct ts_place *place, const char *format, ...)
{
	ts_log_sink_fn *sink = log->sink, *copy = log->copy;
	bool quiet = log->quiet;
	char where[256] = "", text[1024 + sizeof where];
	size_t n;
	va_list args;

	if (log->withholds) {
		log->withheld++;
		return;
	}
	if (log->doubts && place && log->doubts(log->doubts_data, place))
		return;
	log->warnings++;
	if (place && place->line)
		snprintf(where, sizeof where, "%s:%d: ", place->file, place->line);
	n = (size_t)snprintf(text, sizeof text, "%swarning: ", where);
	va_start(args, format);
	vsnprintf(text + n, sizeof text - n, format, args);
	va_end(args);
	if (log->warned)
		ts_str_addf(log->warned, "%s\n", text);
	log->sink = log->copy = NULL; /* the callbacks get the warning once, below, with its level */
	log->quiet = false;
	ts_log(log, "%s\n", text);
	log->sink = sink;
	log->copy = copy;
	log->quiet = quiet;
	call_back(log, TS_LOG_WARNING, text);
}

void ts_log_progress(struct ts_log *log, const char *text)
{
	if (*text)
		call_back(log, TS_LOG_PROGRESS, text);
	if (!log->progress || !log->screen)
		return;
	erase_progress_line(log);
	if (*text) {
		fputs(text, log->screen);
		log->progress_shown = true;
	}
	fflush(log->screen);
}

void ts_log_fatal(struct ts_log *log, const char *text)
{
	ts_log_progress(log, "");
	fflush(stdout);
	fputs(text, stderr);
	ts_log_file(log, "%s", text);
	if (log->file)
		fflush(log->file);
}

bool ts_log_shows_progress(const struct ts_log *log)
{
	return log->progress && log->screen && !log->quiet &&
	       (log->seldom || ts_clock() - log->spoke >= log->patience);
}

int ts_log_width(const struct ts_log *log)
{
	struct winsize size;

	if (log->screen && ioctl(fileno(log->screen), TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
		return size.ws_col;
	return 80;
}

static void flush_stream(struct ts_log *log, FILE *stream)
{
	if (stream && fflush(stream) != 0)
		record_write_error(log);
}

enum ts_status ts_log_flush(struct ts_log *log, struct ts_error *err)
{
	flush_stream(log, log->file);
	flush_stream(log, log->screen);
	return ts_log_check(log, err);
}

enum ts_status ts_log_check(const struct ts_log *log, struct ts_error *err)
{
	const char *reason;

	errno = log->trouble ? log->trouble : EIO;
	reason = ts_files_why(log->files);
	if (log->file && ferror(log->file))
		return ts_fail(err, TS_IO, NULL, "writing the log file failed: %s", reason);
	if (log->screen && ferror(log->screen))
		return ts_fail(err, TS_IO, NULL, "writing to the screen failed: %s", reason);
	return TS_OK;
}

void ts_log_echo(struct ts_log *log, const char *line)
{
	if (log->echo_screen)
		ts_log_screen(log, "%s\n", line);
	if (log->echo_file)
		ts_log_file(log, "%s\n", line);
}

enum ts_status ts_log_open(struct ts_log *log, struct ts_error *err, const struct ts_place *place,
			   const char *path, bool append)
{
	TS_TRY(ts_log_close(log, err));
	if (!path)
		return TS_OK;
	ts_mkdirs_for(log->files, path); /* a failure is reported by the following open */
	log->file = ts_files_open(log->files, path, append ? "a" : "w");
	if (!log->file)
		return ts_fail(err, TS_IO, place, "cannot open log file '%s': %s", path,
			       ts_files_why(log->files));
	return TS_OK;
}

enum ts_status ts_log_close(struct ts_log *log, struct ts_error *err)
{
	FILE *file = log->file;
	int bad;

	log->file = NULL;
	if (!file)
		return TS_OK;
	bad = ferror(file);
	bad |= fclose(file);
	if (bad)
		return ts_fail(err, TS_IO, NULL, "the log file is incomplete: %s", strerror(errno));
	return TS_OK;
}
