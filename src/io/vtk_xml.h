/* Elements of XML files for VTK. Arrays are inline, divided into blocks that are compressed by zlib, in
 * base64: the layout of vtkZLibDataCompressor with 64-bit headers. If memory runs out in functions without
 * a status, out->failed is set. */
#ifndef TS_IO_VTK_XML_H
#define TS_IO_VTK_XML_H

#include "io/vtk.h"

/* The first two lines; `type`: "PolyData", "ImageData" ... */
void ts_vtk_add_opening(struct ts_str *out, const char *type);
void ts_vtk_add_time(struct ts_str *out, double time);
/* Names come from scripts: characters that need an escape in XML or JSON are replaced by `_`. */
void ts_vtk_add_name(struct ts_str *out, const char *name);

void ts_vtk_add_base64(struct ts_str *out, const unsigned char *bytes, size_t n);
/* Adds n bytes, compressed: header {number of blocks, size of a block, size of a partial last block,
 * compressed sizes ...} in base64, then all blocks in base64. Of several ranks, which all call it, those of the first one,
 * and nothing is added on the others, whose files are discarded. */
enum ts_status ts_vtk_add_packed(struct tsim *sim, struct ts_str *out, const void *data, size_t n);
/* Adds an array of n tuples of 8-byte numbers; `type`: "Float64" or "Int64". */
enum ts_status ts_vtk_add_array(struct tsim *sim, struct ts_str *out, const char *name, const char *type,
				size_t components, const void *data, size_t n);
/* Adds all arrays of an element, "PointData" or "CellData". */
enum ts_status ts_vtk_add_data(struct tsim *sim, struct ts_str *out, const char *element,
			       const struct ts_vtk_array *array, size_t narrays, size_t n);

#endif
