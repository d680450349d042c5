/* Pieces of XML files for VTK. Arrays are stored inline, cut into blocks, each compressed by zlib, in base64:
 * the layout of vtkZLibDataCompressor with 64-bit headers. Memory that runs out in functions without status
 * shows in out->failed. */
#ifndef TS_IO_VTK_XML_H
#define TS_IO_VTK_XML_H

#include "io/vtk.h"

/* The two first lines; `type`: "PolyData", "ImageData" ... */
void ts_vtk_add_opening(struct ts_str *out, const char *type);
void ts_vtk_add_time(struct ts_str *out, double time);
/* Names come from scripts: only characters that need no escape in XML or JSON. */
void ts_vtk_add_name(struct ts_str *out, const char *name);

/* n bytes: header {blocks, size of a block, size of a partial last block, compressed sizes...}, then all
 * blocks; each of the two in base64. */
enum ts_status ts_vtk_add_packed(struct tsim *sim, struct ts_str *out, const void *data, size_t n);
/* n tuples of numbers of 8 bytes; `type`: "Float64" or "Int64". */
enum ts_status ts_vtk_add_array(struct tsim *sim, struct ts_str *out, const char *name, const char *type,
				size_t components, const void *data, size_t n);
/* All arrays of an element, "PointData" or "CellData". */
enum ts_status ts_vtk_add_data(struct tsim *sim, struct ts_str *out, const char *element,
			       const struct ts_vtk_array *array, size_t narrays, size_t n);

#endif
