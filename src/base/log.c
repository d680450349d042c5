#include "base/log.h"

#include <errno.h>
#include <stdarg.h>
#include <string.h>

#include "base/banned.h"

static void hide_progress(struct ts_log *log)
{
	if (log->progress_shown)
		fputs("\r\033[K", log->screen);
	log->progress_shown = false;
}

void ts_log(struct ts_log *log, const char *format, ...)
{
	va_list args;

	if (log->screen) {
		hide_progress(log);
		va_start(args, format);
		vfprintf(log->screen, format, args);
		va_end(args);
	}
	if (log->file) {
		va_start(args, format);
		vfprintf(log->file, format, args);
		va_end(args);
	}
}

void ts_log_screen(struct ts_log *log, const char *format, ...)
{
	va_list args;

	if (!log->screen)
		return;
	hide_progress(log);
	va_start(args, format);
	vfprintf(log->screen, format, args);
	va_end(args);
}

void ts_log_file(struct ts_log *log, const char *format, ...)
{
	va_list args;

	if (!log->file)
		return;
	va_start(args, format);
	vfprintf(log->file, format, args);
	va_end(args);
}

void ts_warn(struct ts_log *log, const struct ts_place *place, const char *format, ...)
{
	char text[1024];
	va_list args;

	log->warnings++;
	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	if (place && place->line)
		ts_log(log, "%s:%d: ", place->file, place->line);
	ts_log(log, "warning: %s\n", text);
}

void ts_log_progress(struct ts_log *log, const char *text)
{
	if (!log->progress || !log->screen)
		return;
	hide_progress(log);
	if (*text) {
		fputs(text, log->screen);
		log->progress_shown = true;
	}
	fflush(log->screen);
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
	log->file = fopen(path, append ? "a" : "w");
	if (!log->file)
		return ts_fail(err, TS_IO, place, "cannot open log file '%s': %s", path,
			       strerror(errno));
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
