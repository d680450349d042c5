/* Mathematical constants. */
#ifndef TS_MATH_CONSTANTS_H
#define TS_MATH_CONSTANTS_H

#define TS_PI 3.14159265358979323846

#endif
