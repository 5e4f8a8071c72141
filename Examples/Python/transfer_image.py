#!/usr/bin/env python3
"""Mesh a label of a NIfTI file and take an image of the same patient onto its cells.

Usage: transfer_image.py LABELS.nii.gz IMAGE.nii.gz MEANS.npy [LABEL]. Needs nibabel, numpy and the installed package moserhex.

MEANS.npy holds one number a cell, [i, j, k]: rows of the same index are the same place in every patient.
"""

import sys

import nibabel
import numpy

import moserhex

if len(sys.argv) not in (4, 5):
    sys.exit(__doc__)
labels_file, image_file, means_file = sys.argv[1:4]
label = int(sys.argv[4]) if len(sys.argv) == 5 else None

labels = nibabel.load(labels_file)
image = nibabel.load(image_file)
try:
    mesh = moserhex.mesh(numpy.asanyarray(labels.dataobj), labels.affine, label=label)
    means = mesh.cell_means(image.get_fdata(), image.affine)
except moserhex.Error as error:
    sys.exit(f"{error} [{error.code}]")
for warning in mesh.warnings:
    print("warning:", warning, file=sys.stderr)
numpy.save(means_file, means)
print(f"{means.size} cells, mean {numpy.nanmean(means):.6g}, {numpy.isnan(means).sum()} of them beyond the image")
