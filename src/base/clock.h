/* Wall time. */
#ifndef TS_BASE_CLOCK_H
#define TS_BASE_CLOCK_H

/* Seconds of wall time since an arbitrary start; never runs backwards. */
double ts_clock(void);

#endif
