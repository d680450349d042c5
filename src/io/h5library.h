/* The HDF5 library, loaded when it is first used: with the libraries that it uses itself it takes some megabytes and a part of
 * the time of a start, and few runs write HDF5 files. Names of its functions and numbers stand for what has been loaded,
 * so calls are written as if it were linked. */
#ifndef TS_IO_H5LIBRARY_H
#define TS_IO_H5LIBRARY_H

#ifdef TS_WITH_HDF5
#include <hdf5.h>
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif
#include <stdbool.h>
#include <stddef.h>

/* Whether the library can be used. Else the reason is stored. */
bool ts_h5_loads(char *reason, size_t size);

#ifdef TS_HDF5_FILE /* the name of the shared library; not defined if it is linked */
typedef void ts_h5_fn(void);
/* A function of the library, or the address of an object of it; to be called only if the library loads. Each call
 * looks the name up, in about a microsecond. */
ts_h5_fn *ts_h5_function(const char *name);
const void *ts_h5_object(const char *name);

#define TS_H5_FUNCTION(name) ((__typeof__(&name))ts_h5_function(#name))
#define TS_H5_OBJECT(name) (*(const __typeof__(name) *)ts_h5_object(#name))
#define H5Aclose TS_H5_FUNCTION(H5Aclose)
#define H5Acreate2 TS_H5_FUNCTION(H5Acreate2)
#define H5Adelete TS_H5_FUNCTION(H5Adelete)
#define H5Aexists TS_H5_FUNCTION(H5Aexists)
#define H5Awrite TS_H5_FUNCTION(H5Awrite)
#define H5Dclose TS_H5_FUNCTION(H5Dclose)
#define H5Dcreate2 TS_H5_FUNCTION(H5Dcreate2)
#define H5Dget_space TS_H5_FUNCTION(H5Dget_space)
#define H5Dopen2 TS_H5_FUNCTION(H5Dopen2)
#define H5Dread TS_H5_FUNCTION(H5Dread)
#define H5Dset_extent TS_H5_FUNCTION(H5Dset_extent)
#define H5Dwrite TS_H5_FUNCTION(H5Dwrite)
#define H5Eclear2 TS_H5_FUNCTION(H5Eclear2)
#define H5Eget_auto2 TS_H5_FUNCTION(H5Eget_auto2)
#define H5Eset_auto2 TS_H5_FUNCTION(H5Eset_auto2)
#define H5Ewalk2 TS_H5_FUNCTION(H5Ewalk2)
#define H5FDregister TS_H5_FUNCTION(H5FDregister)
#define H5FDunregister TS_H5_FUNCTION(H5FDunregister)
#define H5Fclose TS_H5_FUNCTION(H5Fclose)
#define H5Fcreate TS_H5_FUNCTION(H5Fcreate)
#define H5Fflush TS_H5_FUNCTION(H5Fflush)
#define H5Fis_hdf5 TS_H5_FUNCTION(H5Fis_hdf5)
#define H5Fopen TS_H5_FUNCTION(H5Fopen)
#define H5Gclose TS_H5_FUNCTION(H5Gclose)
#define H5Gcreate2 TS_H5_FUNCTION(H5Gcreate2)
#define H5Gget_info TS_H5_FUNCTION(H5Gget_info)
#define H5Gopen2 TS_H5_FUNCTION(H5Gopen2)
#define H5Lcreate_hard TS_H5_FUNCTION(H5Lcreate_hard)
#define H5Lexists TS_H5_FUNCTION(H5Lexists)
#define H5Pclose TS_H5_FUNCTION(H5Pclose)
#define H5Pcreate TS_H5_FUNCTION(H5Pcreate)
#define H5Pget_driver_info TS_H5_FUNCTION(H5Pget_driver_info)
#define H5Pset_chunk TS_H5_FUNCTION(H5Pset_chunk)
#define H5Pset_deflate TS_H5_FUNCTION(H5Pset_deflate)
#define H5Pset_driver TS_H5_FUNCTION(H5Pset_driver)
#define H5Pset_fill_value TS_H5_FUNCTION(H5Pset_fill_value)
#define H5Pset_shuffle TS_H5_FUNCTION(H5Pset_shuffle)
#define H5Sclose TS_H5_FUNCTION(H5Sclose)
#define H5Screate TS_H5_FUNCTION(H5Screate)
#define H5Screate_simple TS_H5_FUNCTION(H5Screate_simple)
#define H5Sget_simple_extent_dims TS_H5_FUNCTION(H5Sget_simple_extent_dims)
#define H5Sget_simple_extent_ndims TS_H5_FUNCTION(H5Sget_simple_extent_ndims)
#define H5Sget_simple_extent_npoints TS_H5_FUNCTION(H5Sget_simple_extent_npoints)
#define H5Sselect_hyperslab TS_H5_FUNCTION(H5Sselect_hyperslab)
#define H5Tclose TS_H5_FUNCTION(H5Tclose)
#define H5Tcopy TS_H5_FUNCTION(H5Tcopy)
#define H5Tset_size TS_H5_FUNCTION(H5Tset_size)
#define H5Tset_strpad TS_H5_FUNCTION(H5Tset_strpad)
#define H5Zfilter_avail TS_H5_FUNCTION(H5Zfilter_avail)
#define H5check_version TS_H5_FUNCTION(H5check_version)
#define H5open TS_H5_FUNCTION(H5open)
#define H5P_CLS_DATASET_CREATE_ID_g TS_H5_OBJECT(H5P_CLS_DATASET_CREATE_ID_g)
#define H5P_CLS_FILE_ACCESS_ID_g TS_H5_OBJECT(H5P_CLS_FILE_ACCESS_ID_g)
#define H5T_C_S1_g TS_H5_OBJECT(H5T_C_S1_g)
#define H5T_IEEE_F64LE_g TS_H5_OBJECT(H5T_IEEE_F64LE_g)
#define H5T_NATIVE_DOUBLE_g TS_H5_OBJECT(H5T_NATIVE_DOUBLE_g)
#define H5T_NATIVE_INT64_g TS_H5_OBJECT(H5T_NATIVE_INT64_g)
#define H5T_NATIVE_INT_g TS_H5_OBJECT(H5T_NATIVE_INT_g)
#define H5T_NATIVE_UCHAR_g TS_H5_OBJECT(H5T_NATIVE_UCHAR_g)
#define H5T_STD_I32LE_g TS_H5_OBJECT(H5T_STD_I32LE_g)
#define H5T_STD_I64LE_g TS_H5_OBJECT(H5T_STD_I64LE_g)
#endif
#endif

#endif
