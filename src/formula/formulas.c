#include "formula/formulas.h"

#include "base/banned.h"

enum ts_status ts_formulas_archive(struct ts_formulas *formulas, struct ts_archive *archive)
{
	TS_TRY(ts_random_streams_archive(formulas, archive));
	return ts_variables_archive(formulas, archive);
}

void ts_formulas_release(struct ts_formulas *formulas)
{
	ts_variables_release(formulas);
	ts_free(formulas->stream);
	ts_free(formulas->waiting);
	ts_map_release(&formulas->waiting_at);
}
