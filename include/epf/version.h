/* SPDX-License-Identifier: MIT */
/**
 * @file version.h
 * The version of the library, following semantic versioning. CMake reads it from here.
 */
#ifndef EPF_VERSION_H
#define EPF_VERSION_H

#define EPF_VERSION_MAJOR 0
#define EPF_VERSION_MINOR 1
#define EPF_VERSION_PATCH 0

#endif
